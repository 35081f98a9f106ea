// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A backend's function that runs on a GPU: in the context that is current at its first call, else
// in a headless one of its own.
#pragma once

#include <memory>
#include <optional>

#include "checks.hpp"
#include "ocean/backend.hpp"
#include "ocean/error.hpp"
#include "ocean/gl/context.hpp"

namespace ocean::gl {

/// Maps is made of a ContextInfo and has `bool write(request, pool)`. A copy has all of its own:
/// contexts are not shared. After Error no_gpu nothing is left, and the next call begins anew.
template <typename Maps>
class GpuFunction {
  public:
    GpuFunction() = default;
    GpuFunction(const GpuFunction&) {}
    ~GpuFunction() { forget(); }

    bool operator()(const MapRequest& request, ThreadPool& pool) {
        try {
            return write(request, pool);
        } catch (const Error& error) {
            // A lost context may be followed by another, in which its objects' names are of others:
            // they are given up while it is still current.
            if (error.kind() == ErrorKind::no_gpu) forget();
            throw;
        }
    }

  private:
    bool write(const MapRequest& request, ThreadPool& pool) {
        if (!maps_ && !has_current_context()) own_ = std::make_unique<HeadlessContext>();
        std::optional<HeadlessContext::Current> current;
        if (own_) current.emplace(*own_);
        if (!maps_) {
            context_ = context_info();
            maps_ = std::make_unique<Maps>(context_);
        }
        const bool uploaded = maps_->write(request, pool);
        require_not_reset(context_, "making a frame");
        return uploaded;
    }

    void forget() {
        try {
            std::optional<HeadlessContext::Current> current;
            if (own_) current.emplace(*own_);
            maps_.reset();
        } catch (const Error&) {
            // Lost, and its objects with it: there is nothing to delete them in.
            static_cast<void>(maps_.release());
        }
        own_.reset();
    }

    std::unique_ptr<HeadlessContext> own_;
    ContextInfo context_;
    std::unique_ptr<Maps> maps_;
};

}  // namespace ocean::gl
