// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "swan_header.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <utility>

#include "ocean/internal/grid.hpp"
#include "ocean/internal/record_rules.hpp"
#include "ocean/internal/text.hpp"

namespace ocean {
namespace {

/// The factor from variance to energy in SWAN [J/m^2 per m^2]: its default density and gravity.
constexpr double kEnergyOfVariance = 1025.0 * 9.81;

class SwanHeaderReader {
  public:
    explicit SwanHeaderReader(FreeForm& in) : in_(in) {}

    SwanHeader read() {
        keyword({"SWAN"});
        if (in_.number_here("a version") != 1.0) {
            throw in_.fail("version " + in_.last_number() + " of SWAN's files; known: 1");
        }
        std::string_view word = keyword({"TIME", "ITER", "LONLAT", "LOCATIONS"});
        if (word == "TIME" || word == "ITER") {
            header_.iterations = word == "ITER";
            if (header_.iterations) {
                in_.header_number("a number");
            } else {
                read_time_coding();
            }
            word = keyword({"LONLAT", "LOCATIONS"});
        }
        read_locations(word == "LONLAT");
        keyword({"AFREQ", "RFREQ"});  // absolute and relative to the current: alike without one
        header_.frequency = read_frequencies(in_, in_.count("frequencies", 2, kMaxFrequencies));
        word = keyword({"NDIR", "CDIR", "QUANT"});
        if (word != "QUANT") {
            read_directions(word == "NDIR" ? DirectionConvention::from_nautical
                                           : DirectionConvention::to_cartesian);
            keyword({"QUANT"});
        }
        read_quantities();
        return std::move(header_);
    }

  private:
    /// Reads the keyword of the next line, which must be one of those allowed.
    std::string_view keyword(std::initializer_list<std::string_view> allowed) {
        const std::string names = joined(allowed, " or ");
        in_.need_line(names);
        const std::string_view word = in_.word();
        if (std::find(allowed.begin(), allowed.end(), word) == allowed.end()) {
            throw in_.fail("'" + FreeForm::shown(word) + "' where " + names + " should be");
        }
        return word;
    }

    void read_time_coding() {
        constexpr std::array<std::string_view, 6> kPatterns = {"YYYYMMDD.hhmmss",
                                                               "DD-bbb-YY hh:mm:ss",
                                                               "MM/DD/YY.hh:mm:ss",
                                                               "",  // the time of day only
                                                               "YY/MM/DD hh:mm:ss",
                                                               "YYMMDDhhmm"};
        const std::size_t option = in_.count("as time coding option", 1, kPatterns.size());
        header_.time_pattern = kPatterns[option - 1];
        if (header_.time_pattern.empty()) throw in_.fail("time coding option 4 has no dates");
    }

    void read_locations(bool geographic) {
        const std::size_t count = in_.count("locations", 1, kMaxRecords);
        while (header_.places.size() < count) {
            in_.need_line("location " + std::to_string(header_.places.size() + 1));
            SwanPlace place;
            place.longitude = in_.number_here("a coordinate");
            if (geographic) {
                in_.require_within(place.longitude, -180.0, 360.0, "a longitude", "-180 .. 360");
            }
            const std::string x = in_.last_number();
            place.latitude = in_.number_here("a coordinate");
            if (geographic) {
                in_.require_within(place.latitude, -90.0, 90.0, "a latitude", "-90 .. 90");
            } else {
                place = {x + " " + in_.last_number(), kMissing, kMissing};
            }
            if (const std::string name = name_of(in_.rest()); !name.empty()) place.station = name;
            header_.places.push_back(std::move(place));
        }
    }
    /// Returns the name that the manual allows after the coordinates.
    static std::string name_of(std::string_view text) {
        constexpr std::string_view kAround = " \t'\"";
        text.remove_prefix(std::min(text.find_first_not_of(kAround), text.size()));
        return text::printable(text.substr(0, text.find_last_not_of(kAround) + 1));
    }

