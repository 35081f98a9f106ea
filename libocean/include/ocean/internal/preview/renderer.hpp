// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Draws a sea or a land to its horizon into the current framebuffer, of a window or of a canvas.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "ocean/internal/preview/land_maps.hpp"
#include "ocean/internal/preview/picture.hpp"
#include "ocean/internal/preview/sea_maps.hpp"

namespace ocean::preview {

/// The program's storage for data that are equal in every run: 8 MB in one piece. Both functions
/// may be called in another thread, and do not throw.
struct KeptTextures {
    /// Returns the text that the last run wrote. If it is any other text, or "", the renderer makes
    /// the data anew.
    std::function<std::string()> read = {};
    std::function<void(std::string_view bytes)> write = {};
};

struct RendererOptions {
    /// Cells of a level of the mesh from the eye to its edge: a multiple of 8, 16 .. 512. A cell is
    /// seen under an angle of 1/cells to 2/cells.
    int cells = 96;
    /// Threads that make the patches of land beside the pictures; 0: one for each core,
    /// of a live renderer one less.
    int land_threads = 0;
    /// Shows slopes of land that are finer than its map.
    bool land_detail = true;
    /// Max time that a live renderer waits for patches of land [s]; then it draws the patches it
    /// has.
    double land_patience = 0.025;
    /// Steps along the line towards the sun that finds the shadows of land; 0: no shadows.
    int shadow_steps = 40;
    /// Samples along the longer side of a pixel's footprint; 0: the driver's anisotropic filter on
    /// a GPU that has one, else 2.
    int taps = 0;
    /// Makes the textures of the foam's pattern in another thread, and draws foam without the
    /// pattern until they are ready; else the first picture with foam waits for the textures.
    /// Likewise land is coarser in pictures for which its patches are not ready.
    bool live = false;
    /// The textures of the foam's pattern, which take a second of the processor; empty: each
    /// renderer makes them.
    KeptTextures kept_textures = {};
    gl::AfterStage after_stage = {};  // "sky", "water" or "land"
    /// Texture units of a fragment shader that the renderer uses; 0: all that the driver has, which
    /// are 16 or more.
    int max_texture_units = 0;
};

/// The parts that a picture lacks because they need more texture units than the driver has.
struct LeftOut {
    bool foam_pattern = false;
    bool near_detail = false;
    int required_units = 0;
    int available_units = 0;
};
/// Returns one sentence for a person, with the numbers; "" if nothing is left out.
std::string text(const LeftOut& left_out);

/// The mesh of the last picture of land.
struct LandStatistics {
    std::size_t patches = 0;           // squares of the quadtree that were drawn
    std::size_t triangles = 0;         // of these patches
    std::uint64_t resident_bytes = 0;  // of all textures of land
    std::size_t waiting = 0;           // patches that other threads make
};

/// A part of the scene other than water or land; defined in libocean/preview/drawable.hpp.
class Drawable;

struct DrawOptions {
    int width = 0;  // [pixels]
    int height = 0;
    View view = View::shaded;
    /// Lowest and highest value that a view shows; both 0: the view's own range, which follows the
    /// height of the sea or the land.
    std::array<double, 2> range = {0.0, 0.0};
    bool wireframe = false;
    /// The only cascade that is shown, from 0, without the waves too short for maps; the foam is
    /// still the whole sea's. -1: all cascades.
    int cascade = -1;
    /// Samples of a pixel that are shaded one by one, because ripples that are seen along a ridge
    /// are finer than pixels; 1: each pixel is shaded once. The time grows with this number.
    int shaded_samples = 1;
    /// Draws linear light times the exposure, for a canvas of GL_RGBA32F; else the colours of a
    /// screen.
    bool linear = false;
    /// Draws the ground of a coast; without it pixels beside its water stay as they are.
    bool ground = true;
};

/// Every call, the destructor too, needs the context that was current at construction. OpenGL 4.1
/// core.
class Renderer {
  public:
    /// Throws Error no_gpu.
    explicit Renderer(const RendererOptions& options = {});
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Adds a part of the scene to all pictures to come.
    void add(std::shared_ptr<Drawable> drawable);
    /// Returns whether drawing the last picture again would change it: a live renderer makes the
    /// foam's pattern and the patches of land in other threads.
    Pending pending() const;
    LandStatistics land_statistics() const;
    /// Returns the parts that the last picture lacks.
    LeftOut left_out() const;
    /// Clears colour and depth of the current framebuffer and draws a picture. Leaves other
    /// bindings behind: program, textures, uniform buffers 0 and 1, depth test, viewport. Throws
    /// Error.
    void draw(const DrawnSea& sea, const Camera& camera, const Look& look,
              const DrawOptions& options);
    void draw(const DrawnLand& land, const Camera& camera, const Look& look,
              const DrawOptions& options);
    /// Draws for probes: the square of `metres` a side with its middle at (x, y), from straight
    /// above, orthographic, with the mesh of the camera and without the sky. Throws Error.
    void draw_from_above(const DrawnSea& sea, const Camera& camera, double x, double y,
                         double metres, const DrawOptions& options);
    void draw_from_above(const DrawnLand& land, const Camera& camera, double x, double y,
                         double metres, const DrawOptions& options);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace ocean::preview
