// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Stages of the transform one after another: in one context, each as if it were the first.
#include <epoxy/egl.h>

#include "ocean/error.hpp"
#include "ocean/internal/gl/context.hpp"
#include "ocean/internal/gl/stages.hpp"
#include "ocean/internal/map_request.hpp"
#include "ocean/ocean.hpp"
#include "unit/test_seas.hpp"

namespace ocean {
namespace {

int contexts = 0;
PFNEGLCREATECONTEXTPROC create_context = nullptr;

/// Counts the contexts made during its life.
class ContextCount {
  public:
    ContextCount() {
        const gl::HeadlessContext first;  // with it epoxy finds the driver's own function
        contexts = 0;
        create_context = epoxy_eglCreateContext;
        epoxy_eglCreateContext = [](EGLDisplay display, EGLConfig config, EGLContext shared,
                                    const EGLint* attributes) {
            const EGLContext made = create_context(display, config, shared, attributes);
            contexts += made != EGL_NO_CONTEXT;
            return made;
        };
    }
    ~ContextCount() { epoxy_eglCreateContext = create_context; }
    ContextCount(const ContextCount&) = delete;
    ContextCount& operator=(const ContextCount&) = delete;
};

TEST(GlStages, FramesOfASequenceShareOneContextAndAreTheSameAlone) {
    Ocean ocean(test::wind_sea(64));
    Ocean larger(test::wind_sea(128));
    const ContextCount count;
    gl::StageMaker stages;
    stages.make(map_modes(ocean.modes(), 0.0, 64), "h0", ocean.pool());
    EXPECT_EQ(contexts, 0) << "for what the CPU has";
    stages.make(map_modes(ocean.modes(), 5.0, 64), "vertical-6", ocean.pool());
    stages.make(map_modes(larger.modes(), 5.0, 128), "butterfly", ocean.pool());
    const gl::StageImage image =
        stages.make(map_modes(ocean.modes(), 6.0, 64), "horizontal-2", ocean.pool());
    EXPECT_EQ(contexts, 1);
    EXPECT_FALSE(gl::has_current_context());
    EXPECT_THROW(stages.make(map_modes(ocean.modes(), 6.0, 64), "vertical-7", ocean.pool()), Error);

    gl::StageMaker alone;
    const MapModes modes = map_modes(ocean.modes(), 6.0, 64);
    EXPECT_EQ(alone.make(modes, "horizontal-2", ocean.pool()).texels, image.texels);
    EXPECT_NE(alone.make(modes, "horizontal-3", ocean.pool()).texels, image.texels);
    EXPECT_EQ(contexts, 2);
}

}  // namespace
}  // namespace ocean
