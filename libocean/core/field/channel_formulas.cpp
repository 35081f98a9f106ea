// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The formulas of channels of several linear fields, as in shaders/wave/, in the precision of the
// point.
#include <type_traits>

#include "ocean/channel.hpp"
#include "wave/wave.hpp"

namespace ocean::channel_formula {
namespace {

template <typename Real>
auto normal_of(const SurfacePoint<Real>& p) {
    const Real c = p.choppiness;
    const Real xx = p[Linear::gradient_xx];
    const Real yy = p[Linear::gradient_yy];
    const Real xy = p[Linear::gradient_xy];
    const Real hx = p[Linear::slope_x];
    const Real hy = p[Linear::slope_y];
    if constexpr (std::is_same_v<Real, float>) {
        return wave::single_precision::surface_normal(c, xx, yy, xy, hx, hy);
    } else {
        return wave::double_precision::surface_normal(c, xx, yy, xy, hx, hy);
    }
}

}  // namespace

template <typename Real>
Real normal_x(const SurfacePoint<Real>& point) {
    return normal_of(point).x;
}

template <typename Real>
Real normal_y(const SurfacePoint<Real>& point) {
    return normal_of(point).y;
}

template <typename Real>
Real normal_z(const SurfacePoint<Real>& point) {
    return normal_of(point).z;
}

template <typename Real>
Real jacobian_of(const SurfacePoint<Real>& p) {
    const Real xx = p[Linear::gradient_xx];
    const Real yy = p[Linear::gradient_yy];
    const Real xy = p[Linear::gradient_xy];
    if constexpr (std::is_same_v<Real, float>) {
        return wave::single_precision::surface_jacobian(p.choppiness, xx, yy, xy);
    } else {
        return wave::double_precision::surface_jacobian(p.choppiness, xx, yy, xy);
    }
}

template <typename Real>
Real whitecap_of(const SurfacePoint<Real>& p) {
    const Real jacobian = jacobian_of(p);
    if constexpr (std::is_same_v<Real, float>) {
        return wave::single_precision::surface_whitecap(jacobian, p.foam_threshold, p.foam_width);
    } else {
        return wave::double_precision::surface_whitecap(jacobian, p.foam_threshold, p.foam_width);
    }
}

/// Lays a whitecap over the earlier foam, which is stored in floats.
template <typename Real>
Real foam_of(const SurfacePoint<Real>& p) {
    const float foam = wave::single_precision::foam_with_whitecap(
        static_cast<float>(whitecap_of(p)), p.previous_foam, p.foam_alone);
    return foam < p.foam_cutoff ? 0.0f : foam;
}

/// Computes the power in double: at 0 and at 1 it is exact.
template <typename Real>
Real cover_of(const SurfacePoint<Real>& p) {
    const auto foam = static_cast<double>(foam_of(p));
    return static_cast<Real>(wave::double_precision::foam_cover(foam, p.cover_power));
}

template float normal_x(const SurfacePoint<float>&);
template float normal_y(const SurfacePoint<float>&);
template float normal_z(const SurfacePoint<float>&);
template float jacobian_of(const SurfacePoint<float>&);
template float whitecap_of(const SurfacePoint<float>&);
template float foam_of(const SurfacePoint<float>&);
template float cover_of(const SurfacePoint<float>&);
template double normal_x(const SurfacePoint<double>&);
template double normal_y(const SurfacePoint<double>&);
template double normal_z(const SurfacePoint<double>&);
template double jacobian_of(const SurfacePoint<double>&);
template double whitecap_of(const SurfacePoint<double>&);
template double foam_of(const SurfacePoint<double>&);
template double cover_of(const SurfacePoint<double>&);

}  // namespace ocean::channel_formula
