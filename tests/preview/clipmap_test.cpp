// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "clipmap.hpp"

#include <glm/gtc/matrix_transform.hpp>

#include "testing.hpp"
#include "wave/wave.hpp"

namespace ocean::preview {
namespace {

TEST(Frustum, KeepsWhatTheEyeSees) {
    // East, level, 90 degrees wide and high, 10 m over the water.
    const glm::mat4 view =
        glm::lookAt(glm::vec3(0.0f), glm::vec3(1.0f, 0.0f, 0.0f), glm::vec3(0.0f, 0.0f, 1.0f));
    const Frustum frustum(glm::frustum(-1.0f, 1.0f, -1.0f, 1.0f, 1.0f, 2.0f) * view, 10.0);
    const auto sees = [&](double x, double y) {
        return frustum.touches({x - 1.0, y - 1.0, -1.0}, {x + 1.0, y + 1.0, 1.0});
    };
    EXPECT_TRUE(sees(100.0, 0.0));
    EXPECT_TRUE(sees(100.0, 99.0));
    EXPECT_FALSE(sees(100.0, 103.0));
    EXPECT_FALSE(sees(100.0, -103.0));
    EXPECT_FALSE(sees(-100.0, 0.0));
    EXPECT_TRUE(sees(10.0, 0.0));
    EXPECT_FALSE(sees(7.0, 0.0));  // under the lower edge
}

TEST(Horizon, LiesWhereTheWaterHasDroppedByTheHeightOfTheEye) {
    using namespace wave::double_precision;
    for (const double height : {0.01, 2.0, 30.0, 10000.0}) {
        EXPECT_NEAR(earth_drop(horizon_distance(height)), height, 1e-9 * height);
    }
    EXPECT_EQ(horizon_distance(-1.0), 0.0);
    // The horizon of a round Earth: sqrt((R + h)^2 - R^2), a part in 2500 more from 10 km.
    const double radius = earth_radius();
    EXPECT_NEAR(horizon_distance(10000.0) / std::sqrt(10000.0 * (2.0 * radius + 10000.0)), 1.0,
                4e-4);
}

}  // namespace
}  // namespace ocean::preview
