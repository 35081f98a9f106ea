// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "gpx_track.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>

#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/hull_rules.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/internal/utc_time.hpp"

namespace ocean {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";

/// Returns the text without blanks and line ends around it.
std::string_view stripped(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
    return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

/// Reads the elements of an XML text without a document type, whose entities could grow.
class XmlElements {
  public:
    enum class Kind { begin, end };

    XmlElements(std::string_view content, const std::string& name)
        : content_(content), name_(name) {}

    /// Goes to the next tag; an empty element has two. Returns false at the end of the text.
    bool next() {
        if (is_empty_) {
            is_empty_ = false;
            kind_ = Kind::end;
            open_.pop_back();
            return true;
        }
        const std::size_t text_begin = at_;
        std::size_t tag = 0;
        while (true) {
            tag = content_.find('<', at_);
            if (tag == std::string_view::npos) {
                if (open_.empty()) return false;
                throw fail("ends within <" + text::printable(open_.back(), 30) + ">");
            }
            if (!skip(tag, "<?", "?>") && !skip(tag, "<!--", "-->")) break;
        }
        text_ = content_.substr(text_begin, tag - text_begin);
        at_ = tag + 1;
        if (content_.substr(at_, 1) == "!") {
            throw fail("has a document type or marked text, which no GPX file needs");
        }
        read_tag();
        return true;
    }

    Kind kind() const { return kind_; }
    /// Returns the name of the tag without its namespace.
    std::string_view element() const { return element_; }
    /// Returns the text between this tag and the one before it.
    std::string_view text() const { return text_; }
    std::size_t depth() const { return open_.size(); }

    std::optional<std::string_view> attribute(std::string_view wanted) const {
        std::string_view rest = attributes_;
        while (true) {
            const std::size_t equals = rest.find('=');
            if (equals == std::string_view::npos) return std::nullopt;
            const std::string_view key = stripped(rest.substr(0, equals));
            rest = stripped(rest.substr(equals + 1));
            const std::size_t close = rest.empty() || (rest[0] != '"' && rest[0] != '\'')
                                          ? std::string_view::npos
                                          : rest.find(rest[0], 1);
            if (close == std::string_view::npos) return std::nullopt;
            if (key == wanted) return rest.substr(1, close - 1);
            rest = rest.substr(close + 1);
        }
    }

    Error fail(const std::string& message) const {
        const auto before = content_.substr(0, std::min(at_, content_.size()));
        const auto line = 1 + static_cast<std::size_t>(std::ranges::count(before, '\n'));
        return text::error_at(ErrorKind::bad_file, name_, line, message);
    }

  private:
    /// Skips a part that begins at `tag` with `open`. Returns false for other parts.
    bool skip(std::size_t tag, std::string_view open, std::string_view close) {
        if (content_.substr(tag, open.size()) != open) return false;
        const std::size_t end = content_.find(close, tag + open.size());
        if (end == std::string_view::npos) {
            throw fail("has " + std::string(open) + " without " + std::string(close));
        }
        at_ = end + close.size();
        return true;
    }

    void read_tag() {
        // A value in quotes may hold '>'.
        std::size_t end = at_;
        for (char quote = 0; end < content_.size(); ++end) {
            const char c = content_[end];
            if (quote == 0 && c == '>') break;
            if (quote == 0 && (c == '"' || c == '\'')) {
                quote = c;
            } else if (c == quote) {
                quote = 0;
            }
        }
        if (end == content_.size()) throw fail("has a tag without its '>'");
        std::string_view tag = content_.substr(at_, end - at_);
        kind_ = tag.starts_with("/") ? Kind::end : Kind::begin;
        if (kind_ == Kind::end) tag.remove_prefix(1);
        is_empty_ = kind_ == Kind::begin && tag.ends_with("/");
        if (is_empty_) tag.remove_suffix(1);
        const std::string_view full = tag.substr(0, tag.find_first_of(kBlanks));
        attributes_ = tag.substr(full.size());
        element_ = full.substr(full.rfind(':') + 1);
        if (kind_ == Kind::begin) {
            constexpr std::size_t kMaxDepth = 64;
            if (element_.empty() || open_.size() == kMaxDepth) {
                throw fail("is no GPX: a tag has no name, or elements lie too deep in each other");
            }
            open_.push_back(full);
        } else if (open_.empty() || open_.back() != full) {
            throw fail("</" + text::printable(full, 30) + "> closes no element that is open");
        } else {
            open_.pop_back();
        }
        at_ = end + 1;
    }

    std::string_view content_;
    const std::string& name_;
    std::size_t at_ = 0;
    Kind kind_ = Kind::begin;
    bool is_empty_ = false;  // the tag begins and ends an element
    std::string_view element_, attributes_, text_;
    std::vector<std::string_view> open_;  // full names
};

class GpxReader {
  public:
    GpxReader(std::string_view content, const std::string& name) : xml_(content, name) {}

    std::vector<GpxPoint> read() {
        using Kind = XmlElements::Kind;
        if (!xml_.next() || xml_.element() != "gpx") {
            throw xml_.fail("is no GPX: the first element is not <gpx>");
        }
        while (xml_.next()) {
            const bool begins = xml_.kind() == Kind::begin;
            if (xml_.element() == "trkpt") {
                begins ? begin_point() : end_point();
            } else if (in_point_ && xml_.element() == "time" && !begins && xml_.depth() == depth_) {
                read_time();
            }
        }
        if (points_.empty()) {
            throw xml_.fail("has no track points <trkpt lat=\"\" lon=\"\"> with a <time>");
        }
        return std::move(points_);
    }

  private:
    std::string point() const { return "point " + std::to_string(points_.size()) + ": "; }

    double degrees(std::string_view key, double limit) {
        const std::string_view text = xml_.attribute(key).value_or("");
        const std::optional<double> number = text::parse_number(text);
        if (number && std::abs(*number) <= limit) return *number;
        const std::string bound = significant_text(limit, 3);
        throw xml_.fail(point() + std::string(key) + " = '" + text::printable(text, 30) +
                        "'; allowed are -" + bound + " .. " + bound + " degrees");
    }

    void begin_point() {
        if (points_.size() == kMaxTrackRows) {
            throw xml_.fail("more than the " + std::to_string(kMaxTrackRows) +
                            " points allowed; a point for each second is plenty");
        }
        points_.emplace_back();
        points_.back().latitude = degrees("lat", 90.0);
        points_.back().longitude = degrees("lon", 180.0);
        in_point_ = true;
        has_time_ = false;
        depth_ = xml_.depth();
    }

    void read_time() {
        const std::string_view text = stripped(xml_.text());
        const std::optional<double> time = parse_gpx_time(text);
        if (!time) throw xml_.fail(point() + not_a_time("time", text));
        points_.back().time = *time;
        has_time_ = true;
    }

    void end_point() {
        if (!has_time_) throw xml_.fail(point() + "has no <time>");
        in_point_ = false;
    }

    XmlElements xml_;
    std::vector<GpxPoint> points_;
    bool in_point_ = false;
    bool has_time_ = false;
    std::size_t depth_ = 0;  // of the elements within a point
};

/// Returns a place of WGS84 from the Earth's centre [m].
std::array<double, 3> from_centre(double latitude, double longitude) {
    constexpr double kEquator = 6378137.0;           // [m]
    constexpr double kSquareOfE = 6.69437999014e-3;  // of the ellipsoid's eccentricity
    const double sine = std::sin(latitude);
    const double normal = kEquator / std::sqrt(1.0 - kSquareOfE * sine * sine);
    const double across = normal * std::cos(latitude);
    return {across * std::cos(longitude), across * std::sin(longitude),
            normal * (1.0 - kSquareOfE) * sine};
}

/// Returns the number at the front of `text`, which it removes; nothing unless it has so many
/// digits and `after` follows.
std::optional<int> take_number(std::string_view& text, std::size_t digits, std::string_view after) {
    int number = 0;
    const char* const end = text.data() + std::min(digits, text.size());
    const auto [read, code] = std::from_chars(text.data(), end, number);
    if (code != std::errc() || read != text.data() + digits || number < 0) return std::nullopt;
    text.remove_prefix(digits);
    if (!text.starts_with(after)) return std::nullopt;
    text.remove_prefix(after.size());
    return number;
}

/// Returns the minutes of a zone, "Z" or "+02:00"; nothing for other texts.
std::optional<int> zone_minutes(std::string_view zone) {
    if (zone.empty() || zone == "Z") return 0;
    const int sign = zone[0] == '+' ? 1 : -1;
    if (zone[0] != '+' && zone[0] != '-') return std::nullopt;
    zone.remove_prefix(1);
    const auto hours = take_number(zone, 2, ":");
    const auto minutes = take_number(zone, 2, "");
    if (!hours || !minutes || !zone.empty() || *hours > 24 || *minutes > 59) return std::nullopt;
    return sign * (60 * *hours + *minutes);
}

}  // namespace

bool is_xml(std::string_view content) {
    if (content.starts_with("\xEF\xBB\xBF")) content.remove_prefix(3);
    return stripped(content.substr(0, 256)).starts_with("<");
}

std::vector<GpxPoint> parse_gpx(std::string_view content, const std::string& name) {
    return GpxReader(content, name).read();
}

std::optional<double> parse_gpx_time(std::string_view text) {
    std::string_view rest = text;
    const auto year = take_number(rest, 4, "-");
    const auto month = take_number(rest, 2, "-");
    const auto day = take_number(rest, 2, "T");
    const auto hour = take_number(rest, 2, ":");
    const auto minute = take_number(rest, 2, ":");
    const std::string_view digits = rest.substr(0, rest.find_first_not_of("0123456789."));
    const auto seconds = text::parse_number(digits);
    const auto zone = zone_minutes(rest.substr(digits.size()));
    const UtcTime date{year.value_or(0), month.value_or(0), day.value_or(0), hour.value_or(24),
                       minute.value_or(60)};
    if (!date.valid() || !seconds || !(*seconds < 61.0) || !zone) return std::nullopt;
    return 60.0 * static_cast<double>(date.minutes() - *zone) + *seconds;
}

std::string not_a_time(std::string_view key, std::string_view text) {
    return std::string(key) + " = '" + text::printable(text, 40) +
           "'; allowed is such as 2026-05-01T10:00:03Z";
}

HullTrack track_of(const std::vector<GpxPoint>& points, const GpxPoint& origin, double start,
                   const std::string& name) {
    constexpr double kMaxDistance = 1e5;  // [m]
    const double latitude = origin.latitude * kTwoPi / 360.0;
    const double longitude = origin.longitude * kTwoPi / 360.0;
    const std::array<double, 3> zero = from_centre(latitude, longitude);
    HullTrack track;
    for (const GpxPoint& point : points) {
        std::array<double, 3> d =
            from_centre(point.latitude * kTwoPi / 360.0, point.longitude * kTwoPi / 360.0);
        for (std::size_t i = 0; i < 3; ++i) d[i] -= zero[i];
        const double away = std::cos(longitude) * d[0] + std::sin(longitude) * d[1];
        const double east = std::cos(longitude) * d[1] - std::sin(longitude) * d[0];
        const double north = std::cos(latitude) * d[2] - std::sin(latitude) * away;
        const double distance = std::hypot(d[0], d[1], d[2]);
        if (distance > kMaxDistance) {
            throw Error(ErrorKind::invalid_value,
                        name + ": point " + std::to_string(track.rows.size() + 1) + " is " +
                            fixed_text(1e-3 * distance, 0) +
                            " km from the origin; allowed: at most 100 km");
        }
        track.rows.push_back({point.time - start, east, north});
    }
    return track;
}

}  // namespace ocean
