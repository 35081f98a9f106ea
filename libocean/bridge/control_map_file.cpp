// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/internal/bridge/control_map_file.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "drivers.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/bridge/device.hpp"
#include "ocean/internal/bridge/source.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/internal/toml_sections.hpp"
#include "section_reader.hpp"

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

const Driver& driver_named(const SectionReader& section) {
    const auto row = std::ranges::find(drivers(), section.text(), &NamedDriver::name);
    if (row == drivers().end()) {
        std::vector<std::string_view> names;
        for (const NamedDriver& known : drivers()) names.push_back(known.name);
        throw section.refused_word(names);
    }
    return row->driver;
}

const std::string& checked_id(const SectionReader& section) {
    if (is_channel_name(section.text() + "/a1")) return section.text();
    throw section.refused("lower-case letters, digits and '_', such as board0");
}

/// Returns the board of the section. `before` are the boards of the sections above it, whose ids
/// this board may not have. Throws Error bad_file that begins with `file` and a line.
DeviceRule read_device(const TomlSection& section, const std::string& file,
                       const std::vector<DeviceRule>& before) {
    SectionReader common(section, file);
    const Driver* driver = nullptr;
    std::string id;
    while (common.next()) {
        if (common.key() == "driver") driver = &driver_named(common);
        if (common.key() == "id") id = checked_id(common);
    }
    if (id.empty()) throw common.fail("id is missing");
    if (driver == nullptr)
        throw common.fail("driver is missing; allowed: " +
                          joined(drivers(), ", ", &NamedDriver::name));
    if (std::ranges::find(before, id, &DeviceRule::id) != before.end()) {
        throw common.fail("id = \"" + id + "\" is used twice");
    }
    DeviceSection settings(section, file);
    return {id, driver->read(settings)};
}

constexpr std::size_t kMaxMapBytes = std::size_t{1} << 20;
constexpr double kMaxNumber = 1e9;
constexpr double kMaxMilliseconds = 60000.0;

/// Reads one [[map]] or [[out]].
class RuleReader : private SectionReader {
  public:
    RuleReader(const TomlSection& section, const std::string& name, const ValueTable& values)
        : SectionReader(section, name), values_(values) {}

    ControlRule map() {
        ControlRule rule;
        read_keys({
            {"from", [&] { rule.from = channel(); }},
            {"to", [&] { rule.to = value_name(); }},
            {"mode", [&] { rule.mode = word<Mode>(); }},
            {"in", [&] { rule.in = range(true); }},
            {"out", [&] { rule.out = range(false); }},
            {"curve", [&] { curve(rule); }},
            {"invert", [&] { rule.invert = flag(); }},
            {"deadzone", [&] { rule.deadzone = number(0.0, kMaxNumber); }},
            {"hysteresis", [&] { rule.hysteresis = number(0.0, kMaxNumber); }},
            {"smooth_ms", [&] { rule.smoothing = number(0.0, kMaxMilliseconds) / 1000.0; }},
            {"takeover", [&] { rule.takeover = word<Takeover>(); }},
            {"edge", [&] { rule.edge = word<Edge>(); }},
            {"debounce_ms", [&] { rule.debounce = number(0.0, kMaxMilliseconds) / 1000.0; }},
            {"code", [&] { rule.code = word<RelativeCode>(); }},
            {"step", [&] { rule.step = number(-kMaxNumber, kMaxNumber); }},
            {"wrap", [&] { rule.wrap = flag(); }},
        });
        require(rule.from, rule.to);
        const bool is_relative = rule.mode == Mode::relative;
        const bool counts = rule.mode == Mode::increment || is_relative;
        if ((rule.mode == Mode::range && !has("out")) ||
            (counts && (!has("out") || rule.out[0] >= rule.out[1]))) {
            throw fail("out is missing or empty; allowed: [LOWEST, HIGHEST]");
        }
        if (is_relative != has("code")) {
            throw fail(is_relative ? "code is missing; allowed: " + words_of<RelativeCode>()
                                   : "code requires mode = \"relative\"");
        }
        if (is_relative && !wire(rule.from).starts_with("cc")) {
            throw fail("from is not a MIDI controller; allowed: such as midi0/cc16");
        }
        if (!has("in")) rule.in = whole_range(rule.from);
        if (is_relative && !has("step")) rule.step = default_step(rule);
        if (counts) require_step(rule);
        if (rule.mode == Mode::range) require_travel(rule);
        require_outputs(rule);
        return rule;
    }

