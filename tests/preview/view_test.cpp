// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: each view is a row of one table, by whose word a person chooses it; each draws other
// pixels, and an unknown one is refused instead of drawn as another.
#include <set>

#include "ocean/error.hpp"
#include "preview_fixture.hpp"
#include "view_table.hpp"

namespace ocean::preview {
namespace {

TEST(Views, APersonChoosesThoseThatArePictures) {
    for (const ViewRow& row : kViews) {
        const std::string word(word_of(row.view));
        if (row.use == ViewUse::picture) {
            EXPECT_EQ(view_of(word), row.view);
        } else {
            EXPECT_THROW(view_of(word), Error) << word;
        }
    }
    const std::vector<std::string> names = view_names();
    EXPECT_EQ(names.front(), "shaded");
    EXPECT_EQ(names.size(), 9u);
}

class ViewTest : public PreviewTest {};

TEST_F(ViewTest, EachDrawsOtherPixelsAndAnUnknownOneIsRefused) {
    Ocean sea(two_cascades(), {.foam_start = FoamStart::empty});
    SeaMaps maps({.compute = false});
    Renderer renderer({.cells = 32});
    const DrawnSea shown = maps.show(sea, 5.0);
    const auto drawn = [&](View view) {
        const Canvas canvas(32, 32, GL_RGBA32F);
        const Camera down{.eye = {0.0, 0.0, 30.0}, .pitch = -90.0};
        renderer.draw(shown, down, {}, {.width = 32, .height = 32, .view = view});
        return canvas.rgba();
    };
    const auto is_magenta = [](const std::vector<float>& pixels) {
        return pixels[0] == 1.0f && pixels[1] == 0.0f && pixels[2] == 1.0f;
    };
    std::set<std::vector<float>> pictures;
    for (const ViewRow& row : kViews) {
        const auto pixels = drawn(row.view);
        EXPECT_FALSE(is_magenta(pixels)) << word_of(row.view);
        // Without foam two views of it are black.
        if (row.view != View::whitecap) pictures.insert(pixels);
    }
    EXPECT_EQ(pictures.size(), kViews.size() - 1);
    EXPECT_THROW(drawn(static_cast<View>(kViews.size())), Error);
}

}  // namespace
}  // namespace ocean::preview
