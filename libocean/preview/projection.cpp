// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "projection.hpp"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "wave/wave.hpp"

namespace ocean::preview {

Projection perspective(const Camera& camera, int width, int height) {
    const double half = std::tan(0.5 * kRadians * camera.field_of_view);
    const double aspect = static_cast<double>(width) / height;
    const double h = kRadians * camera.heading, p = kRadians * camera.pitch;
    const glm::dvec3 ahead(std::cos(p) * std::cos(h), std::cos(p) * std::sin(h), std::sin(p));
    const glm::dvec3 up(-std::sin(p) * std::cos(h), -std::sin(p) * std::sin(h), std::cos(p));
    const glm::dmat4 view = glm::lookAt(glm::dvec3(0.0), ahead, up);
    const glm::dmat4 lens = glm::frustum(-half, half, -half / aspect, half / aspect, 1.0, 2.0);
    return {glm::mat4(lens * view), 2.0 * half / width};
}

Projection from_above(const Camera& camera, double x, double y, double metres, double wave_height) {
    const double half = 0.5 * metres;
    const double east = x - camera.eye[0], north = y - camera.eye[1];
    const double drop = wave::double_precision::earth_drop(std::hypot(east, north));
    const double waves = 2.0 * wave_height + 1.0;
    const double still = -camera.eye[2];
    const glm::dmat4 lens = glm::ortho(east - half, east + half, north - half, north + half,
                                       -(still + waves), -(still - drop - waves));
    return {glm::mat4(lens), 1.0, true};
}

}  // namespace ocean::preview
