// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean` with a format and a channel of somebody else, who has the libraries alone: a channel
// `steepness`, the size of the slope, and a format .stats, a text of the rms of each product.
#include <cmath>
#include <fstream>
#include <sstream>

#include "ocean/bake/catalogue.hpp"
#include "ocean/bake/plan.hpp"
#include "ocean/error.hpp"
#include "ocean/io/output_file.hpp"
#include "ocean/text.hpp"
#include "ocean_program.hpp"

using namespace ocean;

namespace {

constexpr Channel kSteepness{kChannelCount};
const ChannelInfo kToyChannels[] = {
    {"steepness",
     "",
     {Linear::slope_x, Linear::slope_y},
     {Linear::slope_x, Linear::slope_y},
     {[](const auto& point) {
         return std::sqrt(point[Linear::slope_x] * point[Linear::slope_x] +
                          point[Linear::slope_y] * point[Linear::slope_y]);
     }}},
};

std::vector<FormatOption> list_options(const Catalogue&) {
    return {{"digits", "N", "Decimals of a number; default 3"}};
}

std::any read_options(const BakeOptions& options, const Catalogue&) {
    const std::string& digits = options.format_option("digits");
    return digits.empty() ? 3 : parse_whole_number(digits, "--digits", 1, 9);
}

FormatPlan settle(const BakePlan& begun) {
    return {{{Channel::height, kSteepness}, {begun.resolution}}, begun.settings};
}

std::vector<BakeFile> list_files(const BakePlan& plan, int frame) {
    return {{plan.pattern.file(frame), frame, 0, "height,steepness"}};
}

std::string recipe(const BakePlan& plan, const BakeFile& file) {
    const int digits = std::any_cast<int>(plan.settings);
    return bake_recipe(plan, file.frame, format_text("digits %d\n", digits));
}

bool is_baked(const BakeFile& file) {
    double first = 0.0;
    return static_cast<bool>(std::ifstream(file.path) >> first);
}

std::uint64_t most_bytes(const BakePlan&, const BakeFile&) {
    return 100;
}

double rms(std::span<const float> map) {
    double sum = 0.0;
    for (const float value : map) sum += static_cast<double>(value) * value;
    return std::sqrt(sum / static_cast<double>(map.size()));
}

void write(const FrameWork& work, std::span<const BakeFile> files) {
    const int digits = std::any_cast<int>(work.plan.settings);
    std::string text;
    for (const Channel channel : {Channel::height, kSteepness}) {
        text += format_text("%.*f\n", digits, rms(work.maps.front().channel(channel)));
    }
    work.put(files[0], [&] { io::write_file_atomically(files[0].path, text); });
}

/// Whoever writes "0.1" and who writes "0.10" means the same.
bool read_pixels(const BakePlan&, const BakeFile& file, int, const io::ByteSink& sink) {
    std::ifstream stream(file.path);
    for (double value = 0.0; stream >> value;) sink(format_text("%.9f", value));
    if (!stream.eof()) throw Error(ErrorKind::bad_file, "no numbers are in " + file.path);
    return true;
}

const BakeFormat kStatsFormat = {
    .name = "stats",
    .extension = ".stats",
    .family = "Statistics",
    .options = list_options,
    .read_options = read_options,
    .settle = settle,
    .files = list_files,
    .recipe = recipe,
    .is_baked = is_baked,
    .most_bytes = most_bytes,
    .write = write,
    .read_pixels = read_pixels,
};

}  // namespace

int main(int argc, char** argv) {
    const Catalogue& ours = standard_catalogue();
    std::vector<const BakeFormat*> formats(ours.formats.begin(), ours.formats.end());
    formats.push_back(&kStatsFormat);
    std::vector<Product> products(ours.products.begin(), ours.products.end());
    products.push_back({"steepness", {kSteepness}, 1, ""});
    const Catalogue catalogue{formats, products, ours.backends, ours.subjects, kToyChannels};
    return app::run_ocean(argc, argv, catalogue);
}
