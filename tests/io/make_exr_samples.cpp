// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Writes the files that test_exr_readers.py judges: make_exr_samples FOLDER.
#include "ocean/internal/io/product_image.hpp"
#include "ocean/io/exr.hpp"
#include "sample_surface.hpp"

using namespace ocean;

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    const std::string folder = std::string(argv[1]) + "/";
    const Surface surface = test::sample_surface(64);
    const io::Provenance label{.kind = "sea",
                               .text = "libocean = 1\nseed = 3\n",
                               .frame = 7,
                               .time = surface.time(),
                               .domain = Domain::tile(surface.period()),
                               .backend = "cpu"};
    const auto write = [&](std::vector<const Product*> products, const io::ProductLayout& layout,
                           const std::string& name, const char* codec = "zip") {
        io::write_exr(io::product_image(products, layout, label, surface), folder + name + ".exr",
                      io::find_exr_compression(codec));
    };
    std::vector<const Product*> all;
    for (const Product& product : kProducts) {
        all.push_back(&product);
        const std::string name(product.name);
        write({&product}, {}, name);
        write({&product}, {.type = io::PixelType::half_float}, name + ".half");
    }
    for (const char* axes : {"zup", "yup", "tnb"}) {
        write({&find_product("velocity")}, {.axes = io::find_axes(axes)}, axes);
    }
    for (const char* codec : {"none", "rle", "zips", "zip", "piz", "pxr24"}) {
        write({&find_product("displacement")}, {}, codec, codec);
    }
    write(all, {.layered = true}, "layered");
    return 0;
}
