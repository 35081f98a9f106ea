// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The displaced surface of one texel. The point of label (x, y) is shown at
// (x - C Dx, y - C Dy, h), where C is the choppiness and D the horizontal displacement.
// Symbols: dxx = dDx/dx, dyy = dDy/dy, dxy = dDx/dy = dDy/dx; hx, hy slope of h by label.

struct SurfaceNormal {
    real x;
    real y;
    real z;
};

// J = (1 - C dxx)(1 - C dyy) - (C dxy)^2: area of the shown surface, seen from above, per area of
// label. 1 is undisturbed, below 0 the surface has folded. [Tessendorf 2001] eq. 45.
formula real surface_jacobian(real choppiness, real dxx, real dyy, real dxy) {
    real xx = real(1.0) - choppiness * dxx;
    real yy = real(1.0) - choppiness * dyy;
    real xy = choppiness * dxy;
    return xx * yy - xy * xy;
}

// W = clamp((threshold - J) / width, 0, 1): how white water is that the waves squeeze together.
formula real surface_whitecap(real jacobian, real threshold, real width) {
    return min(max((threshold - jacobian) / width, real(0.0)), real(1.0));
}

// Unit normal of the shown surface: cross product of its two tangents (1 - C dxx, -C dxy, hx) and
// (-C dxy, 1 - C dyy, hy). With C = 0 it is (-hx, -hy, 1) made a unit vector.
formula SurfaceNormal surface_normal(real choppiness, real dxx, real dyy, real dxy, real hx,
                                     real hy) {
    real xx = real(1.0) - choppiness * dxx;
    real yy = real(1.0) - choppiness * dyy;
    real xy = choppiness * dxy;
    real x = -xy * hy - yy * hx;
    real y = -xy * hx - xx * hy;
    real z = xx * yy - xy * xy;
    real scale = inversesqrt(x * x + y * y + z * z);
    SurfaceNormal normal;
    normal.x = scale * x;
    normal.y = scale * y;
    normal.z = scale * z;
    return normal;
}
