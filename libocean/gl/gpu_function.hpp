// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A backend's function that runs on a GPU: in the context that is current at its first call, else
// in a headless one of its own.
#pragma once

#include <memory>
#include <optional>

#include "ocean/backend.hpp"
#include "ocean/error.hpp"
#include "ocean/gl/context.hpp"

namespace ocean::gl {

/// Maps is made of a ContextInfo and has `bool write(request, pool)`. A copy has all of its own:
/// contexts are not shared.
template <typename Maps>
class GpuFunction {
  public:
    GpuFunction() = default;
    GpuFunction(const GpuFunction&) {}
    ~GpuFunction() {
        if (!own_) return;
        try {
            const HeadlessContext::Current current(*own_);
            maps_.reset();
        } catch (const Error&) {
            // Lost, and its objects with it.
        }
    }

    bool operator()(const MapRequest& request, ThreadPool& pool) {
        if (!maps_ && !has_current_context()) own_ = std::make_unique<HeadlessContext>();
        std::optional<HeadlessContext::Current> current;
        if (own_) current.emplace(*own_);
        if (!maps_) maps_ = std::make_unique<Maps>(context_info());
        return maps_->write(request, pool);
    }

  private:
    std::unique_ptr<HeadlessContext> own_;
    std::unique_ptr<Maps> maps_;
};

}  // namespace ocean::gl
