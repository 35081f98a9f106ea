// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Writes the files that test_exr_readers.py judges: make_exr_samples FOLDER.
#include <cstdio>

#include "ocean/io.hpp"
#include "sample_surface.hpp"

using namespace ocean;

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    const std::string folder = std::string(argv[1]) + "/", sea = "libocean = 1\nseed = 3\n";
    const Surface surface = test::sample_surface(64);
    const io::Frame frame{surface, sea, 7, surface.time()};
    std::vector<const Product*> products;
    for (const Product& field : product_table()) {
        products.push_back(&field);
        const std::string name(field.name);
        io::write_exr(frame, field, folder + name + ".exr", {});
        io::ExrOptions half{.type = io::PixelType::half_float};
        io::write_exr(frame, field, folder + name + ".half.exr", half);
    }
    for (const char* axes : {"zup", "yup", "tnb"}) {
        const io::ExrOptions options{.axes = io::find_axes(axes)};
        io::write_exr(frame, find_product("velocity"), folder + axes + ".exr", options);
    }
    for (const char* name : {"none", "rle", "zips", "zip", "piz", "pxr24"}) {
        const io::ExrOptions options{.compression = io::find_exr_compression(name)};
        io::write_exr(frame, find_product("displacement"), folder + name + ".exr", options);
    }
    io::write_exr_layered(frame, products, folder + "layered.exr", {});
    return 0;
}
