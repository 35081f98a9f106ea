// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The outputs of the two kinds of frames.
#include "frame_maps.hpp"

#include <algorithm>
#include <utility>

namespace ocean::bench {

namespace {

std::size_t squared(int resolution) {
    return static_cast<std::size_t>(resolution) * static_cast<std::size_t>(resolution);
}

}  // namespace

const char* frame_name(FrameKind kind) {
    return kind == FrameKind::vertices ? "vertices" : "planar";
}

std::vector<Linear> fields_of(FrameKind kind) {
    using enum Linear;
    if (kind == FrameKind::vertices)
        return {height, displacement_x, displacement_y, slope_x, slope_y};
    return {height,  displacement_x, displacement_y, slope_x,
            slope_y, gradient_xx,    gradient_yy,    gradient_xy};
}

VertexMaps::VertexMaps(int resolution)
    : resolution_(resolution),
      displacement_(3 * squared(resolution)),
      normal_(3 * squared(resolution)) {}

SurfaceSettings VertexMaps::settings() {
    SurfaceSettings settings;
    settings.choppiness = 0.0;  // the normal: slopes are enough
    return settings;
}

std::array<MapOutput, 2> VertexMaps::outputs(int row) const {
    const std::size_t offset =
        3 * static_cast<std::size_t>(row) * static_cast<std::size_t>(resolution_);
    MapOutput displacement{displacement_.data() + offset, 3, {}};
    displacement.component[0] = {Linear::displacement_x, -1.0f};
    displacement.component[1] = {Linear::displacement_y, -1.0f};
    displacement.component[2] = {Linear::height, 1.0f};
    MapOutput normal{normal_.data() + offset, 3, {}};
    normal.component[0] = {Channel::nx, 1.0f};
    normal.component[1] = {Channel::ny, 1.0f};
    normal.component[2] = {Channel::nz, 1.0f};
    return {displacement, normal};
}

FieldView VertexMaps::field(Linear field) const {
    const std::ptrdiff_t row = 3 * static_cast<std::ptrdiff_t>(resolution_);
    switch (field) {
        case Linear::displacement_x:
            return {displacement_.data(), row, 3, -1.0};
        case Linear::displacement_y:
            return {displacement_.data() + 1, row, 3, -1.0};
        case Linear::height:
            return {displacement_.data() + 2, row, 3, 1.0};
        default:
            return {};
    }
}

FieldView VertexMaps::normal(Channel channel) const {
    const int component = static_cast<int>(channel) - static_cast<int>(Channel::nx);
    return {normal_.data() + component, 3 * static_cast<std::ptrdiff_t>(resolution_), 3, 1.0};
}

PlanarMaps::PlanarMaps(int resolution, std::vector<Linear> fields)
    : resolution_(static_cast<std::size_t>(resolution)),
      fields_(std::move(fields)),
      planes_(fields_.size() * squared(resolution)) {}

float* PlanarMaps::plane(std::size_t index) const {
    return planes_.data() + index * resolution_ * resolution_;
}

std::vector<MapOutput> PlanarMaps::outputs() const {
    std::vector<MapOutput> outputs;
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        MapOutput output{plane(i), 1, {}};
        output.component[0] = {fields_[i], 1.0f};
        outputs.push_back(output);
    }
    return outputs;
}

FieldView PlanarMaps::field(Linear field) const {
    const auto found = std::find(fields_.begin(), fields_.end(), field);
    if (found == fields_.end()) return {};
    return {plane(static_cast<std::size_t>(found - fields_.begin())),
            static_cast<std::ptrdiff_t>(resolution_), 1, 1.0};
}

}  // namespace ocean::bench
