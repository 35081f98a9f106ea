// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The options of volumes as settings, headers and recipes; see volumes.hpp. Grids are sampled at
// positions in the world and need no maps.
#include "formats/volumes.hpp"

#include <algorithm>

#include "ocean/channel.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/csv_rows.hpp"
#include "ocean/internal/nearest_name.hpp"
#include "ocean/internal/text.hpp"
#include "refuse.hpp"
#include "source.hpp"

namespace ocean {
namespace {

constexpr Product kVolumeProducts[] = {{.name = "surface",
                                        .channels = {},
                                        .count = 0,
                                        .unit = "m",
                                        .help = "Level set of the surface"},
                                       {.name = "vel",
                                        .channels = {},
                                        .count = 0,
                                        .unit = "m/s",
                                        .vector = true,
                                        .subject = kSeaKind,
                                        .help = "Velocity of the water at a fixed place"},
                                       {.name = "density",
                                        .channels = {},
                                        .count = 0,
                                        .unit = "1/m",
                                        .subject = kSeaKind,
                                        .help = "Mist of spray"}};
constexpr const Product& kSurface = kVolumeProducts[0];
constexpr const Product& kVelocity = kVolumeProducts[1];
constexpr const Product& kDensity = kVolumeProducts[2];
constexpr std::string_view kDefaultGrids = "surface,vel";  // without vel if no water moves
constexpr std::string_view kCrest = "crest";

}  // namespace

std::vector<const Product*> VolumeSettings::product_rows() const {
    std::vector<const Product*> rows;
    if (surface) rows.push_back(&kSurface);
    if (velocity) rows.push_back(&kVelocity);
    if (density) rows.push_back(&kDensity);
    return rows;
}

std::string VolumeSettings::products() const {
    return joined(product_rows(), ",", &Product::name);
}

std::string VolumeSettings::box_text() const {
    std::string text;
    for (const double& side : *box) {
        if (&side != box->data()) text += ',';
        text += std::isnan(side) ? std::string(kCrest) : shortest_text(side);
    }
    return text;
}

io::WorldBox VolumeSettings::world_box(double crest) const {
    const std::array<double, 6>& side = *box;
    // The level set must end above the crests, so that its band is complete.
    const double top = to_the_crest() ? crest : side[5];
    return {{side[0], side[1], side[2]}, {side[3], side[4], std::max(top, side[2] + 1e-3)}};
}

std::vector<FormatOption> volume_options() {
    return {
        {"products", "LIST",
         "Comma list of surface, vel and density; spray is a file of its own; default " +
             std::string(kDefaultGrids)},
        {"box", "X0,Y0,Z0,X1,Y1,Z1",
         "Box in the world [m], z up from still water, Z1 a number or crest; default: one period "
         "from 2 Hs, at least 4 m, below still water to the crests"},
        {"voxel", "METRES", "Size of the surface's voxels; default the period / the resolution"},
        {"velocity-voxel", "METRES",
         "Size of the voxels of velocity and density; default twice --voxel", "", kSeaKind},
        {"mist", "NUMBER",
         "Cross-section of the mist, m^2 for each m^2 that turns white, 0 to 1000; "
         "default " +
             shortest_text(VolumeSettings{}.mist),
         "", kSeaKind},
        {"type", "TYPE", "float or half; default float"},
        {"axes", "AXES", "zup (x, y, z) or yup (x, z, -y); default zup"}};
}

namespace {

/// Returns the fields of a comma list; none if there are more than `limit`.
std::vector<std::string_view> fields_of(const std::string& list, std::size_t limit) {
    return csv::split(list, ',', limit).value_or(std::vector<std::string_view>{});
}

std::array<double, 6> read_box(const std::string& text) {
    const std::string option = "--box " + text;
    const std::vector<std::string_view> sides = fields_of(text, 6);
    std::array<double, 6> box{};
    if (sides.size() != box.size()) refuse(option + ": allowed are six numbers, X0,Y0,Z0,X1,Y1,Z1");
    for (std::size_t i = 0; i < box.size(); ++i) {
        const bool is_crest = i + 1 == box.size() && sides[i] == kCrest;
        box[i] = is_crest
                     ? std::nan("")
                     : parse_number(sides[i], option, -kMaxVolumeCoordinate, kMaxVolumeCoordinate);
    }
    for (std::size_t i = 0; i < 3; ++i) {
        if (box[i] >= box[i + 3])
            refuse(option + ": the box is empty; each of X1, Y1, Z1 must be above X0, Y0, Z0");
    }
    return box;
}

double read_voxel(const std::string& option, const std::string& text) {
    constexpr double kMinVoxel = 1e-4;
    return text.empty()
               ? 0.0
               : parse_number(text, "--" + option + " " + text, kMinVoxel, kMaxVolumeCoordinate);
}

}  // namespace

ProductChoice volume_choice() {
    return {.known = kVolumeProducts,
            .default_list = kDefaultGrids,
            .one_refusal = "allowed for a volume are surface, vel and density, each once"};
}

VolumeSettings read_volumes(const BakeOptions& options, const ChosenProducts& chosen) {
    VolumeSettings settings;
    settings.is_default = chosen.is_default;
    settings.surface = chosen.has(kSurface);
    settings.velocity = chosen.has(kVelocity);
    settings.density = chosen.has(kDensity);
    if (const std::string& box = options.format_option("box"); !box.empty()) {
        settings.box = read_box(box);
    }
    settings.voxel = read_voxel("voxel", options.format_option("voxel"));
    settings.velocity_voxel = read_voxel("velocity-voxel", options.format_option("velocity-voxel"));
    if (const std::string& type = options.format_option("type"); !type.empty()) {
        constexpr std::string_view kTypes[] = {"float", "half"};
        if (std::ranges::find(kTypes, type) == std::end(kTypes)) {
            refuse("--type " + type + ": allowed are float, half" + did_you_mean(type, kTypes));
        }
        settings.half_floats = type == "half";
    }
    settings.axes = read_up_axes(options, "a volume");
    const std::string& mist = options.format_option("mist");
    if (settings.density) {
        settings.spray = read_spray_settings(options);
        if (!mist.empty()) settings.mist = parse_number(mist, "--mist " + mist, 0.0, 1000.0);
    } else {
        refuse_spray_options(options, "spray or density");
        if (!mist.empty()) refuse("--mist " + mist + ": needs --products density");
    }
    return settings;
}

std::vector<const Product*> volume_products(const VolumeSettings& settings) {
    return settings.is_default ? std::vector{&kSurface} : settings.product_rows();
}

FrameMaps volume_maps(const BakePlan& draft, const VolumeSettings& settings) {
    FrameMaps maps{{}, {draft.resolution}};
    maps.sequential = settings.density;
    return maps;
}

VolumeSettings resolve_volumes(const BakePlan& draft, const VolumeSettings& requested) {
    VolumeSettings settings = requested;
    if (settings.is_default && draft.subject->kind() != kVelocity.subject) {
        settings.velocity = false;
    }
    const Domain domain = draft.subject->domain(draft.resolution);
    if (!settings.box || settings.to_the_crest()) {
        settings.heights = draft.subject->height_range(draft.maps_options());
    }
    if (settings.voxel == 0.0) settings.voxel = domain.step(0);
    if (settings.velocity_voxel == 0.0) settings.velocity_voxel = 2.0 * settings.voxel;
    if (!settings.box) {
        settings.box = {domain.origin[0],
                        domain.origin[1],
                        settings.heights.bottom,
                        domain.origin[0] + domain.size[0],
                        domain.origin[1] + domain.size[1],
                        std::nan("")};
    }
    return settings;
}

std::vector<BakeFile> list_volumes(const BakePlan& plan, const VolumeSettings& settings,
                                   int frame) {
    return {{plan.pattern.file(frame), frame, 0, settings.products()}};
}

std::vector<io::HeaderString> volume_strings(const BakePlan& plan, const VolumeSettings& settings,
                                             int frame) {
    std::vector<io::HeaderString> strings = io::provenance_strings(provenance_of(plan, frame));
    strings.push_back({"ocean:resolution", std::to_string(plan.resolution)});
    strings.push_back({"ocean:axes", std::string(io::axes_name(settings.axes))});
    strings.push_back({"ocean:field", settings.products()});
    strings.push_back({"ocean:box", settings.box_text()});
    strings.push_back({"ocean:voxel", shortest_text(settings.voxel)});
    strings.push_back({"ocean:velocity_voxel", shortest_text(settings.velocity_voxel)});
    strings.push_back({"ocean:type", settings.half_floats ? "half" : "float"});
    if (settings.density) {
        strings.push_back({"ocean:mist", shortest_text(settings.mist)});
        for (auto& string : spray_setting_strings(settings.spray)) {
            strings.push_back(std::move(string));
        }
    }
    strings.push_back({"ocean:units", settings.density ? "m, m/s, 1/m" : "m, m/s"});
    return strings;
}

std::string volume_recipe(const BakePlan& plan, const VolumeSettings& settings,
                          const BakeFile& file) {
    std::string lines =
        "vdb " + settings.products() + " " + settings.box_text() + " " +
        shortest_text(settings.voxel) + " " + shortest_text(settings.velocity_voxel) + " " +
        (settings.half_floats ? "half " : "float ") + std::string(io::axes_name(settings.axes));
    if (settings.density) {
        lines += " " + shortest_text(settings.mist);
        for (const auto& string : spray_setting_strings(settings.spray)) lines += " " + string.text;
    }
    return bake_recipe(plan, file.frame, lines + "\n");
}

void adopt_volumes(const BakedHeader& header, BakeOptions& options) {
    options.set_default("box", header.text("box"));
    options.set_default("voxel", header.text("voxel"));
    if (header.has(std::string(kSeaKind))) {  // other subjects do not have the option
        options.set_default("velocity-voxel", header.text("velocity_voxel"));
    }
    options.set_default("type", header.text("type"));
    if (!header.has("mist")) return;
    options.set_default("mist", header.text("mist"));
    adopt_spray_settings(header, options);
}

}  // namespace ocean
