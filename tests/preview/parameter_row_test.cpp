// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A row of the panel, without a window: a click on a boolean of any table sets its other value.
#include "ocean-preview/panel/parameter_row.hpp"

#include <gtest/gtest.h>
#include <imgui.h>

#include "toy_model.hpp"

namespace ocean::app {
namespace {

struct Panel {
    Panel() {
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.DisplaySize = {400.0f, 300.0f};
        io.DeltaTime = 0.1f;
        io.IniFilename = nullptr;
        unsigned char* pixels = nullptr;
        int width = 0, height = 0;
        io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    }
    ~Panel() { ImGui::DestroyContext(); }

    /// Returns the middle of the row.
    ImVec2 draw(const ShownParameter& shown) {
        ImGui::NewFrame();
        ImGui::SetNextWindowPos({0.0f, 0.0f});
        ImGui::Begin("panel");
        draw_parameter(shown, [&](const ParameterChange& change) { changes.push_back(change); });
        const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
        ImGui::End();
        ImGui::Render();
        return {0.5f * (low.x + high.x), 0.5f * (low.y + high.y)};
    }

    void click(const ShownParameter& shown) {
        draw(shown);
        const ImVec2 middle = draw(shown);
        ImGui::GetIO().MousePos = middle;
        for (const bool down : {false, true, false, false}) {
            ImGui::GetIO().MouseDown[0] = down;
            draw(shown);
        }
    }

    std::vector<ParameterChange> changes;
};

TEST(ParameterRow, AClickOnACheckboxSetsTheOtherValue) {
    const auto ref = find_parameter(test::kKilnTable, "vented");
    for (const bool value : {false, true}) {
        Panel panel;
        panel.click({*ref.info, 0, value, false, true});
        ASSERT_EQ(panel.changes.size(), 1u);
        EXPECT_EQ(panel.changes.front().path, "kiln.vented");
        EXPECT_EQ(panel.changes.front().value, value ? "false" : "true");
        EXPECT_EQ(panel.changes.front().before, value ? "true" : "false");
        EXPECT_FALSE(panel.changes.front().is_drag);
    }
}

TEST(ParameterRow, ASearchFindsLabelsAndPaths) {
    const auto& angle = *find_parameter(test::kKilnTable, "lid_angle").info;
    for (const char* search : {"", "LID a", "kiln.lid"}) EXPECT_TRUE(is_found(angle, 0, search));
    EXPECT_FALSE(is_found(angle, 0, "heat"));
}

}  // namespace
}  // namespace ocean::app
