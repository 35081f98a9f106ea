// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Work that runs on a GPU: in the context that is current at its first call, else in a headless one
// of its own.
#pragma once

#include <memory>
#include <optional>
#include <type_traits>

#include "checks.hpp"
#include "ocean/backend.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/gl/context.hpp"
#include "ocean/internal/map_request.hpp"

namespace ocean::gl {

/// Objects that live in a context: the host's, or a headless one of their own. Objects is made from
/// a ContextInfo. A copy makes its own objects: contexts are not shared.
template <typename Objects>
class GpuObjects {
  public:
    GpuObjects() = default;
    GpuObjects(const GpuObjects&) {}
    ~GpuObjects() { forget(); }

    /// Makes the context current, calls work(Objects&) and returns its result. After Error no_gpu
    /// all objects are gone, and the next call begins anew.
    template <typename Work>
    std::invoke_result_t<Work, Objects&> use(const Work& work) {
        try {
            return do_work(work);
        } catch (const Error& error) {
            // A lost context may be followed by another, in which its objects' names are of others:
            // they are given up while it is still current.
            if (error.kind() == ErrorKind::no_gpu) forget();
            throw;
        }
    }

  private:
    template <typename Work>
    std::invoke_result_t<Work, Objects&> do_work(const Work& work) {
        if (!objects_ && !has_current_context()) own_ = std::make_unique<HeadlessContext>();
        std::optional<HeadlessContext::Current> current;
        if (own_) current.emplace(*own_);
        if (!objects_) {
            context_ = context_info();
            objects_ = std::make_unique<Objects>(context_);
        }
        auto result = work(*objects_);
        require_not_reset(context_, "making a frame");
        return result;
    }

    void forget() {
        try {
            std::optional<HeadlessContext::Current> current;
            if (own_) current.emplace(*own_);
            objects_.reset();
        } catch (const Error&) {
            // The context is lost and its objects with it: no context is left to delete them in.
            static_cast<void>(objects_.release());
        }
        own_.reset();
    }

    std::unique_ptr<HeadlessContext> own_;
    ContextInfo context_;
    std::unique_ptr<Objects> objects_;
};

/// A backend's function; Maps has `bool write(request, pool)`.
template <typename Maps>
class GpuFunction {
  public:
    bool operator()(const MapRequest& request, ThreadPool& pool) {
        return objects_.use([&](Maps& maps) { return maps.write(request, pool); });
    }

  private:
    GpuObjects<Maps> objects_;
};

}  // namespace ocean::gl
