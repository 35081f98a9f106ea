// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// OpenGL contexts without a window, and the properties of a context.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ocean::gl {

/// The properties of the context that is current on the calling thread.
struct ContextInfo {
    std::string vendor;
    std::string renderer;
    std::string version;
    bool software = false;  // a CPU emulates the GPU
    int major = 0;
    int minor = 0;
    std::int64_t storage_block_bytes = 0;  // max of one block
    int storage_blocks = 0;                // max of a compute shader
    int shared_bytes = 0;                  // max of a workgroup
    int workgroup_threads = 0;
    int image_units = 0;
    int texture_size = 0;
    bool reports_resets = false;  // the driver reports whether the context was lost

    /// Returns "NVIDIA H100 (NVIDIA Corporation), OpenGL 4.6".
    std::string text() const;
};

/// Returns the properties of the current context. Throws Error no_gpu if none is current.
ContextInfo context_info();
/// Returns true if any context, through EGL or GLX, is current on the calling thread.
bool has_current_context();

struct HeadlessOptions {
    /// Index of a device in EGL's list, from 0. Unset: the device of use_egl_device, else of
    /// OCEAN_EGL_DEVICE, else the first hardware device, else the first device.
    std::optional<int> device = {};
    /// Keeps the driver's messages for messages().
    bool debug = false;
    /// Requires OpenGL 4.3 core and checks the shaders' phase and noise. False: 4.1, which is
    /// enough for drawing.
    bool compute = true;
};

/// Sets the device of all contexts whose options have no device, for `--egl-device`.
void use_egl_device(int device);

/// A context through EGL that needs no display: on a device, else without a surface, else with a
/// pbuffer of one pixel. Current on one thread at a time; any thread may call the destructor.
class HeadlessContext {
  public:
    /// Leaves no context current. Throws Error no_gpu, whose sentence lists the attempts.
    explicit HeadlessContext(const HeadlessOptions& options = {});
    ~HeadlessContext();
    HeadlessContext(const HeadlessContext&) = delete;
    HeadlessContext& operator=(const HeadlessContext&) = delete;

    /// Makes the context current on the calling thread while it lives, and restores the previously
    /// current one afterwards. Throws Error no_gpu if the context was lost.
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
    /// Returns the driver's messages since the context was made; empty without `debug`.
    const std::vector<std::string>& messages() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace ocean::gl
