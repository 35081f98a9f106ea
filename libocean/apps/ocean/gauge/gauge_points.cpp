// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See gauge_points.hpp.
#include "gauge_points.hpp"

#include <unordered_map>

#include "ocean/error.hpp"
#include "ocean/internal/text.hpp"
#include "point_table.hpp"

namespace ocean::app {
namespace {

class GaugeReader {
  public:
    GaugeReader(const std::string& path, double from, double to, double depth)
        : path_(path), from_(from), to_(to), depth_(depth), table_(read_points(path, columns())) {}

    GaugePoints read() {
        if (table_.size() == 0) throw fail("the table has no points");
        if (tracks() && (table_.has("velocity_x") || table_.has("velocity_y"))) {
            throw fail("a gauge has a velocity or the times of a track, not both");
        }
        for (std::size_t row = 0; row < table_.size(); ++row) add(row);
        if (tracks()) {
            for (const Gauge& gauge : gauges_) check_track(gauge);
        }
        return {std::move(gauges_), table_.left_out()};
    }

  private:
    static std::vector<PointColumn> columns() {
        using enum PointColumn::Kind;
        return {{"x", needed, "m"},
                {"y", needed, "m"},
                {"z", optional, "m"},
                {"velocity_x", optional, "m/s"},
                {"velocity_y", optional, "m/s"},
                {"time", optional, "s"},
                {"name", text}};
    }

    bool tracks() const { return table_.has("time"); }

    Error fail(const std::string& message) const {
        return {ErrorKind::bad_file, (path_ == "-" ? "standard input" : path_) + ": " + message};
    }

    double number(const char* column, std::size_t row) const {
        return table_.has(column) ? table_.numbers(column)[row] : 0.0;
    }

    std::string name_of(std::size_t row) const {
        if (table_.has("name")) return table_.texts("name")[row];
        return tracks() ? "1" : std::to_string(row + 1);
    }

    void add(std::size_t row) {
        const std::string name = name_of(row);
        const auto [known, is_new] = index_.try_emplace(name, gauges_.size());
        if (is_new) {
            gauges_.push_back({name, {}, number("velocity_x", row), number("velocity_y", row)});
        } else if (!tracks()) {
            throw fail("the name '" + name +
                       "' is repeated; the rows of a track need a column time");
        }
        Gauge& gauge = gauges_[known->second];
        const double time = tracks() ? number("time", row) : from_;
        if (!gauge.track.empty() && !(time > gauge.track.back().time)) {
            throw fail(
                "the times of '" + name +
                format_text("' must increase: %g follows %g", time, gauge.track.back().time));
        }
        gauge.track.push_back({time, {number("x", row), number("y", row), depth_of(name, row)}});
    }

    double depth_of(const std::string& name, std::size_t row) const {
        const double z = number("z", row);
        if (z <= 0.0 && z >= -depth_) return z;
        throw fail(
            format_text("z = %g of '%s'; allowed is a height from still water down to the "
                        "bottom, 0 .. %g m",
                        z, name.c_str(), -depth_));
    }

    void check_track(const Gauge& gauge) const {
        const double first = gauge.track.front().time;
        const double last = gauge.track.back().time;
        if (first <= from_ && to_ <= last) return;
        throw fail(
            format_text("the track of '%s' covers the times %g .. %g s, not all of the "
                        "record's %g .. %g s",
                        gauge.name.c_str(), first, last, from_, to_));
    }

    std::string path_;
    double from_;
    double to_;
    double depth_;
    PointTable table_;
    std::vector<Gauge> gauges_;
    std::unordered_map<std::string, std::size_t> index_;
};

}  // namespace

GaugePoints read_gauges(const std::string& path, double from, double to, double depth) {
    return GaugeReader(path, from, to, depth).read();
}

}  // namespace ocean::app
