// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "track_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/csv_rows.hpp"
#include "ocean/internal/platform.hpp"
#include "toml_text.hpp"

namespace ocean {
namespace {

constexpr std::string_view kForms = "time,x,y or time,x,y,heading,speed or x,y,speed";

/// The columns of a file, by their titles.
enum TrackColumn { kTime, kX, kY, kHeading, kSpeed, kColumns };
struct ColumnTitle {
    std::string_view name;
    std::string_view unit;
};
constexpr std::array<ColumnTitle, kColumns> kTitles = {
    {{"time", "s"}, {"x", "m"}, {"y", "m"}, {"heading", "deg"}, {"speed", "m/s"}}};

class TrackReader {
  public:
    TrackReader(std::string_view content, const std::string& name) : table_(content, name) {
        if (table_.titles().empty()) {
            throw text::error_at(
                ErrorKind::bad_file, name, 0,
                "has no rows: the first line names the columns " + std::string(kForms));
        }
        find_columns();
    }

    HullTrack read() {
        HullTrack track;
        while (table_.next()) {
            if (track.rows.size() == kMaxTrackRows) {
                throw table_.lines().fail("more than the " + std::to_string(kMaxTrackRows) +
                                          " rows allowed; a row for each second is plenty");
            }
            if (has(kTime)) {
                track.rows.push_back({number(kTime), number(kX), number(kY)});
                if (has(kSpeed)) track.courses.push_back({number(kHeading), number(kSpeed)});
            } else {
                add_way_point(track);
            }
        }
        return track;
    }

  private:
    bool has(TrackColumn column) const { return places_[column].has_value(); }

    void find_columns() {
        for (std::size_t i = 0; i < table_.titles().size(); ++i) {
            const csv::Title title = csv::parse_title(table_.titles()[i]);
            const auto known = std::ranges::find(kTitles, title.name, &ColumnTitle::name);
            if (known == kTitles.end()) {
                throw table_.lines().fail("the column " + text::printable(title.name, 30) +
                                          " is unknown; allowed: " + std::string(kForms));
            }
            if (!title.unit.empty() && title.unit != known->unit) {
                throw table_.lines().fail("the unit '" + text::printable(title.unit, 30) + "' of " +
                                          title.name +
                                          " is unknown; allowed: " + std::string(known->unit));
            }
            auto& place = places_[static_cast<std::size_t>(known - kTitles.begin())];
            if (place) throw table_.lines().fail("the column " + title.name + " is repeated");
            place = i;
        }
        const bool places = has(kX) && has(kY);
        const bool by_time = has(kTime) && has(kHeading) == has(kSpeed);
        const bool by_speed = !has(kTime) && has(kSpeed) && !has(kHeading);
        if (places && (by_time || by_speed)) return;
        throw table_.lines().fail("the columns are no track; allowed: " + std::string(kForms));
    }

    double number(TrackColumn column) {
        const std::optional<double> number = table_.number(*places_[column]);
        if (number && std::isfinite(*number)) return *number;
        throw table_.lines().fail(std::string(kTitles[column].name) + " = '" +
                                  text::printable(table_.cell(*places_[column]), 30) +
                                  "'; allowed is a number of " + std::string(kTitles[column].unit));
    }

    /// The speed changes evenly from one way point to the next.
    void add_way_point(HullTrack& track) {
        const double x = number(kX), y = number(kY), speed = number(kSpeed);
        if (!(speed >= 0.0)) throw table_.lines().fail("the speed of a way point is below 0");
        double time = 0.0;
        if (!track.rows.empty()) {
            const TrackRow& before = track.rows.back();
            const double way = std::hypot(x - before.x, y - before.y);
            if (!(speed + speed_before_ > 0.0)) {
                throw table_.lines().fail(
                    "the way point is never reached: its speed and that of the one before are 0");
            }
            time = before.time + 2.0 * way / (speed + speed_before_);
        }
        track.rows.push_back({time, x, y});
        speed_before_ = speed;
    }

