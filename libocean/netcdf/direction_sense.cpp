// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The convention of a file's directions: see direction_sense.hpp.
#include "direction_sense.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <vector>

#include "names.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/directional_record.hpp"
#include "ocean/internal/grid.hpp"

namespace ocean::netcdf {
namespace {

/// The words that follow a "from" of the direction that waves come from, separated by blanks.
constexpr std::string_view kAfterFrom =
    " direction directions which where clockwise counter counterclockwise anticlockwise "
    "nautical degrees deg degree meteorological measured convention relative in true at of cw "
    "ccw not and ";

double offset_degrees(const DirectionSense& sense) {
    return (sense.from_east ? 0.0 : 90.0) + (sense.from ? 180.0 : 0.0);
}

/// Splits a text into words of lower-case letters and digits.
std::vector<std::string> words_of(std::string_view text) {
    std::vector<std::string> words(1);
    for (const char c : lower_case(text)) {
        const bool part = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
        if (part) {
            words.back() += c;
        } else if (!words.back().empty()) {
            words.emplace_back();
        }
    }
    if (words.back().empty()) words.pop_back();
    return words;
}

/// Reads one text, word by word.
class WordReader {
  public:
    explicit WordReader(std::string_view text) : words_(words_of(text)) {}

    DirectionWords read() {
        for (std::size_t i = 0; i < words_.size(); ++i) read_word(i);
        DirectionWords said;
        said.from = decided(from_, to_) ? decided(from_, to_) : decided(hint_from_, hint_to_);
        said.counter_clockwise = decided(counter_clockwise_, clockwise_);
        said.from_east = decided(east_, north_);
        if (mathematical_) {  // cartesian: complete without further words
            if (!said.from) said.from = false;
            if (!said.counter_clockwise) said.counter_clockwise = true;
            if (!said.from_east) said.from_east = true;
        }
        return said;
    }

  private:
    static std::optional<bool> decided(bool yes, bool no) {
        return yes == no ? std::nullopt : std::optional(yes);
    }
    bool is(std::size_t i, Words among_these) const {
        return i < words_.size() && among(words_[i], among_these);
    }
    bool is_number(std::size_t i) const {
        return i < words_.size() && words_[i].find_first_not_of("0123456789") == std::string::npos;
    }
    /// Returns the axis that angles are measured from, 'n' or 'e', or 0 for another word.
    char quarter(std::size_t i) const {
        while (
            is(i, {"the", "true", "geographic", "magnetic", "grid", "positive", "due", "local"})) {
            ++i;
        }
        if (is(i, {"north", "n"})) return 'n';
        return is(i, {"east", "e", "x", "xaxis", "eastward"}) ? 'e' : '\0';
    }

    void read_word(std::size_t i) {
        const std::string& word = words_[i];
        if (word == "from") {
            read_from(i);
        } else if (word == "to") {
            read_to(i);
        } else if (among(word, {"toward", "towards", "goingto", "heading"})) {
            to_ = true;
        } else if (among(word, {"comingfrom", "provenance"})) {
            from_ = true;
        } else if (among(word, {"meteorological", "meteorology", "nautical", "naut", "met",
                                "coming", "comes", "arriving", "origin", "originating"})) {
            hint_from_ = true;
        } else if (among(word, {"oceanographic", "oceanographical", "propagation", "propagating",
                                "travelling", "traveling", "going", "goes"})) {
            hint_to_ = true;
        } else if (among(word, {"cartesian", "cart", "mathematical", "trigonometric", "math"})) {
            mathematical_ = true;
        } else if (among(word, {"counterclockwise", "anticlockwise", "ccw"})) {
            counter_clockwise_ = true;
            east_ = east_ || quarter(i + 1) == 'e';
        } else if (among(word, {"clockwise", "cw"})) {
            (is(i - 1, {"counter", "anti"}) ? counter_clockwise_ : clockwise_) = true;
        }
    }

