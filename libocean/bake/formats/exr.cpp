// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// OpenEXR images: a file for each product, or one layered file of all of them. The header of a file
// is a function of the plan alone, so that it proves whether the plan would write the same file.
#include <algorithm>
#include <initializer_list>
#include <iterator>

#include "formats/formats.hpp"
#include "ocean/bake/typed_format.hpp"
#include "ocean/internal/io/product_image.hpp"
#include "ocean/internal/nearest_name.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/io/exr.hpp"
#include "ocean/land_mask.hpp"
#include "products/requested_families.hpp"
#include "refuse.hpp"
#include "sha256.hpp"
#include "source.hpp"

namespace ocean {
namespace {

constexpr const char* kDefaultProducts = "displacement,normal,foam";
constexpr const char* kUndisplacedProducts = "height";  // of a subject that is not displaced

struct ExrSettings {
    std::vector<const Product*> products;
    bool is_default = false;  // --products was not given
    io::ProductLayout layout;
    std::optional<io::ExrCompression> compression;  // absent: chosen for each file
    std::vector<RequestedFamily> families;          // families that make some of the products

    std::size_t files() const { return layout.layered ? 1 : products.size(); }
    /// Returns the products of one file of a frame.
    std::span<const Product* const> products_of_file(std::size_t part) const {
        return layout.layered ? std::span(products) : std::span(products).subspan(part, 1);
    }
    const RequestedFamily* maker(const Product& product) const {
        return maker_of(product, families);
    }
};

/// Returns the names of the library's products with that value in that column: "slope, foam and
/// cover"; "masks" for all masks of lands.
template <typename Value>
std::string names_of(Value Product::*column, Value value) {
    std::vector<std::string> names;
    std::vector<std::string> masks;
    for (const Product& product : product_table()) {
        if (product.*column != value) continue;
        (is_mask(product.channels[0]) ? masks : names).emplace_back(product.name);
    }
    if (masks.size() == kMaskProducts.size()) masks = {"masks"};
    names.insert(names.end(), masks.begin(), masks.end());
    return listing(names, "and");
}

std::vector<FormatOption> list_options(const Catalogue& catalogue) {
    std::vector<FormatOption> options = {
        {"products", "LIST",
         "Comma list of products, listed above; default " + std::string(kDefaultProducts)},
        {"type", "TYPE",
         "float or half; default: float for " + names_of(&Product::precision, Precision::full) +
             ", and for the height of a terrain; half for the rest"},
        {"axes", "AXES",
         "Order of vectors: tnb (x, z, y), zup (x, y, z), yup (x, z, -y); default tnb"},
        {"layout", "LAYOUT",
         "separate (a file for each product) or layered (one file); default separate"},
        {"compression", "CODEC",
         "none, rle, zips, zip, piz or pxr24; default rle for " +
             names_of(&Product::run_lengths, RunLengths::always) + ", for halves of " +
             names_of(&Product::run_lengths, RunLengths::of_halves) + ", else none"},
    };
    std::ranges::move(family_options(catalogue), std::back_inserter(options));
    return options;
}

/// Returns run-length compression if it saves space for all products of a file, else no
/// compression.
io::ExrCompression default_compression(std::span<const Product* const> products,
                                       io::PixelType type) {
    const auto saves = [type](const Product* product) {
        return product->run_lengths == RunLengths::always ||
               (product->run_lengths == RunLengths::of_halves && type == io::PixelType::half_float);
    };
    return std::all_of(products.begin(), products.end(), saves) ? io::ExrCompression::rle
                                                                : io::ExrCompression::none;
}

template <typename Value>
Value choose(const char* option, const std::string& text,
             std::initializer_list<std::pair<const char*, Value>> choices) {
    using Choice = std::pair<const char*, Value>;
    for (const auto& [name, value] : choices) {
        if (text == name) return value;
    }
    refuse(std::string(option) + " " + text + ": allowed are " +
           joined(choices, ", ", &Choice::first) + did_you_mean(text, choices, &Choice::first));
}

std::optional<ProductChoice> product_choice(const Catalogue& catalogue) {
    return ProductChoice{.known = catalogue.products, .default_list = kDefaultProducts};
}

ExrSettings read_options(const BakeOptions& options, const Catalogue& catalogue) {
    ExrSettings settings;
    ChosenProducts chosen = choose_products(options, *product_choice(catalogue));
    settings.is_default = chosen.is_default;
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
    settings.families =
        read_families(options, catalogue, settings.products, settings.layout.layered);
    return settings;
}

std::vector<const Product*> list_products(const BakePlan&, const ExrSettings& settings) {
    return settings.products;
}

FormatPlan<ExrSettings> resolve(const BakePlan& draft, const ExrSettings& requested) {
    ExrSettings settings = requested;
    settings.layout.full_heights = !is_displaced(*draft.subject);
    if (settings.is_default && !is_displaced(*draft.subject)) {
        settings.products = {&find_product(kUndisplacedProducts)};
    }
    FormatPlan<ExrSettings> result{{{}, {draft.resolution}}, {}};
    for (RequestedFamily& family : settings.families) {
        MadePlan<ErasedSettings> plan =
            family.row->resolve(draft, family.settings, settings.products);
        settings.products = std::move(plan.products);
        family.settings = std::move(plan.settings);
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

/// Returns the image with the header strings of the families that make its products, and with the
/// map's resolution unless it is a tile.
io::Image with_more_strings(io::Image image, const BakePlan& plan, const ExrSettings& settings,
                            const BakeFile& file) {
    if (!plan.domain().is_tile()) {
        image.strings.push_back({"ocean:resolution", std::to_string(plan.resolution)});
    }
    for (const Product* product : settings.products_of_file(file.part)) {
        if (const RequestedFamily* const family = settings.maker(*product)) {
            std::ranges::move(family->row->strings(plan, family->settings, file.frame, *product),
                              std::back_inserter(image.strings));
        }
    }
    return image;
}

/// Returns the image of a file without its samples.
io::Image image_of(const BakePlan& plan, const ExrSettings& settings, const BakeFile& file) {
    const auto products = settings.products_of_file(file.part);
    const RequestedFamily* const family = settings.maker(*products.front());
    const bool is_tile = family != nullptr && family->has_tiles();
    const int samples =
        is_tile ? family->row->tile_samples(family->settings) : plan.domain().samples[0];
    return with_more_strings(
        io::product_image(products, settings.layout, provenance_of(plan, file.frame), samples),
        plan, settings, file);
}

io::ExrCompression compression_of(const ExrSettings& settings, const BakeFile& file,
                                  const io::Image& image) {
    if (settings.compression) return *settings.compression;
    return default_compression(settings.products_of_file(file.part), image.planes.front().type);
}

std::string header_of(const BakePlan& plan, const ExrSettings& settings, const BakeFile& file) {
    const io::Image image = image_of(plan, settings, file);
    return io::exr_header_bytes(image, compression_of(settings, file, image));
}

std::vector<BakeFile> list_files(const BakePlan& plan, const ExrSettings& settings, int frame) {
    std::vector<BakeFile> files;
    for (std::size_t part = 0; part < settings.files(); ++part) {
        const std::string products = joined(settings.products_of_file(part), ",", &Product::name);
        BakeFile file{"", frame, part, products};
        file.path = plan.pattern.file(frame, plan.product_in_name ? file.product : "");
        files.push_back(std::move(file));
    }
    return files;
}

std::string recipe(const BakePlan& plan, const ExrSettings& settings, const BakeFile& file) {
    return sha256_hex(header_of(plan, settings, file));
}

std::uint64_t max_bytes(const BakePlan& plan, const ExrSettings& settings, const BakeFile& file) {
    const io::Image image = image_of(plan, settings, file);
    return io::max_exr_bytes(image, compression_of(settings, file, image));
}

bool is_baked(const BakeFile& file) {
    return std::ranges::any_of(
        header_or_none(io::read_exr_header, file.path), [](const io::HeaderString& string) {
            return string.name == "ocean:sea" || string.name == "ocean:frame";
        });
}

std::uint64_t frame_bytes(const BakePlan& plan, const ExrSettings& settings) {
    std::uint64_t bytes = 0;
    for (const RequestedFamily& family : settings.families) {
        bytes += family.row->frame_bytes(plan, family.settings);
    }
    return bytes;
}

void write(const FrameWork& work, const ExrSettings& settings, std::span<const BakeFile> files) {
    std::vector<MadeFrame> frames;
    for (const RequestedFamily& family : settings.families) {
        frames.push_back(family.row->make(work, family.settings));
    }
    for (const BakeFile& file : files) {
        const auto products = settings.products_of_file(file.part);
        const Surface* surface = &work.maps.front();
        std::vector<MadeSamples> samples(products.size());
        std::vector<io::MadeMap> maps;
        for (std::size_t i = 0; i < products.size(); ++i) {
            const RequestedFamily* const family = settings.maker(*products[i]);
            if (family == nullptr) continue;
            samples[i] =
                frames[static_cast<std::size_t>(family - settings.families.data())](*products[i]);
            maps.push_back({products[i], samples[i].map});
            if (family->has_tiles()) surface = &samples[i].tile;
        }
        const io::Image image = with_more_strings(
            io::product_image(products, settings.layout, work.provenance(), *surface, maps),
            work.plan, settings, file);
        const io::ExrCompression compression = compression_of(settings, file, image);
        work.write_and_verify(file,
                              [&] { io::write_exr(image, file.path, compression, work.threads); });
    }
}

bool read_pixels(const BakePlan& plan, const ExrSettings& settings, const BakeFile& file,
                 int threads, const io::ByteSink& sink) {
    io::read_exr_pixels(file.path, header_of(plan, settings, file), threads, sink);
    return true;
}

// ---- --from ----

/// Sets the layout and the type with which `ocean bake` writes these channels; leaves out the type
/// if it is the default.
void adopt_channels(const io::ExrLayout& stored, bool full_heights,
                    std::span<const Product* const> products, BakeOptions& options) {
    for (const bool layered : {false, true}) {
        for (const auto& [type, name] :
             {std::pair<std::optional<io::PixelType>, const char*>(std::nullopt, ""),
              {io::PixelType::half_float, "half"},
              {io::PixelType::full_float, "float"}}) {
            if (!layered && products.size() > 1) continue;
            const io::ProductLayout layout{
                .type = type, .full_heights = full_heights, .layered = layered};
            if (io::exr_channels(io::product_image(products, layout, {}, 1)) != stored.channels)
                continue;
            options.set_default("layout", layered ? "layered" : "separate");
            options.set_default("type", name);
            return;
        }
    }
    refuse_source(options.from, "its channels are not those that `ocean bake` writes");
}

/// Sets nothing from a file of another format, because meshes and volumes have products and axes of
/// their own.
void adopt(const BakedHeader& header, const Catalogue& catalogue, BakeOptions& options) {
    if (!header.has_layout()) return;
    const io::ExrLayout& stored = header.layout();
    const std::vector<const Product*> products = find_products(header.text("field"), catalogue);
    // A product that is not a vector is the same in all axes, and its header does not name them.
    const auto is_vector = [](const Product* product) { return product->vector; };
    if (std::any_of(products.begin(), products.end(), is_vector)) {
        options.set_default("axes", header.text("axes"));
    }
    const auto is_given = [&](const char* name) { return !options.format_option(name).empty(); };
    if (!is_given("type") || !is_given("layout")) {
        const bool full_heights = !is_displaced(*header.subject(catalogue));
        adopt_channels(stored, full_heights, products, options);
    }
    if (!is_given("compression")) {
        if (!stored.compression) {
            refuse_source(options.from, "`ocean bake` does not have its compression");
        }
        // Leaves out the default compression of this file, because other products may have another
        // default.
        if (*stored.compression != default_compression(products, stored.channels.front().type)) {
            options.set_default("compression", io::exr_compression_name(*stored.compression));
        }
    }
    options.set_default("products", header.text("field"));
    for (const MadeProduct* made : catalogue.made) {
        if (made->is_among(products) &&
            made->is_among(find_products(options.format_option("products"), catalogue))) {
            made->adopt(header, options);
        }
    }
}

constexpr BakeFormatOf<ExrSettings> kOf = {
    .name = "exr",
    .extension = ".exr",
    .label = "EXR",
    .family = "EXR files",
    .summary = "OpenEXR images: a map of each product",
    .example = "--products displacement,normal,foam",
    .options = list_options,
    .product_choice = product_choice,
    .read_options = read_options,
    .products = list_products,
    .resolve = resolve,
    .files = list_files,
    .recipe = recipe,
    .is_baked = is_baked,
    .frame_bytes = frame_bytes,
    .max_bytes = max_bytes,
    .write = write,
    .read_pixels = read_pixels,
    .header_proves_recipe = true,
    .read_header = io::read_exr_header,
    .adopt = adopt,
};

}  // namespace

const BakeFormat kExrFormat = bake_format<kOf>();

}  // namespace ocean
