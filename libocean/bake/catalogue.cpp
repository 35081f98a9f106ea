// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The library's own tables; see catalogue.hpp. A new format or family of made products is one line
// here.
#include "ocean/bake/catalogue.hpp"

#include "formats/formats.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/seafile.hpp"
#include "ocean/terrainfile.hpp"
#include "products/products.hpp"

namespace ocean {

std::string listing(const std::vector<std::string>& words, std::string_view conjunction) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const bool last = i + 1 == words.size();
        if (i > 0) text += last ? " " + std::string(conjunction) + " " : ", ";
        text += words[i];
    }
    return text;
}

const BakeFormat* Catalogue::find_format(std::string_view extension) const {
    for (const BakeFormat* format : formats) {
        if (format->extension == extension) return format;
    }
    return nullptr;
}

const BakeFormat* Catalogue::find_format_of_frame(std::string_view extension) const {
    for (const BakeFormat* format : formats) {
        const bool own = !format->frame_extension.empty();
        if ((own ? format->frame_extension : format->extension) == extension) return format;
    }
    return nullptr;
}

std::string Catalogue::format_labels(bool displaced) const {
    std::string text;
    for (const BakeFormat* format : formats) {
        if (displaced && !format->holds_displaced) continue;
        text += (text.empty() ? "" : ", ") + std::string(format->label);
    }
    return text;
}

std::string Catalogue::backend_names() const {
    std::vector<std::string> words;
    for (const Backend& backend : backends) words.emplace_back(backend.name);
    words.emplace_back(kAutoBackend);
    return listing(words, "or");
}

std::vector<Product> all_products(std::span<const Product> of_channels,
                                  std::span<const MadeProduct* const> made) {
    std::vector<Product> all(of_channels.begin(), of_channels.end());
    for (const MadeProduct* family : made) {
        all.insert(all.end(), family->products.begin(), family->products.end());
    }
    return all;
}

const Catalogue& standard_catalogue() {
    static constexpr const BakeFormat* kFormats[] = {
        &kExrFormat,     &kDf3Format, &kHeightFieldFormat, &kMesh2Format,
        &kPlyFormat,     &kObjFormat, &kUsdFormat,
#ifdef OCEAN_HAVE_OPENVDB
        &kVdbFormat,
#endif
#ifdef OCEAN_HAVE_TIFF
        &kGeotiffFormat,
#endif
    };
    static constexpr const MadeProduct* kMade[] = {&kCaustics, &kSlopeTiles, &kTerrainStages};
    static constexpr const char* kVolumeOptions[] = {"box", "voxel", "velocity-voxel", "mist"};
    static constexpr FormatLibrary kLibraries[] = {
        {".vdb", "OpenVDB", "Volumes VDB", kVolumeOptions},
        {".tif", "libtiff", "GeoTIFF"},
    };
    static const std::vector<Product> products = all_products(product_table(), kMade);
    static constexpr SubjectReader kSubjects[] = {{kSeaKind, parse_sea_subject},
                                                  {kTerrainKind, parse_terrain_subject}};
    static const Catalogue catalogue{kFormats, products, core_backends(), kSubjects,
                                     {},       kMade,    kLibraries};
    return catalogue;
}

}  // namespace ocean
