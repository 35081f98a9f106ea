// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/bridge/map_file.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "ocean/bridge/source.hpp"
#include "ocean/checked_text.hpp"
#include "ocean/enum_words.hpp"
#include "ocean/error.hpp"
#include "ocean/text.hpp"
#include "ocean/toml_sections.hpp"

namespace ocean::bridge {

const std::string_view kDefaultMap = R"([[map]]
from = "board0/a1"
to = "wind_speed"
out = [0, 30]
[[map]]
from = "board0/a2"
to = "choppiness"
out = [0, 2]
[[map]]
from = "board0/d1"
to = "app.pause"
mode = "toggle"
[[map]]
from = "board0/d2"
to = "app.record"
mode = "toggle"
)";

namespace {

constexpr std::size_t kMaxMapBytes = std::size_t{1} << 20;
constexpr double kLargest = 1e9;
constexpr double kLongestSmoothing = 60000.0;  // ms

template <typename Enum>
std::string words_of() {
    std::string words;
    for (const std::string_view word : kEnumWords<Enum>) {
        words += (words.empty() ? "" : ", ") + std::string(word);
    }
    return words;
}

/// One [[map]] or [[out]].
class RuleReader {
  public:
    RuleReader(const TomlSection& section, const std::string& name, const ValueTable& values)
        : section_(section), name_(name), values_(values) {}

    MapRule map() {
        MapRule rule;
        bool has_out = false;
        for (const TomlKey& key : section_.keys) {
            key_ = &key;
            if (key.name == "from") {
                rule.from = channel();
            } else if (key.name == "to") {
                rule.to = value_name();
            } else if (key.name == "mode") {
                rule.mode = word<Mode>();
            } else if (key.name == "in") {
                rule.in = range();
                if (rule.in[0] >= rule.in[1]) throw refused("[LOWEST, HIGHEST]; see invert");
            } else if (key.name == "out") {
                rule.out = range();
                has_out = true;
            } else if (key.name == "curve") {
                curve(rule);
            } else if (key.name == "invert") {
                rule.invert = flag();
            } else if (key.name == "deadzone") {
                rule.deadzone = number(0.0, kLargest);
            } else if (key.name == "hysteresis") {
                rule.hysteresis = number(0.0, kLargest);
            } else if (key.name == "smooth_ms") {
                rule.smoothing = number(0.0, kLongestSmoothing) / 1000.0;
            } else if (key.name == "takeover") {
                rule.takeover = word<Takeover>();
            } else if (key.name == "edge") {
                rule.edge = word<Edge>();
            } else if (key.name == "debounce_ms") {
                rule.debounce = number(0.0, kLongestSmoothing) / 1000.0;
            } else {
                throw unknown(
                    "from, to, mode, in, out, curve, invert, deadzone, hysteresis, smooth_ms, "
                    "takeover, edge, debounce_ms");
            }
        }
        require(rule.from, rule.to);
        if (rule.mode == Mode::range) {
            if (!has_out) throw fail(section_.line, "out is missing; allowed: [LOWEST, HIGHEST]");
            require_room(rule);
        }
        require_outputs(rule);
        return rule;
    }

    OutRule out() {
        OutRule rule;
        for (const TomlKey& key : section_.keys) {
            key_ = &key;
            if (key.name == "from") {
                rule.from = value_name();
            } else if (key.name == "to") {
                rule.to = channel();
            } else if (key.name == "in") {
                rule.in = range();
                if (rule.in[0] >= rule.in[1]) throw refused("[LOWEST, HIGHEST]");
            } else if (key.name == "out") {
                rule.out = range();
            } else {
                throw unknown("from, to, in, out");
            }
        }
        require(rule.from, rule.to);
        return rule;
    }

  private:
    Error fail(std::size_t line, const std::string& message) const {
        return text::error_at(ErrorKind::bad_file, name_, line, message);
    }
    std::string given() const {
        const auto& value = key_->value;
        std::string text = text::printable(key_->name) + " = ";
        if (const bool* flag = std::get_if<bool>(&value)) return text + (*flag ? "true" : "false");
        if (const double* number = std::get_if<double>(&value)) return text + plain_text(*number);
        if (const auto* word = std::get_if<std::string>(&value)) {
            return text + '"' + text::printable(*word) + '"';
        }
        return text + "a list of " + std::to_string(std::get<std::vector<double>>(value).size());
    }
    Error refused(const std::string& allowed) const {
        return fail(key_->line, given() + ": allowed: " + allowed);
    }
    Error unknown(const std::string& allowed) const {
        return fail(key_->line, "unknown key '" + text::printable(key_->name) + "' of [[" +
                                    section_.name + "]]; allowed: " + allowed);
    }

