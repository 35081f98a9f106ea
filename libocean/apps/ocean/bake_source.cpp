// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// From the header of a baked file back to the options that made it; see bake_source.hpp. What a
// header says becomes text in the place of an option that was not typed, so that it is checked as
// if it had been.
#include "bake_source.hpp"

#include <algorithm>
#include <charconv>
#include <map>

#include "ocean/cascades.hpp"
#include "ocean/error.hpp"
#include "ocean/seafile.hpp"
#include "text.hpp"

namespace ocean::app {
namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& reason) {
    throw Error(ErrorKind::bad_file, "--from " + path + ": " + reason);
}

class Header {
  public:
    explicit Header(const std::string& path) : path_(path) {
        for (auto& [name, text] : io::read_exr_header(path)) strings_[name] = text;
    }

    const std::string& text(const std::string& name) const {
        const auto found = strings_.find("ocean:" + name);
        if (found == strings_.end()) refuse(path_, "its header has no ocean:" + name);
        return found->second;
    }
    bool has(const std::string& name) const { return strings_.contains("ocean:" + name); }

    template <typename Number>
    Number number(const std::string& name) const {
        const std::string& digits = text(name);
        Number value{};
        const char* end = digits.data() + digits.size();
        const auto [stop, code] = std::from_chars(digits.data(), end, value);
        if (code != std::errc() || stop != end)
            refuse(path_, "its ocean:" + name + " is no number");
        return value;
    }

  private:
    const std::string& path_;
    std::map<std::string, std::string> strings_;
};

std::vector<const Product*> products_of(const std::string& list) {
    std::vector<const Product*> products;
    for (const std::string& name : split(list, ',')) products.push_back(&find_product(name));
    return products;
}

void take(std::string& option, std::string_view value) {
    if (option.empty()) option = value;
}

/// The layout and the type that give these channels; the default, where it does, stays unsaid.
void take_channels(BakeOptions& options, const std::vector<const Product*>& products,
                   const io::ExrLayout& image) {
    for (const bool layered : {false, true}) {
        for (const auto& [type, name] :
             {std::pair(io::PixelType::automatic, ""), std::pair(io::PixelType::half_float, "half"),
              std::pair(io::PixelType::full_float, "float")}) {
            if (!layered && products.size() > 1) continue;
            if (io::exr_channels(products, layered, type) != image.channels) continue;
            take(options.layout, layered ? "layered" : "separate");
            return take(options.type, name);
        }
    }
    refuse(options.from, "its channels are not those that `ocean bake` writes");
}

void take_exr_options(BakeOptions& options, const Header& header, const io::ExrLayout& image) {
    const std::vector<const Product*> products = products_of(header.text("field"));
    const auto is_vector = [](const Product* product) { return product->count == 3; };
    // Scalars look the same in all axes, so that their header says nothing of vectors.
    if (std::any_of(products.begin(), products.end(), is_vector)) {
        take(options.axes, header.text("axes"));
    }
    if (options.type.empty() || options.layout.empty()) take_channels(options, products, image);
    if (options.compression.empty()) {
        if (!image.compression) refuse(options.from, "`ocean bake` does not have its compression");
        options.compression = io::exr_compression_name(*image.compression);
    }
    take(options.products, header.text("field"));
}

/// A file whose time is not its frame's was not baked, and would not come out again.
void check_time(const Sea& sea, const Header& header, const std::string& path) {
    if (sea.time_of(header.number<int>("frame")) == header.number<double>("time")) return;
    refuse(path, "its ocean:time is not that of its ocean:frame");
}

}  // namespace

BakeOptions with_source(BakeOptions options) {
    if (options.from.empty() == options.sea.source.empty()) {
        throw Error(ErrorKind::invalid_value, "bake: give SEA or --from FRAME.exr, one of them");
    }
    if (options.from.empty()) return options;
    options.sea.source = options.from;
    const Header header(options.from);
    const io::ExrLayout image = io::read_exr_layout(options.from);
    const Sea sea = parse_sea(header.text("sea"), options.from, "");
    check_time(sea, header, options.from);
    take(options.frames, std::to_string(header.number<int>("frame")));
    // Where the sea's own resolution was used, a changed sea may change it.
    if (image.resolution != default_map_resolution(sea.parameters.grid)) {
        take(options.resolution, std::to_string(image.resolution));
    }
    if (header.has("backend")) take(options.backend, header.text("backend"));
    if (OutputPattern(options.output).extension() == ".exr") {
        take_exr_options(options, header, image);
    }
    return options;
}

}  // namespace ocean::app
