// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// OpenEXR images: a file for each product, or one layered file of all of them. Its header is a
// function of the plan alone, so that a file tells by itself whether it is the one that the plan
// would write.
#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <optional>
#include <string_view>

#include "formats/formats.hpp"
#include "ocean/bake/plan.hpp"
#include "ocean/error.hpp"
#include "ocean/io/exr.hpp"
#include "ocean/io/product_image.hpp"
#include "products/made.hpp"
#include "sha256.hpp"
#include "source.hpp"

namespace ocean {
namespace {

constexpr const char* kDefaultProducts = "displacement,normal,foam";
constexpr const char* kUndisplacedProducts = "height";  // of a subject without dx and dy

struct Settings {
    std::vector<const Product*> products;
    bool usual = false;  // nobody asked for products
    io::ProductLayout layout;
    std::optional<io::ExrCompression> compression;  // none: what pays for each file
    std::vector<Made> made;                         // of those among the products

    /// The products of each file of a frame.
    std::size_t files() const { return layout.layered ? 1 : products.size(); }
    std::span<const Product* const> of_file(std::size_t part) const {
        return layout.layered ? std::span(products) : std::span(products).subspan(part, 1);
    }
    const Made* maker(const Product& product) const { return maker_of(product, made); }
};

const Settings& settings_of(const BakePlan& plan) {
    return std::any_cast<const Settings&>(plan.settings);
}

/// Returns "slope, foam and cover": the library's products with that value in that column.
template <typename Value>
std::string names_of(Value Product::*column, Value value) {
    std::vector<std::string> names;
    for (const Product& product : product_table()) {
        if (product.*column == value) names.emplace_back(product.name);
    }
    return listing(names, "and");
}

std::vector<FormatOption> list_options(const Catalogue& catalogue) {
    std::vector<FormatOption> options = {
        {"products", "LIST",
         "Of " + catalogue.product_names() + "; default " + std::string(kDefaultProducts)},
        {"type", "TYPE",
         "float or half; default: float for " + names_of(&Product::precision, Precision::full) +
             ", half for the rest"},
        {"axes", "AXES",
         "Order of vectors: tnb (x, z, y), zup (x, y, z), yup (x, z, -y); default tnb"},
        {"layout", "LAYOUT",
         "separate (a file for each product) or layered (one file); default separate"},
        {"compression", "CODEC",
         "none, rle, zips, zip, piz or pxr24; default rle for " +
             names_of(&Product::run_lengths, RunLengths::always) + " and for halves of " +
             names_of(&Product::run_lengths, RunLengths::of_halves) + ", none for the rest"},
    };
    std::ranges::move(made_options(catalogue), std::back_inserter(options));
    return options;
}

/// Returns run lengths where they pay for all products of a file.
io::ExrCompression usual_compression(std::span<const Product* const> products, io::PixelType type) {
    const auto pays = [type](const Product* product) {
        return product->run_lengths == RunLengths::always ||
               (product->run_lengths == RunLengths::of_halves && type == io::PixelType::half_float);
    };
    return std::all_of(products.begin(), products.end(), pays) ? io::ExrCompression::rle
                                                               : io::ExrCompression::none;
}

template <typename Value>
Value choose(const char* option, const std::string& text,
             std::initializer_list<std::pair<const char*, Value>> choices) {
    std::string allowed;
    for (const auto& [name, value] : choices) {
        if (text == name) return value;
        allowed += (allowed.empty() ? "" : ", ") + std::string(name);
    }
    throw Error(ErrorKind::invalid_value,
                std::string(option) + " " + text + ": allowed are " + allowed);
}

std::any read_options(const BakeOptions& options, const Catalogue& catalogue) {
    Settings settings;
    ChosenProducts chosen =
        choose_products(options, {.known = catalogue.products, .usual = kDefaultProducts});
    settings.usual = chosen.usual;
    settings.products = std::move(chosen.products);
    if (const std::string& layout = options.format_option("layout"); !layout.empty()) {
        settings.layout.layered =
            choose<bool>("--layout", layout, {{"separate", false}, {"layered", true}});
    }
    if (const std::string& axes = options.format_option("axes"); !axes.empty()) {
        settings.layout.axes = io::find_axes(axes);
    }
    if (const std::string& codec = options.format_option("compression"); !codec.empty()) {
        settings.compression = io::find_exr_compression(codec);
    }
    if (const std::string& type = options.format_option("type"); !type.empty()) {
        settings.layout.type = choose<io::PixelType>(
            "--type", type,
            {{"float", io::PixelType::full_float}, {"half", io::PixelType::half_float}});
    }
    settings.made = read_made(options, catalogue, settings.products, settings.layout.layered);
    return settings;
}

std::vector<const Product*> list_products(const BakePlan& begun) {
    return settings_of(begun).products;
}

FormatPlan settle(const BakePlan& begun) {
    Settings settings = settings_of(begun);
    const bool is_displaced = begun.subject->channels().contains({Channel::dx, Channel::dy});
    if (settings.usual && !is_displaced) settings.products = {&find_product(kUndisplacedProducts)};
    FormatPlan result{{{}, {begun.resolution}}, {}};
    for (Made& made : settings.made) {
        MadePlan<std::any> plan = made.of->settle(begun, made.settings, settings.products);
        settings.products = std::move(plan.products);
        made.settings = std::move(plan.settings);
        result.maps.channels = result.maps.channels | plan.channels;
    }
    for (const Product* product : settings.products) {
        if (settings.maker(*product) == nullptr) {
            result.maps.channels = result.maps.channels | product->set();
        }
        if (!settings.layout.layered) result.named_products.emplace_back(product->name);
    }
    result.settings = std::move(settings);
    return result;
}

/// Returns the image with what the makers of its products say of them.
io::Image labelled(io::Image image, const BakePlan& plan, const BakeFile& file) {
    const Settings& settings = settings_of(plan);
    for (const Product* product : settings.of_file(file.part)) {
        if (const Made* const made = settings.maker(*product)) {
            std::ranges::move(made->of->strings(plan, made->settings, file.frame, *product),
                              std::back_inserter(image.strings));
        }
    }
    return image;
}

/// The image of a file, without its samples.
io::Image image_of(const BakePlan& plan, const BakeFile& file) {
    const Settings& settings = settings_of(plan);
    const auto products = settings.of_file(file.part);
    const Made* const made = settings.maker(*products.front());
    const bool is_tile = made != nullptr && made->has_tiles();
    const int samples = is_tile ? made->of->tile_samples(made->settings) : plan.resolution;
    return labelled(
        io::product_image(products, settings.layout, provenance_of(plan, file.frame), samples),
        plan, file);
}

io::ExrCompression compression_of(const BakePlan& plan, const BakeFile& file,
                                  const io::Image& image) {
    const Settings& settings = settings_of(plan);
    if (settings.compression) return *settings.compression;
    return usual_compression(settings.of_file(file.part), image.planes.front().type);
}

std::string header_of(const BakePlan& plan, const BakeFile& file) {
    const io::Image image = image_of(plan, file);
    return io::exr_header_bytes(image, compression_of(plan, file, image));
}

std::vector<BakeFile> list_files(const BakePlan& plan, int frame) {
    const Settings& settings = settings_of(plan);
    std::vector<BakeFile> files;
    for (std::size_t part = 0; part < settings.files(); ++part) {
        BakeFile file{"", frame, part, ""};
        for (const Product* product : settings.of_file(part)) {
            file.product += (file.product.empty() ? "" : ",") + std::string(product->name);
        }
        file.path = plan.pattern.file(frame, plan.product_in_name ? file.product : "");
        files.push_back(std::move(file));
    }
    return files;
}

std::string recipe(const BakePlan& plan, const BakeFile& file) {
    return sha256_hex(header_of(plan, file));
}

std::uint64_t most_bytes(const BakePlan& plan, const BakeFile& file) {
    const io::Image image = image_of(plan, file);
    return io::most_exr_bytes(image, compression_of(plan, file, image));
}

bool is_baked(const BakeFile& file) {
    try {
        const auto header = io::read_exr_header(file.path);
        return std::ranges::any_of(header, [](const io::HeaderString& string) {
            return string.name == "ocean:sea" || string.name == "ocean:frame";
        });
    } catch (const Error&) {
        return false;
    }
}

std::uint64_t frame_bytes(const BakePlan& plan) {
    const Settings& settings = settings_of(plan);
    std::uint64_t bytes = 0;
    for (const Made& made : settings.made) bytes += made.of->frame_bytes(plan, made.settings);
    return bytes;
}

void write(const FrameWork& work, std::span<const BakeFile> files) {
    const Settings& settings = settings_of(work.plan);
    std::vector<MadeFrame> frames;
    for (const Made& made : settings.made) frames.push_back(made.of->make(work, made.settings));
    for (const BakeFile& file : files) {
        const auto products = settings.of_file(file.part);
        const Surface* surface = &work.maps.front();
        std::vector<MadeSamples> samples(products.size());
        std::vector<io::MadeMap> maps;
        for (std::size_t i = 0; i < products.size(); ++i) {
            const Made* const made = settings.maker(*products[i]);
            if (made == nullptr) continue;
            samples[i] =
                frames[static_cast<std::size_t>(made - settings.made.data())](*products[i]);
            maps.push_back({products[i], samples[i].map});
            if (made->has_tiles()) surface = &samples[i].tile;
        }
        const io::Image image = labelled(
            io::product_image(products, settings.layout, work.provenance(), *surface, maps),
            work.plan, file);
        const io::ExrCompression compression = compression_of(work.plan, file, image);
        work.put(file, [&] { io::write_exr(image, file.path, compression, work.threads); });
    }
}

bool read_pixels(const BakePlan& plan, const BakeFile& file, int threads,
                 const io::ByteSink& sink) {
    io::read_exr_pixels(file.path, header_of(plan, file), threads, sink);
    return true;
}

// ---- --from ----

/// The layout and the type that give the file's channels; the default, where it does, stays unsaid.
void adopt_channels(const io::ExrLayout& stored, std::span<const Product* const> products,
                    BakeOptions& options) {
    for (const bool layered : {false, true}) {
        for (const auto& [type, name] :
             {std::pair<std::optional<io::PixelType>, const char*>(std::nullopt, ""),
              {io::PixelType::half_float, "half"},
              {io::PixelType::full_float, "float"}}) {
            if (!layered && products.size() > 1) continue;
            const io::ProductLayout layout{.type = type, .layered = layered};
            if (io::exr_channels(io::product_image(products, layout, {}, 1)) != stored.channels)
                continue;
            options.take("layout", layered ? "layered" : "separate");
            options.take("type", name);
            return;
        }
    }
    refuse_source(options.from, "its channels are not those that `ocean bake` writes");
}

void adopt(const BakedHeader& header, const Catalogue& catalogue, BakeOptions& options) {
    const io::ExrLayout& stored = header.layout();
    const std::vector<const Product*> products = find_products(header.text("field"), catalogue);
    // What is no vector looks the same in all axes, and its header says nothing of them.
    const auto is_vector = [](const Product* product) { return product->vector; };
    if (std::any_of(products.begin(), products.end(), is_vector)) {
        options.take("axes", header.text("axes"));
    }
    const auto typed = [&](const char* name) { return !options.format_option(name).empty(); };
    if (!typed("type") || !typed("layout")) adopt_channels(stored, products, options);
    if (!typed("compression")) {
        if (!stored.compression) {
            refuse_source(options.from, "`ocean bake` does not have its compression");
        }
        // What is usual for that file stays unsaid: other products may have another.
        if (*stored.compression != usual_compression(products, stored.channels.front().type)) {
            options.take("compression", io::exr_compression_name(*stored.compression));
        }
    }
    options.take("products", header.text("field"));
    for (const MadeProduct* made : catalogue.made) {
        if (made->is_among(products) &&
            made->is_among(find_products(options.format_option("products"), catalogue))) {
            made->adopt(header, options);
        }
    }
}

}  // namespace

const BakeFormat kExrFormat = {
    .name = "exr",
    .extension = ".exr",
    .family = "EXR files",
    .options = list_options,
    .read_options = read_options,
    .products = list_products,
    .settle = settle,
    .files = list_files,
    .recipe = recipe,
    .is_baked = is_baked,
    .frame_bytes = frame_bytes,
    .most_bytes = most_bytes,
    .write = write,
    .read_pixels = read_pixels,
    .tells_its_recipe = true,
    .read_header = io::read_exr_header,
    .adopt = adopt,
};

}  // namespace ocean
