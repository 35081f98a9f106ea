// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A program that bakes a format of its own: a text with the height of the highest sample.
// usage: height SEA FILE
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <ocean/bake/run.hpp>
#include <ocean/bake/typed_format.hpp>
#include <ocean/error.hpp>
#include <ocean/seafile.hpp>
#include <span>
#include <string>
#include <vector>

using namespace ocean;

namespace {

constexpr BakeFormatOf<NoSettings> kPeakOf = {
    .name = "peak",
    .extension = ".peak",
    .family = "Peaks",
    .read_options = +[](const BakeOptions&, const Catalogue&) { return NoSettings{}; },
    .resolve =
        +[](const BakePlan& draft, const NoSettings& none) {
            return FormatPlan<NoSettings>{{{Channel::height}, {draft.resolution}}, none};
        },
    .files =
        +[](const BakePlan& plan, const NoSettings&, int frame) {
            return std::vector<BakeFile>{{plan.pattern.file(frame), frame, 0, "height"}};
        },
    .recipe = +[](const BakePlan& plan, const NoSettings&,
                  const BakeFile& file) { return bake_recipe(plan, file.frame); },
    .is_baked = +[](const BakeFile&) { return false; },
    .max_bytes =
        +[](const BakePlan&, const NoSettings&, const BakeFile&) { return std::uint64_t{32}; },
    .write =
        +[](const FrameWork& work, const NoSettings&, std::span<const BakeFile> files) {
            const auto heights = work.maps.front().channel(Channel::height);
            work.write_and_verify(files[0], [&] {
                std::ofstream(files[0].path) << *std::ranges::max_element(heights) << '\n';
            });
        },
};
constexpr BakeFormat kPeak = bake_format<kPeakOf>();

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) return std::fputs("usage: height SEA FILE\n", stderr), 1;
    try {
        const BakeFormat* const formats[] = {&kPeak};
        Catalogue catalogue = standard_catalogue();
        catalogue.formats = formats;
        BakeOptions options;
        options.source = argv[1];
        options.output = argv[2];
        options.frames = "1";
        options.open_subject = [](const std::string& path) { return make_subject(read_sea(path)); };
        BakeHost host;
        run_bake(make_bake_plan(options, catalogue), host);
    } catch (const Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
