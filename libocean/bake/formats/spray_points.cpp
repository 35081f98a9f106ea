// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/spray_points.hpp"

#include <algorithm>

#include "formats/formats.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/sea_bytes.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/ocean.hpp"
#include "ocean/seafile.hpp"
#include "refuse.hpp"
#include "source.hpp"

namespace ocean {
namespace {

constexpr const char* kLifetime = "spray-lifetime";
constexpr const char* kSprayDensity = "spray-density";
constexpr const char* kMaxSpray = "spray-most";

/// A setting as typed, and as stated in a header.
struct Setting {
    const char* option;
    const char* string;
    std::string value;
};
std::vector<Setting> settings_of(const SpraySettings& spray) {
    return {{kLifetime, "spray_lifetime", shortest_text(spray.lifetime)},
            {kSprayDensity, "spray_density", shortest_text(spray.density)},
            {kMaxSpray, "spray_most", std::to_string(spray.most)}};
}

}  // namespace

std::vector<FormatOption> spray_options() {
    const SpraySettings defaults;
    return {
        {kLifetime, "SECONDS",
         "Maximum age of a particle of spray, 0.05 to 10, in a loop at most half of its period; "
         "default " +
             shortest_text(defaults.lifetime),
         "", kSeaKind},
        {kSprayDensity, "NUMBER",
         "Particles of spray for each m^2 that turns white, 0 to 1000; default " +
             shortest_text(defaults.density),
         "", kSeaKind},
        {kMaxSpray, "COUNT",
         "Approximate limit of particles of spray that are alive at once: a sea that would have "
         "more has them thinned out; default " +
             std::to_string(defaults.most),
         "", kSeaKind},
    };
}

void refuse_spray_options(const BakeOptions& options, std::string_view products) {
    for (const Setting& setting : settings_of({})) {
        const std::string& value = options.format_option(setting.option);
        if (value.empty()) continue;
        refuse("--" + std::string(setting.option) + " " + value + ": needs --products " +
               std::string(products));
    }
}

SpraySettings read_spray_settings(const BakeOptions& options) {
    SpraySettings settings;
    const auto typed = [&](const char* name, auto& value, const auto& parse) {
        const std::string& text = options.format_option(name);
        if (!text.empty()) value = parse(text, "--" + std::string(name));
    };
    typed(kLifetime, settings.lifetime, [](const std::string& text, const std::string& name) {
        return parse_number(text, name, 0.05, 10.0);
    });
    typed(kSprayDensity, settings.density, [](const std::string& text, const std::string& name) {
        return parse_number(text, name, 0.0, 1000.0);
    });
    typed(kMaxSpray, settings.most, [](const std::string& text, const std::string& name) {
        return parse_whole_number(text, name, 1, 100'000'000);
    });
    validate(settings);
    return settings;
}

SprayPoints read_spray(const BakeOptions& options) {
    return {read_spray_settings(options), read_up_axes(options, "points")};
}

std::vector<io::HeaderString> spray_setting_strings(const SpraySettings& settings) {
    std::vector<io::HeaderString> strings;
    for (const Setting& setting : settings_of(settings)) {
        strings.push_back({"ocean:" + std::string(setting.string), setting.value});
    }
    return strings;
}

FrameMaps spray_maps(const BakePlan& draft) {
    FrameMaps maps{{}, {draft.domain().wraps ? spray_domain(draft).samples[0] : draft.resolution}};
    maps.sequential = true;
    return maps;
}

std::vector<BakeFile> list_spray(const BakePlan& plan, int frame) {
    return {{plan.pattern.file(frame), frame, 0, std::string(kSprayProduct.name)}};
}

std::vector<io::HeaderString> spray_strings(const BakePlan& plan, const SprayPoints& spray,
                                            int frame) {
    std::vector<io::HeaderString> strings = io::provenance_strings(provenance_of(plan, frame));
    // Spray is emitted on the sea's own lattice, which does not depend on --resolution.
    const int resolution = plan.subject->default_resolution();
    strings.push_back({"ocean:resolution", std::to_string(resolution)});
    strings.push_back({"ocean:axes", std::string(io::axes_name(spray.axes))});
    strings.push_back({"ocean:field", std::string(kSprayProduct.name)});
    for (io::HeaderString& string : spray_setting_strings(spray.settings)) {
        strings.push_back(std::move(string));
    }
    return strings;
}

std::string spray_recipe(const BakePlan& plan, const SprayPoints& spray, const BakeFile& file) {
    std::string lines = "spray " + std::string(io::axes_name(spray.axes));
    for (const auto& string : spray_setting_strings(spray.settings)) lines += " " + string.text;
    return bake_recipe(plan, file.frame, lines + "\n");
}

std::string spray_cell_warning(const BakePlan& plan) {
    constexpr double kLongest = 4.0;  // [m]; breaker fronts are some metres wide
    const std::vector<BakeFile> files = plan.format->files(plan, plan.frames.front());
    const auto has_spray = [](const BakeFile& file) {
        return file.product == kSprayProduct.name || file.product == "density";
    };
    if (std::ranges::none_of(files, has_spray)) return "";
    if (plan.domain().wraps) return "";
    const Domain domain = spray_domain(plan);
    if (domain.step(0) <= kLongest) return "";
    const double side = std::max(domain.size[0], domain.size[1]);
    const bool has_bed = sea_of(*plan.subject).parameters.water.bed != nullptr;
    return format_text(
        "spray %s of %.0f m is emitted on cells of %.3g m: fronts of breakers are narrower "
        "than that, and some throw none; a %s of at most 4096 m has cells of 4 m",
        has_bed ? "over a bed" : "of a region", side, domain.step(0), has_bed ? "bed" : "region");
}

std::optional<Domain> spray_region(const BakePlan& plan) {
    const Domain domain = plan.domain();
    return domain.wraps ? std::nullopt : std::optional(domain);
}

Domain spray_domain(const BakePlan& plan) {
    return spray_domain(sea_of(*plan.subject).parameters, spray_region(plan));
}

std::uint64_t max_spray_points(const BakePlan& plan, const SpraySettings& settings) {
    return max_spray_particles(sea_of(*plan.subject), settings, spray_region(plan));
}

std::uint64_t spray_frame_bytes(const BakePlan& plan, const SprayPoints& spray) {
    const std::uint64_t points = max_spray_points(plan, spray.settings);
    return spray_bytes(points) + io::points_bytes(points) + spray_map_bytes(plan);
}

std::uint64_t spray_map_bytes(const BakePlan& plan) {
    const Domain domain = spray_domain(plan);
    if (!domain.wraps) return spray_map_bytes(domain);
    const Grid& grid = sea_of(*plan.subject).parameters.grid;
    return domain.count() * kSprayChannels.size() * sizeof(float) +
           work_bytes(grid, plan.backend, kSprayChannels, domain.samples[0]);
}

io::Points make_spray_points(const FrameWork& work, const SprayPoints& spray) {
    const std::vector<SprayParticle> particles =
        ocean_of(work.source).spray(work.time(), spray.settings, spray_region(work.plan));
    io::Points points;
    const std::size_t count = particles.size();
    points.positions.reserve(3 * count);
    points.velocities.reserve(3 * count);
    points.ages.reserve(count);
    points.lives.reserve(count);
    points.radii.reserve(count);
    points.ids.reserve(count);
    for (const SprayParticle& particle : particles) {
        for (const double value : {particle.x, particle.y, particle.z}) {
            points.positions.push_back(static_cast<float>(value));
        }
        for (const double value : {particle.vx, particle.vy, particle.vz}) {
            points.velocities.push_back(static_cast<float>(value));
        }
        points.ages.push_back(static_cast<float>(particle.age));
        points.lives.push_back(static_cast<float>(particle.life));
        points.radii.push_back(static_cast<float>(particle.radius));
        points.ids.push_back(particle.id);
    }
    if (spray.axes == io::Axes::yup) io::turn_y_up(points);
    return points;
}

void adopt_spray(const BakedHeader& header, BakeOptions& options) {
    if (options.format_option("products") == kSprayProduct.name)
        adopt_spray_settings(header, options);
}

void adopt_spray_settings(const BakedHeader& header, BakeOptions& options) {
    for (const Setting& setting : settings_of({})) {
        if (header.has(setting.string))
            options.set_default(setting.option, header.text(setting.string));
    }
}

}  // namespace ocean