    void read_to(std::size_t i) {
        const bool travels =
            is(i - 1,
               {"going",      "goes",        "go",        "travel",    "travels", "traveling",
                "travelling", "propagating", "propagate", "moving",    "heading", "headed",
                "direction",  "directions",  "wave",      "waves",     "mean",    "true",
                "degree",     "degrees",     "deg",       "principal", "flowing", "dir"}) &&
            quarter(i + 1) == 0;
        const bool first = i == 0 && (words_.size() == 1 || is(1, {"direction"}));
        to_ = to_ || travels || first;
    }

    /// Reads a "from": the direction waves come from, the axis angles are measured from, or the
    /// source of a computed value.
    void read_from(std::size_t i) {
        const char axis = quarter(i + 1);
        if (is(i - 1, {"coming", "comes", "come", "came", "arriving", "propagating"})) {
            from_ = true;
        } else if (axis != 0 && is_number(i - 1)) {  // "0 = from north"
            from_ = true;
        } else if (axis != 0) {
            (axis == 'n' ? north_ : east_) = true;
        } else if (is(i - 1, {"direction", "directions", "dir", "wave", "waves", "mean", "true",
                              "degree", "degrees", "deg", "principal", "is", "are", "where",
                              "north", "primary", "peak"}) ||
                   i == 0) {
            // "mean wave direction from spectral moments" gives the source of the value alone.
            from_ = from_ || i + 1 == words_.size() || lists(kAfterFrom, words_[i + 1]);
        }
    }

    std::vector<std::string> words_;
    bool from_ = false, to_ = false, hint_from_ = false, hint_to_ = false;
    bool clockwise_ = false, counter_clockwise_ = false, north_ = false, east_ = false;
    bool mathematical_ = false;
};

/// Returns true for the name of an attribute that may describe directions in words.
bool is_spoken(const std::string& key) {
    const std::string name = plain_name(key);
    return name.find("convention") != std::string::npos ||
           name.find("direction") != std::string::npos ||
           among(name, {"comment", "comments", "description", "summary", "definition", "note",
                        "notes", "details", "globwavename", "shortname", "longname", "reference",
                        "measuredfrom", "orientation"});
}

/// The attributes that describe their variable, in order of precedence.
std::vector<std::pair<std::string, std::string>> spoken_attributes(const Variable& v) {
    std::vector<std::pair<std::string, std::string>> spoken;
    for (const char* key : {"standard_name", "long_name", "units"}) {
        if (const std::string text = v.attribute(key); !text.empty()) {
            spoken.emplace_back(key, text);
        }
    }
    for (const auto& [key, text] : v.attributes) {
        if (is_spoken(key) && key != "long_name") spoken.emplace_back(key, text);
    }
    return spoken;
}

/// Returns the sentences of a text that are about directions of waves, not of the wind.
std::string about_directions(const std::string& text) {
    std::string about;
    std::size_t begin = 0;
    while (begin < text.size()) {
        const std::size_t end = std::min(text.find_first_of(".;\n", begin), text.size());
        const std::string sentence = text.substr(begin, end - begin);
        begin = end + 1;
        bool direction = false;
        bool other = false;
        for (const std::string& word : words_of(sentence)) {
            direction = direction || among(word, {"direction", "directions", "convention"});
            other = other || among(word, {"wind", "winds", "current", "currents", "magnetic"});
        }
        if (direction && !other) about += sentence + " ; ";
    }
    return about;
}

/// Returns the part of a text that is about the directions, for an attribute of another variable or
/// of the file; "" if there is none.
std::string words_elsewhere(const std::string& key, const std::string& text) {
    const std::string name = plain_name(key);
    if (name.find("wind") != std::string::npos) return "";
    const bool names_them =
        name.find("direction") != std::string::npos || name.find("convention") != std::string::npos;
    return names_them ? text : about_directions(text);
}

/// The convention that all texts give together: for each part the first text counts.
class Evidence {
  public:
    void add(const std::string& key, const std::string& text) {
        const DirectionWords said = direction_words(text);
        if (said.from && !from_) source_ = key;
        if (said.from && from_ && *said.from != *from_ && contrary_.empty()) contrary_ = key;
        take(from_, said.from);
        take(counter_clockwise_, said.counter_clockwise);
        take(from_east_, said.from_east);
    }
    /// Without words about the zero, counter-clockwise implies "from east", and the reverse.
    DirectionSense sense(DirectionSense otherwise) const {
        DirectionSense sense = otherwise;
        sense.from = from_.value_or(otherwise.from);
        if (from_ || counter_clockwise_ || from_east_) {
            const bool east = from_east_.value_or(counter_clockwise_.value_or(false));
            sense.from_east = east;
            sense.counter_clockwise = counter_clockwise_.value_or(east);
        }
        return sense;
    }
    bool told() const { return from_.has_value(); }
    const std::string& source() const { return source_; }
    const std::string& contrary() const { return contrary_; }