    const std::string& text() const {
        const auto* text = std::get_if<std::string>(&key_->value);
        if (text == nullptr) throw refused("a text in quotes");
        return *text;
    }
    bool flag() const {
        const bool* flag = std::get_if<bool>(&key_->value);
        if (flag == nullptr) throw refused("true or false");
        return *flag;
    }
    double number(double lowest, double highest) const {
        const double* number = std::get_if<double>(&key_->value);
        if (number == nullptr || !(*number >= lowest && *number <= highest)) {
            throw refused(plain_text(lowest) + " .. " + plain_text(highest));
        }
        return *number;
    }
    std::array<double, 2> range() const {
        const auto* list = std::get_if<std::vector<double>>(&key_->value);
        if (list == nullptr || list->size() != 2 ||
            !std::ranges::all_of(*list, [](double x) { return std::abs(x) <= kLargest; })) {
            throw refused("two numbers within -1e9 .. 1e9, such as [0, 30]");
        }
        return {(*list)[0], (*list)[1]};
    }
    template <typename Enum>
    Enum word() const {
        const auto& words = kEnumWords<Enum>;
        const auto found = std::ranges::find(words, std::string_view(text()));
        if (found == words.end()) throw refused(words_of<Enum>());
        return static_cast<Enum>(found - words.begin());
    }
    /// "gamma:2.2" or another word.
    void curve(MapRule& rule) const {
        constexpr std::string_view kGamma = "gamma:";
        if (!text().starts_with(kGamma)) {
            rule.curve = word<Curve>();
            if (rule.curve != Curve::gamma) return;
        }
        const std::string digits = text().substr(std::min(kGamma.size(), text().size()));
        const std::optional<double> gamma = text::parse_number(digits);
        if (!gamma || !(*gamma >= 0.01 && *gamma <= 100.0)) {
            throw refused(words_of<Curve>() + ":EXPONENT with 0.01 .. 100");
        }
        rule.curve = Curve::gamma;
        rule.gamma = *gamma;
    }
    std::string channel() const {
        if (!is_channel_name(text())) throw refused("a channel, such as board0/a1");
        return text();
    }
    std::string value_name() const {
        try {
            const std::size_t entry = values_.find(text());
            if (!values_.is_number(entry)) throw refused("the name of a number");
            return values_[entry].name;
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::not_found) throw;
            throw fail(key_->line, given() + ": " + error.what());
        }
    }

    void require(const std::string& from, const std::string& to) const {
        if (from.empty()) throw fail(section_.line, "from is missing");
        if (to.empty()) throw fail(section_.line, "to is missing");
    }
    /// The dead zone and the hysteresis leave something to turn.
    void require_room(const MapRule& rule) const {
        const double half = (rule.in[1] - rule.in[0]) / 2.0;
        if (rule.hysteresis < half && rule.deadzone < half) return;
        throw fail(
            section_.line,
            "deadzone or hysteresis leaves nothing of in; allowed: less than " + plain_text(half));
    }
    void require_outputs(const MapRule& rule) const {
        const std::size_t entry = values_.find(rule.to);
        for (const double value : rule.out) {
            ValueTable tried = values_;
            try {
                tried.set(entry, plain_text(value), "map");
            } catch (const Error&) {
                throw fail(section_.line, "out = " + plain_text(value) + " is no value of " +
                                              rule.to + "; allowed: " + values_.allowed(entry));
            }
        }
    }

    const TomlSection& section_;
    const std::string& name_;
    const ValueTable& values_;
    const TomlKey* key_ = nullptr;
};

}  // namespace

MapFile parse_map(std::string_view toml, const std::string& name, const ValueTable& values) {
    constexpr std::array<std::string_view, 2> kSections = {"map", "out"};
    MapFile file;
    for (const TomlSection& section : parse_toml_sections(toml, name, kSections)) {
        if (file.maps.size() + file.outs.size() >= kMostRules) {
            throw text::error_at(ErrorKind::bad_file, name, section.line,
                                 "is one rule too many; allowed: " + std::to_string(kMostRules));
        }
        RuleReader reader(section, name, values);
        if (section.name == "map") {
            file.maps.push_back(reader.map());
        } else {
            file.outs.push_back(reader.out());
        }
    }
    return file;
}

MapFile read_map(const std::string& path, const ValueTable& values) {
    return parse_map(text::read_file(path, kMaxMapBytes), path, values);
}

}  // namespace ocean::bridge
