// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// OpenEXR images: a file for each product, or one layered file of all of them. Its header is a
// function of the plan alone, so that a file tells by itself whether it is the one that the plan
// would write.
#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <optional>
#include <string_view>

#include "formats/detail_tiles.hpp"
#include "formats/formats.hpp"
#include "ocean/bake/plan.hpp"
#include "ocean/caustics.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/csv_rows.hpp"
#include "ocean/internal/memory.hpp"
#include "ocean/io/exr.hpp"
#include "ocean/io/product_image.hpp"
#include "ocean/sea_subject.hpp"
#include "ocean/text.hpp"
#include "ocean/thread_pool.hpp"
#include "sha256.hpp"
#include "source.hpp"

namespace ocean {
namespace {

constexpr const char* kDefaultProducts = "displacement,normal,foam";
constexpr const char* kUndisplacedProducts = "height";  // of a subject without dx and dy
/// m, where there is no floor above it: waves of three metres gather light about here.
constexpr double kUsualCausticsDepth = 10.0;
constexpr const char* kUsualSun = "90,0";

bool have_caustics(std::span<const Product* const> products) {
    return std::ranges::any_of(
        products, [](const Product* product) { return product->name == kCausticsProduct.name; });
}

bool have_detail(std::span<const Product* const> products) {
    return std::ranges::any_of(products,
                               [](const Product* product) { return is_detail(*product); });
}

struct Settings {
    std::vector<const Product*> products;
    bool usual = false;  // nobody asked for products
    io::ProductLayout layout;
    std::optional<io::ExrCompression> compression;  // none: what pays for each file
    std::optional<double> caustics_depth;           // as typed
    CausticsSettings caustics = {};                 // with what the sea says
    std::optional<int> detail_samples;              // as typed
    DetailSettings detail = {};                     // with the map that is shown
    std::shared_ptr<DetailBudgets> budgets;         // of the bands among the products