    OutRule out() {
        OutRule rule;
        read_keys({
            {"from", [&] { rule.from = value_name(); }},
            {"to", [&] { rule.to = channel(); }},
            {"in", [&] { rule.in = range(true); }},
            {"out", [&] { rule.out = range(false); }},
        });
        require(rule.from, rule.to);
        return rule;
    }

  private:
    /// A kind of channel with 14 bits, and its last number.
    struct Wide {
        std::string_view letters;
        int last;
    };
    static constexpr std::array kWide = {Wide{"pair", 31}, Wide{"nrpn", 16383}, Wide{"rpn", 16383},
                                         Wide{"pb", 1}};

    /// Reads "gamma:2.2" or another word of Curve.
    void curve(ControlRule& rule) const {
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
        const std::string_view name = wire(text());
        for (const auto& [letters, last] : kWide) {
            if (name.starts_with(letters) &&
                text::parse_number(name.substr(letters.size())) > static_cast<double>(last)) {
                throw refused("a channel; the last one of this kind is " + std::string(letters) +
                              std::to_string(last));
            }
        }
        return text();
    }
    /// Returns "a1" of "board0/a1".
    static std::string_view wire(std::string_view channel) {
        return channel.substr(channel.find('/') + 1);
    }
    /// Returns the range that MIDI defines for the channel; for other channels 0 .. 255, the range
    /// of a K8055's knobs.
    static std::array<double, 2> whole_range(std::string_view channel) {
        const std::string_view name = wire(channel);
        const bool is_wide = std::ranges::any_of(
            kWide, [&](const auto& wide) { return name.starts_with(wide.letters); });
        if (is_wide) return {0.0, 16383.0};
        if (name.starts_with("cc")) return {0.0, 127.0};
        return {0.0, 255.0};
    }
    /// Returns a hundredth of `out`, for a whole number at least 1.
    double default_step(const ControlRule& rule) const {
        const double hundredth = (rule.out[1] - rule.out[0]) / 100.0;
        if (!values_.is_whole(values_.find(rule.to))) return hundredth;
        return std::max(std::round(hundredth), 1.0);
    }
    void require_step(const ControlRule& rule) const {
        if (!values_.is_whole(values_.find(rule.to)) || rule.step == std::round(rule.step)) return;
        throw fail("step = " + plain_text(rule.step) + " is not a step of " + rule.to +
                   "; allowed: whole numbers");
    }
    std::string value_name() const {
        try {
            const std::size_t entry = values_.find(text());
            if (!values_.is_number(entry)) throw refused("the name of a number");
            return values_[entry].name;
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::not_found) throw;
            throw fail_here(error.what());
        }
    }

    void require(const std::string& from, const std::string& to) const {
        if (from.empty()) throw fail("from is missing");
        if (to.empty()) throw fail("to is missing");
    }
    /// Throws if the dead zone or the hysteresis covers the knob's whole range.
    void require_travel(const ControlRule& rule) const {
        const double half = (rule.in[1] - rule.in[0]) / 2.0;
        if (rule.hysteresis < half && rule.deadzone < half) return;
        throw fail("deadzone or hysteresis covers the whole of in; allowed: less than " +
                   plain_text(half));
    }
    void require_outputs(const ControlRule& rule) const {
        const std::size_t entry = values_.find(rule.to);
        for (const double value : rule.out) {
            ValueTable tried = values_;
            try {
                tried.set(entry, value, "map");
            } catch (const Error&) {
                throw fail("out = " + plain_text(value) + " is not a value of " + rule.to +
                           "; allowed: " + values_.allowed(entry));
            }
        }
    }

    const ValueTable& values_;
};

}  // namespace

ControlMapFile parse_control_map(std::string_view toml, const std::string& name,
                                 const ValueTable& values) {
    constexpr std::array<std::string_view, 3> kSections = {"device", "map", "out"};
    ControlMapFile file;
    const auto sections = parse_toml_sections(toml, name, kSections);
    if (sections.size() > kMaxRules) {
        throw text::error_at(ErrorKind::bad_file, name, sections[kMaxRules].line,
                             "is one section too many; allowed: " + std::to_string(kMaxRules));
    }
    for (const TomlSection& section : sections) {
        if (section.name == "device") {
            file.devices.push_back(read_device(section, name, file.devices));
        } else if (section.name == "map") {
            file.maps.push_back(RuleReader(section, name, values).map());
        } else {
            file.outs.push_back(RuleReader(section, name, values).out());
        }
    }
    return file;
}

std::string read_map_text(const std::string& path) {
    return text::read_file(path, kMaxMapBytes);
}

}  // namespace ocean::bridge
