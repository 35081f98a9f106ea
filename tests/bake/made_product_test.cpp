// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: a host adds products and families of made products by longer tables, and EXR files store
// them as their rows state; no format and no product has code for them.
#include "ocean/bake/typed_format.hpp"

#include "bakes.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/io/exr.hpp"

namespace ocean {
namespace {

using test::TemporaryFolder;

/// `glow` has the frame's size and one value: --glow-gain times the height of the highest crest.
struct Glow {
    double gain = 2.0;
    float value = 0.0f;
};
constexpr Product kGlowProducts[] = {{.name = "glow",
                                      .channels = {},
                                      .count = 0,
                                      .unit = "m",
                                      .precision = Precision::full,
                                      .run_lengths = RunLengths::always}};
constexpr MadeProductOf<Glow> kGlowOf = {
    .products = kGlowProducts,
    .options =
        [] {
            return std::vector<FormatOption>{{"glow-gain", "NUMBER", "Gain of glow"}};
        },
    .read =
        +[](const BakeOptions& options) {
            const std::string& gain = options.format_option("glow-gain");
            return gain.empty() ? Glow{} : Glow{parse_number(gain, "--glow-gain", 0.0, 10.0)};
        },
    .resolve =
        +[](const BakePlan&, const Glow& requested, const std::vector<const Product*>& products) {
            return MadePlan<Glow>{products, Channel::height, requested};
        },
    .strings =
        [](const BakePlan&, const Glow& glow, int, const Product&) {
            return std::vector<io::HeaderString>{{"ocean:glow_gain", shortest_text(glow.gain)}};
        },
    .make = +[](const FrameWork& work, const Glow& glow) -> MadeFrame {
        const Surface& map = work.maps.front();
        return [&map, gain = static_cast<float>(glow.gain)](const Product&) {
            const float crest = std::ranges::max(map.channel(Channel::height));
            return MadeSamples{.map = std::vector(map.domain().count(), gain * crest)};
        };
    },
};
constexpr MadeProduct kGlow = made_product<kGlowOf>();

/// `board` is a tile of 32 samples for any size of the frame.
struct Board {};
constexpr Product kBoardProducts[] = {{.name = "board",
                                       .channels = {Channel::slope_x, Channel::slope_y},
                                       .count = 2,
                                       .unit = "",
                                       .precision = Precision::half,
                                       .run_lengths = RunLengths::never}};
constexpr MadeProductOf<Board> kBoardOf = {
    .products = kBoardProducts,
    .tiles = "boards",
    .read = +[](const BakeOptions&) { return Board{}; },
    .resolve =
        +[](const BakePlan&, const Board&, const std::vector<const Product*>& products) {
            return MadePlan<Board>{products, {}, {}};
        },
    .tile_samples = [](const Board&) { return 32; },
    .make = +[](const FrameWork& work, const Board&) -> MadeFrame {
        return [time = work.time()](const Product& product) {
            return MadeSamples{.tile = Surface(Lattice{32, 1.0}, time, product.set())};
        };
    },
};
constexpr MadeProduct kBoard = made_product<kBoardOf>();

/// The library's products and those above.
struct LongerTables {
    std::vector<const MadeProduct*> made{standard_catalogue().made.begin(),
                                         standard_catalogue().made.end()};
    std::vector<Product> products;
    Catalogue catalogue = standard_catalogue();

    LongerTables() {
        made.insert(made.end(), {&kGlow, &kBoard});
        products = all_products(product_table(), made);
        products.push_back({.name = "tilt",
                            .channels = {Channel::slope_x},
                            .count = 1,
                            .unit = "",
                            .precision = Precision::full,
                            .run_lengths = RunLengths::of_halves});
        catalogue.made = made;
        catalogue.products = products;
    }
};

class MadeProducts : public testing::Test {
  protected:
    BakeOptions requesting(const std::string& products) const {
        BakeOptions options =
            test::sea_bake(folder_.file("sea.exr"), "1", {{"products", products}});
        options.resolution = "64";
        return options;
    }

    /// Returns the one file of the bake.
    std::string bake(const BakeOptions& options) const {
        test::bake(options, tables_.catalogue);
        const BakePlan plan = make_bake_plan(options, tables_.catalogue);
        return plan.format->files(plan, 1).at(0).path;
    }
    /// Returns the pixels of the first file.
    std::string pixels_of(const BakeOptions& options) const {
        const BakePlan plan = make_bake_plan(options, tables_.catalogue);
        std::string pixels;
        plan.format->read_pixels(plan, plan.format->files(plan, 1).at(0), 1,
                                 [&](std::string_view bytes) { pixels += bytes; });
        return pixels;
    }
    io::ExrLayout layout_of(const BakeOptions& options) const {
        return io::read_exr_layout(bake(options));
    }