    /// The products of each file of a frame.
    std::size_t files() const { return layout.layered ? 1 : products.size(); }
    std::span<const Product* const> of_file(std::size_t part) const {
        return layout.layered ? std::span(products) : std::span(products).subspan(part, 1);
    }
    bool has_caustics() const { return have_caustics(products); }
    bool has_detail() const { return have_detail(products); }
};

const Settings& settings_of(const BakePlan& plan) {
    return std::any_cast<const Settings&>(plan.settings);
}

std::vector<FormatOption> list_options(const Catalogue& catalogue) {
    return {
        {"products", "LIST",
         "Of " + catalogue.product_names() + "; default " + std::string(kDefaultProducts)},
        {"type", "TYPE",
         "float or half; default: float for displacement and velocity, half for the rest"},
        {"axes", "AXES",
         "Order of vectors: tnb (x, z, y), zup (x, y, z), yup (x, z, -y); default tnb"},
        {"layout", "LAYOUT",
         "separate (a file for each product) or layered (one file); default separate"},
        {"compression", "CODEC",
         "none, rle, zips, zip, piz or pxr24; default rle for slope, whitecap, foam and cover "
         "and for halves of normal, jacobian and derivatives, none for the rest"},
        {"caustics-depth", "METRES",
         "Of the level plane that caustics fall on; default: the sea's depth, 10 at most"},
        {"detail-samples", "N",
         "A side of each slope tile of detail: 256, 512 or 1024; default " +
             std::to_string(kUsualDetailSamples)},
        {"sun", "ALTITUDE,BEARING",
         "Of caustics, degrees above the horizon and counter-clockwise from +x; default " +
             std::string(kUsualSun)},
    };
}

/// Run lengths where they leave less than 0.9 of the bytes, for at most 1.4 times the CPU of a
/// frame that is computed and written as it is: 0.14 of whitecaps, 0.68 of slopes, whose B is
/// empty, 0.86 of halves of normals. ZIP leaves 0.97 of float displacement for 5.5 times, 0.72 of
/// normals for 4.4 [measured, N = 1024].
io::ExrCompression usual_compression(std::span<const Product* const> products, io::PixelType type) {
    const auto pays = [type](const Product* product) {
        const auto is_one_of = [product](std::initializer_list<std::string_view> names) {
            return std::find(names.begin(), names.end(), product->name) != names.end();
        };
        return is_detail(*product) || is_one_of({"slope", "whitecap", "foam", "cover"}) ||
               (type == io::PixelType::half_float &&
                is_one_of({"normal", "jacobian", "derivatives"}));
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

/// --caustics-depth and --sun.
void read_caustics(const BakeOptions& options, Settings& settings) {
    const std::string& depth = options.format_option("caustics-depth");
    const std::string& sun = options.format_option("sun");
    for (const auto& [name, typed] : {std::pair("--caustics-depth ", &depth), {"--sun ", &sun}}) {
        if (typed->empty() || settings.has_caustics()) continue;
        throw Error(ErrorKind::invalid_value,
                    name + *typed + ": needs caustics among the --products");
    }
    if (!depth.empty()) {
        settings.caustics_depth =
            parse_number(depth, "--caustics-depth", kLeastCausticsDepth, kMostCausticsDepth);
    }
    const std::vector<std::string> angles = split(sun.empty() ? kUsualSun : sun, ',');
    if (angles.size() != 2) {
        throw Error(ErrorKind::invalid_value,
                    "--sun " + sun + ": two numbers are needed, ALTITUDE,BEARING");
    }
    settings.caustics.sun_altitude =
        parse_number(csv::trimmed(angles[0]), "--sun, altitude", kLeastCausticsSun, 90.0);
    settings.caustics.sun_bearing =
        parse_number(csv::trimmed(angles[1]), "--sun, bearing", -3600.0, 3600.0);
}

/// --detail-samples.
void read_detail(const BakeOptions& options, Settings& settings) {
    const std::string& samples = options.format_option("detail-samples");
    if (settings.has_detail() && settings.layout.layered) {
        throw Error(ErrorKind::invalid_value,
                    "--layout layered: slope tiles are no maps of the sea's size");
    }
    if (samples.empty()) return;
    if (!settings.has_detail()) {
        throw Error(ErrorKind::invalid_value,
                    "--detail-samples " + samples + ": needs detail among the --products");
    }
    settings.detail_samples =
        parse_whole_number(samples, "--detail-samples", kLeastDetailSamples, kMostDetailSamples);
}

/// The plane lies no deeper than the water.
double caustics_depth(const Settings& settings, double water) {
    const double depth = settings.caustics_depth.value_or(std::min(water, kUsualCausticsDepth));
    if (depth <= water) return depth;
    throw Error(ErrorKind::invalid_value, "--caustics-depth " + shortest_text(depth) +
                                              ": the sea is " + shortest_text(water) + " m deep");
}

std::any read_options(const BakeOptions& options, const Catalogue& catalogue) {
    Settings settings;
    const std::string& products = options.format_option("products");
    settings.usual = products.empty();
    settings.products = find_products(settings.usual ? kDefaultProducts : products, catalogue);
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
    read_caustics(options, settings);
    read_detail(options, settings);
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
    if (settings.has_detail()) {
        settings.detail = {begun.resolution, settings.detail_samples.value_or(kUsualDetailSamples)};
        settings.products =
            with_bands(settings.products, sea_of(*begun.subject).parameters, settings.detail);
        settings.budgets = std::make_shared<DetailBudgets>();
    }
    for (const Product* product : settings.products) {
        result.maps.channels = result.maps.channels | product->set();
        if (!settings.layout.layered) result.named_products.emplace_back(product->name);
    }
    if (settings.has_caustics()) {
        result.maps.channels = result.maps.channels | kCausticsChannels;
        settings.caustics.depth =
            caustics_depth(settings, sea_of(*begun.subject).parameters.water.depth);
    }
    result.settings = std::move(settings);
    return result;
}

/// What caustics were made with, in the header of their file.
io::Image labelled(io::Image image, const Settings& settings,
                   std::span<const Product* const> products) {
    if (!have_caustics(products)) return image;
    const CausticsSettings& caustics = settings.caustics;
    image.strings.push_back({"ocean:caustics_depth", shortest_text(caustics.depth)});
    image.strings.push_back({"ocean:sun", shortest_text(caustics.sun_altitude) + "," +
                                              shortest_text(caustics.sun_bearing)});
    return image;
}

/// A slope tile is the image of a slope by another name.
io::Image band_image(io::Image image, const BakePlan& plan, const BakeFile& file,
                     std::size_t band) {
    const Settings& settings = settings_of(plan);
    for (io::HeaderString& string : image.strings) {
        if (string.name == "ocean:field") string.text = file.product;
    }
    const DetailBudget budget = settings.budgets->of(plan, file.frame, settings.detail);
    std::ranges::move(band_strings(budget, band, plan.resolution),
                      std::back_inserter(image.strings));
    return image;
}
/// What stands for the products in the making of an image.
std::vector<const Product*> drawn_as(std::span<const Product* const> products) {
    std::vector<const Product*> drawn(products.begin(), products.end());
    for (const Product*& product : drawn) {
        if (is_detail(*product)) product = &find_product("slope");
    }
    return drawn;
}

/// The image of a file, without its samples.
io::Image image_of(const BakePlan& plan, const BakeFile& file) {
    const Settings& settings = settings_of(plan);
    const auto products = settings.of_file(file.part);
    if (const auto band = band_of(*products.front())) {
        return band_image(
            io::product_image(drawn_as(products), settings.layout, provenance_of(plan, file.frame),
                              settings.detail.samples),
            plan, file, *band);
    }
    return labelled(io::product_image(products, settings.layout, provenance_of(plan, file.frame),
                                      plan.resolution),
                    settings, products);
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
        return std::any_of(header.begin(), header.end(),
                           [](const auto& string) { return string.name == "ocean:sea"; });
    } catch (const Error&) {
        return false;
    }
}

std::uint64_t frame_bytes(const BakePlan& plan) {
    const Settings& settings = settings_of(plan);
    std::uint64_t bytes = settings.has_caustics() ? caustics_bytes(plan.resolution) : 0;
    if (settings.has_detail()) {
        // Two slopes of each band, and of one again for its file.
        bytes += detail_bytes(sea_of(*plan.subject).parameters, settings.detail, plan.backend) +
                 maps_bytes(settings.detail.samples, 2 * kMostDetailBands + 2);
    }
    return bytes;
}

void write(const FrameWork& work, std::span<const BakeFile> files) {
    const Settings& settings = settings_of(work.plan);
    std::vector<float> caustics;
    if (settings.has_caustics()) {
        ThreadPool pool(work.threads);
        caustics = make_caustics(work.maps.front(), settings.caustics, pool);
    }
    Detail detail;
    if (settings.has_detail()) detail = ocean_of(work.source).detail(work.time(), settings.detail);
    for (const BakeFile& file : files) {
        const auto products = settings.of_file(file.part);
        const auto band = band_of(*products.front());
        const Surface tile = band ? band_surface(detail, *band) : Surface();
        const io::Image image =
            band ? band_image(io::product_image(drawn_as(products), settings.layout,
                                                work.provenance(), tile),
                              work.plan, file, *band)
                 : labelled(io::product_image(products, settings.layout, work.provenance(),
                                              work.maps.front(), caustics),
                            settings, products);
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
            if (io::exr_channels(io::product_image(drawn_as(products), layout, {}, 1)) !=
                stored.channels)
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
    if (have_caustics(products) &&
        have_caustics(find_products(options.format_option("products"), catalogue))) {
        options.take("caustics-depth", header.text("caustics_depth"));
        options.take("sun", header.text("sun"));
    }
    if (have_detail(products) && stored.resolution != kUsualDetailSamples &&
        have_detail(find_products(options.format_option("products"), catalogue))) {
        options.take("detail-samples", std::to_string(stored.resolution));
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
