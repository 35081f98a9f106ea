// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Contexts of OpenGL without a window, and what a context can do.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ocean::gl {

/// What is current on the calling thread.
struct ContextInfo {
    std::string vendor;
    std::string renderer;
    std::string version;
    bool software = false;  // a processor that plays a GPU
    int major = 0;
    int minor = 0;
    std::int64_t storage_block_bytes = 0;  // the largest
    int storage_blocks = 0;                // of a compute shader
    int shared_bytes = 0;                  // of a workgroup
    int workgroup_threads = 0;
    int image_units = 0;
    int texture_size = 0;
    bool tells_resets = false;  // whether it was lost can be asked

    /// "NVIDIA H100 (NVIDIA Corporation), OpenGL 4.6".
    std::string text() const;
};

/// Throws Error no_gpu if no context is current.
ContextInfo context_info();
/// Whether any context, through EGL or GLX, is current on the calling thread.
bool has_current_context();

struct HeadlessOptions {
    /// Of the devices that EGL lists, from 0; else use_egl_device's, OCEAN_EGL_DEVICE's, or the
    /// first that is hardware, or the first.
    std::optional<int> device = {};
    /// What the driver has to say is kept for messages().
    bool debug = false;
    /// OpenGL 4.3 core, with phase and noise of the shaders checked; else 4.1 is enough, to draw.
    bool compute = true;
};

/// For all contexts that are made without a device of their own, as `--egl-device` wants it.
void use_egl_device(int device);

/// A context through EGL that needs no display: of a device, else without a surface, else with a
/// pbuffer of one pixel. Current on one thread at a time; the destructor may be called on any.
class HeadlessContext {
  public:
    /// Throws Error no_gpu, which says what was tried. Leaves nothing current.
    explicit HeadlessContext(const HeadlessOptions& options = {});
    ~HeadlessContext();
    HeadlessContext(const HeadlessContext&) = delete;
    HeadlessContext& operator=(const HeadlessContext&) = delete;

    /// Current on the calling thread while it lives; what was current before is so again after it.
    /// Throws Error no_gpu if the context was lost.
    class Current {
      public:
        explicit Current(const HeadlessContext& context);
        ~Current();
        Current(const Current&) = delete;
        Current& operator=(const Current&) = delete;

      private:
        void* display_;
        void* context_;
        void* draw_;
        void* read_;
        void* own_display_;
    };

    const ContextInfo& info() const;
    /// Of the driver since the context was made, with `debug`.
    const std::vector<std::string>& messages() const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace ocean::gl
