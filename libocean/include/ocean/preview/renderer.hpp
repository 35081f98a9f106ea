// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Draws a sea to its horizon into the current framebuffer, whoever made that. It knows no windows.
#pragma once

#include <array>
#include <memory>
#include <string>

#include "ocean/preview/picture.hpp"
#include "ocean/preview/sea_maps.hpp"

namespace ocean::preview {

struct RendererOptions {
    /// Of a level of the mesh, from the eye to its edge; a multiple of 8, 16 .. 512. A cell is seen
    /// under an angle of 1 to 2 over as many.
    int cells = 96;
    /// Samples along the longer side of a pixel's footprint; 0: by the driver's anisotropic filter
    /// on a GPU that has one, else 2.
    int taps = 0;
    /// The textures of the foam's pattern are made in another thread, and foam is without it until
    /// they are there; else the first picture with foam waits for them.
    bool live = false;
    gl::AfterStage after_stage = {};  // "sky", "water"
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

/// A part of the scene beside the water; defined in libocean/preview/drawable.hpp.
class Drawable;

struct DrawOptions {
    int width = 0;  // pixels
    int height = 0;
    View view = View::shaded;
    /// Of the values that a view shows, least and most; both 0: by the sea's height.
    std::array<double, 2> range = {0.0, 0.0};
    bool wireframe = false;
    /// Of the sea the waves of this cascade alone, from 0, without those that no map has; foam
    /// remains that of the whole sea. -1: all.
    int cascade = -1;
    /// Each sample of a canvas that has so many is shaded, not each pixel: ripples that are seen
    /// along a ridge are finer than pixels. Takes as many times as long.
    int shaded_samples = 1;
    /// Of the shaded sea light itself, times the exposure, as a canvas of GL_RGBA32F holds it; else
    /// what a screen takes.
    bool linear = false;
};

/// Needs the context that was current when it was made to be current in every call, the destructor
/// too. OpenGL 4.1 core.
class Renderer {
  public:
    /// Throws Error no_gpu.
    explicit Renderer(const RendererOptions& options = {});
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Adds a part of the scene to all pictures to come.
    void add(std::shared_ptr<Drawable> drawable);
    /// Returns whether the picture that was drawn last will look otherwise when it is drawn again,
    /// of a live renderer: the foam's pattern is made beside the pictures.
    Pending pending() const;
    /// Returns the parts that the last picture lacks.
    LeftOut left_out() const;
    /// Clears depth and colour. Of a host's context it leaves other bindings behind: program,
    /// textures, uniform buffer 0, depth test, viewport. Throws Error.
    void draw(const ShownSea& sea, const Camera& camera, const Look& look,
              const DrawOptions& options);
    /// The same from straight above, orthographic: the square of `metres` a side whose middle is
    /// (x, y), with the mesh that this camera has. For probes.
    void draw_from_above(const ShownSea& sea, const Camera& camera, double x, double y,
                         double metres, const DrawOptions& options);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace ocean::preview