  private:
    static void take(std::optional<bool>& known, const std::optional<bool>& said) {
        if (!known) known = said;
    }
    std::optional<bool> from_, counter_clockwise_, from_east_;
    std::string source_, contrary_;
};

/// Returns the convention of a SWAN run, which its files have in an attribute of their own.
std::string swan_convention(const Content& content) {
    for (const auto& [key, text] : content.attributes) {
        if (plain_name(key) == "directionalconvention") return lower_case(text);
    }
    return "";
}

}  // namespace

double DirectionSense::travel(double degrees) const {
    const double turned = (counter_clockwise ? degrees : -degrees) + offset_degrees(*this);
    return travel_direction(turned, DirectionConvention::to_cartesian);
}

std::complex<double> DirectionSense::travel_moment(std::complex<double> moment, int n) const {
    return (counter_clockwise ? moment : std::conj(moment)) *
           std::polar(1.0, n * offset_degrees(*this) * kDegree);
}

std::string DirectionSense::text() const {
    return std::string(from ? "where waves come from" : "where waves travel to") + ", " +
           (counter_clockwise ? "counter-clockwise" : "clockwise") + " from " +
           (from_east ? "east" : "north");
}

DirectionWords direction_words(std::string_view text) {
    return WordReader(text).read();
}

bool is_swan(const Content& content, const Variable& spectrum) {
    if (!among(spectrum.name, {"density", "energy", "energy_1d"})) return false;
    if (!swan_convention(content).empty()) return true;
    return std::any_of(content.variables.begin(), content.variables.end(), [&](const Variable& v) {
        return v.name == "scale_" + spectrum.name ||
               (v.name == "direction" && v.attribute("units") == "radians");
    });
}

std::string silent_directions(const Variable& directions, const DirectionSense& taken) {
    const std::string name = text::printable(directions.name);
    return "nothing in the file says whether waves come from the direction '" + name +
           "' or travel to it: " + taken.text() +
           ", is taken. To turn the sea, give the variable its standard_name (ncatted -a "
           "standard_name," +
           name +
           ",o,c,sea_surface_wave_to_direction FILE), or the wave system a wind_direction, where "
           "its waves travel to";
}

FoundSense direction_sense(const Content& content, const Variable& directions,
                           const Variable& spectrum, std::optional<DirectionSense> writer) {
    if (is_swan(content, spectrum)) {
        const std::string convention = swan_convention(content);
        if (convention.find("cartesian") != std::string::npos)
            return {kTravellingToFromEast, true, ""};
        const bool known = among(convention, {"nautical", "meteorological"}) ||
                           direction_words(directions.attribute("standard_name")).from == true;
        return {kComingFrom, known, ""};
    }
    Evidence evidence;
    for (const auto& [key, text] : spoken_attributes(directions)) evidence.add(key, text);
    const std::string contrary = evidence.contrary();
    for (const auto& [key, text] : spoken_attributes(spectrum)) {
        if (key != "units") evidence.add(key, words_elsewhere(key, text));
    }
    for (const auto& [key, text] : content.attributes) {
        if (is_spoken(key)) evidence.add(key, words_elsewhere(key, text));
    }
    FoundSense found;
    found.sense = evidence.sense(writer.value_or(kComingFrom));
    found.told = evidence.told() || writer.has_value();
    if (!contrary.empty()) {
        found.warning = "the attributes " + text::printable(evidence.source()) + " and " +
                        text::printable(contrary) + " of " + text::printable(directions.name) +
                        " contradict each other: the first " + "counts, it is " +
                        found.sense.text();
    }
    return found;
}

}  // namespace ocean::netcdf
