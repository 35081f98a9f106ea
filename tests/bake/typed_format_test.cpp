// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: a format without a required function, or with a function for other settings, does not
// compile; optional functions do nothing; settings of another format are refused.
#include "ocean/bake/typed_format.hpp"

#include <stdexcept>

#include "bakes.hpp"

namespace ocean {
namespace {

struct Digits {
    int count = 3;
};
struct Letters {
    int count = 5;
};

// The compiler refuses {} and nullptr in the place of a required function, and other settings.
using Recipe = std::string(const BakePlan&, const Digits&, const BakeFile&);
static_assert(!std::is_default_constructible_v<Required<Recipe>>);
static_assert(!std::is_constructible_v<Required<Recipe>, std::nullptr_t>);
static_assert(std::is_constructible_v<Required<Recipe>, Recipe*>);
static_assert(!std::is_constructible_v<
              Required<Recipe>, std::string (*)(const BakePlan&, const Letters&, const BakeFile&)>);
static_assert(!std::is_default_constructible_v<BakeFormatOf<Digits>>);
static_assert(!std::is_default_constructible_v<MadeProductOf<Digits>>);
static_assert(!std::is_default_constructible_v<BakeFormat>);
static_assert(!std::is_default_constructible_v<MadeProduct>);

/// The shortest format: it counts digits or letters, and has required functions only.
template <typename Count>
constexpr BakeFormatOf<Count> kCountOf = {
    .name = "count",
    .extension = ".count",
    .family = "Counts",
    .read_options = +[](const BakeOptions&, const Catalogue&) { return Count{}; },
    .resolve =
        +[](const BakePlan& draft, const Count& requested) {
            return FormatPlan<Count>{{{Channel::height}, {draft.resolution}}, requested};
        },
    .files =
        +[](const BakePlan& plan, const Count& count, int frame) {
            return std::vector<BakeFile>(static_cast<std::size_t>(count.count),
                                         {plan.pattern.file(frame), frame, 0, "height"});
        },
    .recipe =
        +[](const BakePlan& plan, const Count& count, const BakeFile& file) {
            return bake_recipe(plan, file.frame, std::to_string(count.count));
        },
    .is_baked = +[](const BakeFile&) { return false; },
    .max_bytes = +[](const BakePlan&, const Count& count,
                     const BakeFile&) { return static_cast<std::uint64_t>(count.count); },
    .write = +[](const FrameWork&, const Count&, std::span<const BakeFile>) {},
};
constexpr BakeFormat kDigitsFormat = bake_format<kCountOf<Digits>>();
constexpr BakeFormat kLettersFormat = bake_format<kCountOf<Letters>>();

BakePlan plan_of(const BakeFormat& format) {
    const BakeFormat* const formats[] = {&format};
    Catalogue catalogue = standard_catalogue();
    catalogue.formats = formats;
    return make_bake_plan(test::sea_bake("sea.count"), catalogue);
}

TEST(TypedFormat, PassesItsOwnSettingsToEachFunction) {
    const BakePlan digits = plan_of(kDigitsFormat);
    EXPECT_EQ(digits.format->files(digits, 1).size(), 3u);
    EXPECT_EQ(digits.format->max_bytes(digits, {}), 3u);
    const BakePlan letters = plan_of(kLettersFormat);
    EXPECT_EQ(letters.format->files(letters, 1).size(), 5u);
    EXPECT_NE(letters.format->recipe(letters, {}), digits.format->recipe(digits, {}));
}

TEST(TypedFormat, RefusesTheSettingsOfAnotherFormat) {
    const BakePlan letters = plan_of(kLettersFormat);
    EXPECT_THROW(kDigitsFormat.files(letters, 1), std::logic_error);
    EXPECT_THROW(kDigitsFormat.resolve(letters), std::logic_error);
    EXPECT_THROW(kDigitsFormat.frame_bytes(letters), std::logic_error);
    EXPECT_THROW(kDigitsFormat.files(BakePlan{}, 1), std::logic_error) << "no settings";
    EXPECT_THROW(ErasedSettings::of(Letters{}).as<Digits>(), std::logic_error);
    EXPECT_EQ(ErasedSettings::of(Letters{7}).as<Letters>().count, 7);
}

TEST(TypedFormat, DoesNothingWhereAnOptionalFunctionIsLeftOut) {
    const BakePlan plan = plan_of(kDigitsFormat);
    const BakeFormat& format = *plan.format;
    EXPECT_TRUE(format.options(standard_catalogue()).empty());
    EXPECT_TRUE(format.products(plan).empty());
    EXPECT_EQ(format.frame_bytes(plan), 0u);
    EXPECT_FALSE(format.has_shared_files);
    EXPECT_TRUE(format.shared_files(plan).empty());
    EXPECT_FALSE(format.read_pixels(plan, {}, 1, [](std::string_view) { FAIL(); }));
    EXPECT_EQ(format.read_header, nullptr);
    EXPECT_EQ(format.label, format.name);
}

}  // namespace
}  // namespace ocean
