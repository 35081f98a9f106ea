// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The bed of a sea for POV-Ray scenes, in the words that terrain.inc reads: the bed is the land of
// a coast above water and below.
#include <algorithm>
#include <span>
#include <string>
#include <string_view>

#include "ocean/internal/io/df3.hpp"
#include "ocean/internal/io/povray_declarations.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/land_mask.hpp"
#include "ocean/version.hpp"

namespace ocean::io {

std::string povray_mask_declarations(std::span<const Channel> masks, std::string_view prefix) {
    const std::string declare = "#declare " + std::string(prefix);
    std::string text = declare + "Masks_ = " + std::to_string(masks.size()) + ";\n";
    for (const Product& mask : kMaskProducts) {
        const auto slice = std::ranges::find(masks, mask.channels[0]);
        std::string name(mask.name);
        name.front() = static_cast<char>(name.front() - 'a' + 'A');
        text += declare + name + "_Slice_ = " +
                (slice == masks.end() ? "-1" : std::to_string(slice - masks.begin())) + ";\n";
    }
    return text;
}

std::string povray_bed_parameters(const PovrayBed& bed) {
    return "//   Persistence of Vision Ray Tracer Include File\n"
           "//   File: terrain_parameters.inc\n"
           "//   Vers: 3.7\n"
           "//   Desc: The bed of the sea of this folder, by libocean " OCEAN_VERSION
           ". Each export writes it\n"
           "//         again: change the sea file instead. Metres over still water.\n"
           "#declare Terrain_Data_Version = " +
           std::to_string(kPovrayTerrainVersion) + ";\n#declare Terrain_Id_ = \"" +
           std::string(bed.id) + "\";  // its map says the same\n" +
           "#declare Terrain_Format = \"df3\";\n" + povray_land_map_declarations(bed.map.domain()) +
           "#declare Terrain_Water_Level = 0;  // m\n";
}

std::string povray_bed_words(const PovrayBed& bed) {
    const Domain& domain = bed.map.domain();
    const Df3Heights heights = df3_heights(bed.map);
    const std::string base = shortest_text(heights.base), scale = shortest_text(heights.scale);
    return "// A frame for POV-Ray: the data that Terrain_Load reads.\n"
           "#declare Terrain_Frame_Terrain_ = \"" +
           std::string(bed.id) + "\";\n#declare Terrain_Base_ = " + base +
           ";  // m, the minimal height\n#declare Terrain_Scale_ = " + scale +
           ";  // m\n#declare Terrain_Levels_ = array[1] { <" + shortest_text(domain.step(0)) +
           ", " + std::to_string(domain.samples[0]) + ", " + std::to_string(domain.samples[1]) +
           "> };  // cell [m], columns, rows of the map\n"
           "#declare Terrain_Level_Codes_ = array[1] { <" +
           base + ", " + scale + ", 0> };  // base and scale [m]\n" +
           povray_mask_declarations(bed.masks, "Terrain_");
}

}  // namespace ocean::io
