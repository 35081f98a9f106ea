// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean` with a channel and a format of a host that has only the public headers and the libraries:
// a channel `steepness`, the magnitude of the slope, and a format .stats, a text with the root mean
// square of each product.
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "ocean/bake/catalogue.hpp"
#include "ocean/bake/typed_format.hpp"
#include "ocean/error.hpp"
#include "ocean_program.hpp"

using namespace ocean;

namespace {

constexpr Channel kSteepness{kChannelCount};
const ChannelInfo kPluginChannels[] = {
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

struct StatsSettings {
    int digits = 3;
};

/// Returns the number as text, with a decimal point in any locale.
std::string text_of(double number, int digits) {
    std::array<char, 64> text{};
    const auto written = std::to_chars(text.data(), text.data() + text.size(), number,
                                       std::chars_format::fixed, digits);
    return {text.data(), written.ptr};
}

StatsSettings read_options(const BakeOptions& options, const Catalogue&) {
    const std::string& digits = options.format_option("digits");
    if (digits.empty()) return {};
    StatsSettings settings;
    const char* const end = digits.data() + digits.size();
    const auto [stop, fault] = std::from_chars(digits.data(), end, settings.digits);
    if (fault == std::errc() && stop == end && settings.digits >= 1 && settings.digits <= 9) {
        return settings;
    }
    throw Error(ErrorKind::invalid_value,
                {.parameter = "--digits", .value = digits, .allowed = "a number, 1 .. 9"});
}

FormatPlan<StatsSettings> resolve(const BakePlan& draft, const StatsSettings& requested) {
    return {{{Channel::height, kSteepness}, {draft.resolution}}, requested};
}

std::vector<BakeFile> list_files(const BakePlan& plan, const StatsSettings&, int frame) {
    return {{plan.pattern.file(frame), frame, 0, "height,steepness"}};
}

std::string recipe(const BakePlan& plan, const StatsSettings& settings, const BakeFile& file) {
    return bake_recipe(plan, file.frame, "digits " + std::to_string(settings.digits) + "\n");
}

bool is_baked(const BakeFile& file) {
    double first = 0.0;
    return static_cast<bool>(std::ifstream(file.path) >> first);
}

std::uint64_t max_bytes(const BakePlan&, const StatsSettings&, const BakeFile&) {
    return 100;
}

double rms(std::span<const float> map) {
    double sum = 0.0;
    for (const float value : map) sum += static_cast<double>(value) * value;
    return std::sqrt(sum / static_cast<double>(map.size()));
}

void write(const FrameWork& work, const StatsSettings& settings, std::span<const BakeFile> files) {
    std::string text;
    for (const Channel channel : {Channel::height, kSteepness}) {
        text += text_of(rms(work.maps.front().channel(channel)), settings.digits) + "\n";
    }
    work.write_and_verify(files[0], [&] {
        std::ofstream stream(files[0].path);
        if (stream << text << std::flush) return;
        throw Error(ErrorKind::output, files[0].path + ": cannot be written");
    });
}

/// Passes on the numbers, so that "0.1" and "0.10" have the same hash.
bool read_pixels(const BakePlan&, const StatsSettings&, const BakeFile& file, int,
                 const io::ByteSink& sink) {
    std::ifstream stream(file.path);
    for (double value = 0.0; stream >> value;) sink(text_of(value, 9));
    if (!stream.eof()) throw Error(ErrorKind::bad_file, "no numbers are in " + file.path);
    return true;
}

constexpr BakeFormatOf<StatsSettings> kStatsFormatOf = {
    .name = "stats",
    .extension = ".stats",
    .family = "Statistics",
    .options = list_options,
    .read_options = read_options,
    .resolve = resolve,
    .files = list_files,
    .recipe = recipe,
    .is_baked = is_baked,
    .max_bytes = max_bytes,
    .write = write,
    .read_pixels = read_pixels,
};
constexpr BakeFormat kStatsFormat = bake_format<kStatsFormatOf>();

}  // namespace

int main(int argc, char** argv) {
    const Catalogue& standard = standard_catalogue();
    std::vector<const BakeFormat*> formats(standard.formats.begin(), standard.formats.end());
    formats.push_back(&kStatsFormat);
    std::vector<Product> products(standard.products.begin(), standard.products.end());
    products.push_back({"steepness", {kSteepness}, 1, ""});
    const Catalogue catalogue{formats, products, standard.backends, standard.subjects,
                              kPluginChannels};
    return app::run_ocean(argc, argv, catalogue);
}