    csv::TableReader table_;
    std::array<std::optional<std::size_t>, kColumns> places_;
    double speed_before_ = 0.0;
};

std::string row_text(std::span<const double> values) {
    std::string out = "    [";
    for (std::size_t i = 0; i < values.size(); ++i) {
        out += (i == 0 ? "" : ", ") + toml_number(values[i]);
    }
    return out + "],\n";
}

HullTrack plain_track(const std::string& content, const Hull& hull, const std::string& path) {
    if (hull.origin.empty() && hull.origin_time.empty()) return parse_track(content, path);
    throw Error(ErrorKind::invalid_value,
                path + ": origin and origin_time belong to a GPX track, and this is a CSV file");
}

}  // namespace

HullTrack placed_track(const std::vector<GpxPoint>& points, const Hull& hull,
                       const std::string& name) {
    const GpxPoint& first = points.front();
    const bool is_place = hull.origin.size() == 2 && std::abs(hull.origin[0]) <= 90.0;
    if (!is_place) {
        throw Error(ErrorKind::invalid_value,
                    name +
                        ": a GPX track needs origin = [latitude, longitude], the place of (0, 0) "
                        "in degrees; its first point is at [" +
                        toml_number(first.latitude) + ", " + toml_number(first.longitude) + "]");
    }
    const std::optional<double> start =
        hull.origin_time.empty() ? first.time : parse_gpx_time(hull.origin_time);
    if (!start) {
        throw Error(ErrorKind::invalid_value,
                    name + ": " + not_a_time("origin_time", hull.origin_time));
    }
    return track_of(points, {hull.origin[0], hull.origin[1]}, *start, name);
}

HullTrack parse_track(std::string_view content, const std::string& name) {
    return TrackReader(content, name).read();
}

HullTrack read_track_rows(const TomlEntry& entry, const std::string& name) {
    const auto refuse = [&](const std::string& what) {
        throw Error(ErrorKind::invalid_value,
                    {.what = what,
                     .parameter = name,
                     .value = shown(*entry.node),
                     .allowed = "rows [time, x, y] or [time, x, y, heading, speed]"});
    };
    const toml::array* const rows = entry.node->as_array();
    if (rows == nullptr) refuse("is no track");
    if (rows->size() > kMaxTrackRows) {
        refuse("has more than the " + std::to_string(kMaxTrackRows) + " rows allowed");
    }
    HullTrack track;
    std::size_t columns = 0;
    for (const toml::node& node : *rows) {
        const std::string row = "row " + std::to_string(track.rows.size() + 1);
        const toml::array* const cells = node.as_array();
        if (cells == nullptr || (cells->size() != 3 && cells->size() != 5)) {
            refuse(row + " is " + shown(node));
        }
        if (columns != 0 && cells->size() != columns) {
            refuse(row + " has " + std::to_string(cells->size()) + " numbers, the first has " +
                   std::to_string(columns));
        }
        columns = cells->size();
        std::array<double, 5> values{};
        for (std::size_t i = 0; i < columns; ++i) {
            const std::optional<double> number = number_of((*cells)[i]);
            if (!number) refuse(row + " holds " + shown((*cells)[i]) + ", no number");
            values[i] = *number;
        }
        track.rows.push_back({values[0], values[1], values[2]});
        if (columns == 5) track.courses.push_back({values[3], values[4]});
    }
    return track;
}

void resolve_track(Hull& hull, std::size_t number, const std::string& base_dir) {
    if (hull.track != nullptr || hull.track_file.empty()) return;
    const std::string path = text::to_utf8(utf8_path(base_dir) / utf8_path(hull.track_file));
    const std::string name = "hulls." + std::to_string(number) + ".track_file";
    try {
        const std::string content = text::read_file(path, kMaxTrackBytes);
        auto track = std::make_shared<const HullTrack>(
            is_xml(content) ? placed_track(parse_gpx(content, path), hull, path)
                            : plain_track(content, hull, path));
        require_track(*track, path);
        hull.track = std::move(track);
    } catch (const Error& error) {
        throw text::error_of_text(error, name, hull.track_file);
    }
}

std::string track_text(const Hull& hull) {
    if (hull.track == nullptr) return "";
    const HullTrack& track = *hull.track;
    std::string out = std::string(kTrackKey) + " = [\n";
    for (std::size_t i = 0; i < track.rows.size(); ++i) {
        const auto& [time, x, y] = track.rows[i];
        if (track.courses.empty()) {
            out += row_text(std::array{time, x, y});
        } else {
            const auto& [heading, speed] = track.courses[i];
            out += row_text(std::array{time, x, y, heading, speed});
        }
    }
    return out + "]\n";
}

}  // namespace ocean