    void read_directions(DirectionConvention convention) {
        const std::size_t count = in_.count("directions", 3, kMaxDirections);
        require_directional_size(in_.lines(), count * header_.frequency.size());
        std::vector<double> degrees;
        while (degrees.size() < count) {
            degrees.push_back(in_.header_number("a direction"));
            in_.require_within(degrees.back(), -360.0, 720.0, "a direction", "-360 .. 720");
        }
        header_.axis = direction_axis(in_.lines(), degrees, convention);
        header_.directions = count;
    }

    void read_quantities() {
        const std::size_t count = in_.count("quantities", 1, header_.directional() ? 1 : 3);
        while (header_.quantities.size() < count) header_.quantities.push_back(read_quantity());
        if (!has(SwanMeaning::density)) {
            throw in_.fail("no VaDens, EnDens or AcDens among the quantities");
        }
    }
    bool has(SwanMeaning meaning) const {
        return std::any_of(header_.quantities.begin(), header_.quantities.end(),
                           [&](const SwanQuantity& q) { return q.meaning == meaning; });
    }

    SwanQuantity read_quantity() {
        in_.need_line("the name of a quantity");
        const std::string name(in_.word());
        SwanQuantity quantity;
        quantity.meaning = meaning_of(name);
        if (has(quantity.meaning)) throw in_.fail("a second " + name);
        in_.need_line("the unit of " + name);
        switch (quantity.meaning) {
            case SwanMeaning::density:
                read_density_unit(name, quantity);
                break;
            case SwanMeaning::direction:
                read_unit(name, {"degr", "deg"});
                quantity.convention = name == "NDIR" ? DirectionConvention::from_nautical
                                                     : DirectionConvention::to_cartesian;
                break;
            case SwanMeaning::spread:
                quantity.spread_is_power = read_unit(name, {"degr", "deg", "-"}) == "-";
                break;
        }
        in_.need_line("the exception value of " + name);
        quantity.exception = in_.number_here("an exception value");
        return quantity;
    }

    /// Reads a unit as SWAN spells it: "m2/Hz/degr", with "J/" before it for energy and "s" after
    /// "m2" or "J" for action.
    void read_density_unit(const std::string& name, SwanQuantity& quantity) {
        const bool energy = name == "EnDens";
        quantity.action = name == "AcDens";
        std::string unit = quantity.action ? "m2s/Hz" : energy ? "J/m2/Hz" : "m2/Hz";
        const std::string joules = quantity.action ? "Js/m2/Hz" : unit;
        std::vector<std::string> allowed;
        for (const std::string& one : {unit, joules}) {
            if (!header_.directional()) allowed.push_back(one);
            if (!header_.directional()) continue;
            for (const char* angle : {"/degr", "/deg", "/rad"}) allowed.push_back(one + angle);
        }
        const std::string read = read_unit(name, allowed);
        if (read.starts_with('J')) quantity.scale = 1.0 / kEnergyOfVariance;
        if (read.ends_with("/rad")) quantity.scale *= kPi / 180.0;
    }

    SwanMeaning meaning_of(const std::string& name) const {
        if (name == "VaDens" || name == "EnDens" || name == "AcDens") return SwanMeaning::density;
        if (!header_.directional() && (name == "NDIR" || name == "CDIR"))
            return SwanMeaning::direction;
        if (!header_.directional() && (name == "DSPRDEGR" || name == "DSPR"))
            return SwanMeaning::spread;
        throw in_.fail("'" + FreeForm::shown(name) +
                       "' is not a quantity; known: VaDens, EnDens, AcDens" +
                       (header_.directional() ? "" : ", NDIR, CDIR, DSPRDEGR, DSPR"));
    }

    std::string read_unit(const std::string& quantity, const std::vector<std::string>& allowed) {
        std::string unit(in_.word());
        std::erase(unit, '*');
        if (unit == "m2" && in_.rest().starts_with("s/")) unit += in_.word();
        if (std::find(allowed.begin(), allowed.end(), unit) == allowed.end()) {
            throw in_.fail("'" + FreeForm::shown(unit) + "' is not a unit of " + quantity +
                           "; known: " + allowed[0] + (allowed.back() == "-" ? " or -" : ""));
        }
        return unit;
    }

    FreeForm& in_;
    SwanHeader header_;
};

}  // namespace

SwanHeader read_swan_header(FreeForm& in) {
    return SwanHeaderReader(in).read();
}

}  // namespace ocean