    std::string refusal(const BakeOptions& options) const {
        return test::refusal_of(options, tables_.catalogue);
    }

    TemporaryFolder folder_;
    LongerTables tables_;
};

std::string string_of(const std::string& path, const std::string& name) {
    for (const io::HeaderString& string : io::read_exr_header(path)) {
        if (string.name == name) return string.text;
    }
    return "missing";
}

TEST_F(MadeProducts, HaveTheTypeAndTheRunLengthsOfTheirRow) {
    using enum io::PixelType;
    BakeOptions tilt = requesting("tilt");
    io::ExrLayout layout = layout_of(tilt);
    EXPECT_EQ(layout.channels.at(0).type, full_float);
    EXPECT_EQ(layout.compression, io::ExrCompression::none);
    tilt.format_options["type"] = "half";
    EXPECT_EQ(layout_of(tilt).compression, io::ExrCompression::rle);

    layout = layout_of(requesting("glow"));
    EXPECT_EQ(layout.channels.at(0).type, full_float);
    EXPECT_EQ(layout.compression, io::ExrCompression::rle);
}

TEST_F(MadeProducts, AreMadeOfTheFrame) {
    BakeOptions options = requesting("glow");
    const auto glow = [&] {
        bake(options);
        const std::string pixels = pixels_of(options);
        EXPECT_EQ(pixels.size(), 64u * 64u * sizeof(float));
        float value = 0.0f;
        std::memcpy(&value, pixels.data(), sizeof value);
        return value;
    };
    const float by_default = glow();
    EXPECT_GT(by_default, 0.1f);
    EXPECT_EQ(string_of(folder_.file("sea.exr"), "ocean:glow_gain"), "2");
    options.format_options["glow-gain"] = "4";
    EXPECT_EQ(glow(), 2.0f * by_default);
    EXPECT_EQ(string_of(folder_.file("sea.exr"), "ocean:glow_gain"), "4");
}

TEST_F(MadeProducts, OfSeveralFamiliesShareALayeredFile) {
    BakeOptions options = requesting("caustics,height,glow");
    options.format_options["layout"] = "layered";
    const std::string path = bake(options);
    const std::string pixels = pixels_of(options);
    // The first row: caustics are half floats, all different; the glow is the same everywhere.
    std::array<float, 64> glow{};
    std::memcpy(glow.data(), pixels.data() + 64 * 2, sizeof glow);
    EXPECT_GT(glow[0], 0.1f);
    EXPECT_EQ(std::ranges::count(glow, glow[0]), 64);
    std::string names;
    for (const auto& channel : io::read_exr_layout(path).channels) names += channel.name + " ";
    EXPECT_EQ(names, "caustics.V glow.V height.V ");
    EXPECT_EQ(string_of(path, "ocean:glow_gain"), "2");
    EXPECT_EQ(string_of(path, "ocean:sun"), "90,0");
}

TEST_F(MadeProducts, WithASizeOfTheirOwnHaveTheirOwnFiles) {
    BakeOptions options = requesting("board");
    const std::string path = bake(options);
    EXPECT_EQ(io::read_exr_layout(path).samples, (std::array{32, 32}));
    EXPECT_EQ(string_of(path, "ocean:field"), "board");
    options.skip_existing = true;
    EXPECT_EQ(test::bake(options, tables_.catalogue), "k");
    options.format_options["layout"] = "layered";
    EXPECT_EQ(refusal(options), "--layout layered: boards do not have the size of the sea's map");
}

TEST_F(MadeProducts, HaveOptionsOfTheirOwn) {
    BakeOptions options = requesting("caustics,board");
    options.format_options["glow-gain"] = "3";
    EXPECT_EQ(refusal(options), "--glow-gain 3: needs glow among the --products");
    std::string names;
    const BakeFormat& exr = *tables_.catalogue.find_format(".exr");
    for (const FormatOption& option : exr.options(tables_.catalogue)) names += option.name + " ";
    EXPECT_EQ(names,
              "products type axes layout compression caustics-depth detail-samples glow-gain sun ");
}

}  // namespace
}  // namespace ocean
