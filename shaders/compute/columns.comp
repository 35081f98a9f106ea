// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Pass two of a frame: the transform along y, then the maps. A workgroup has COLUMNS columns side by
// side. Defined outside: N, COLUMNS, PACKS, FIELD_name for each linear field, MAPS, FORMAT_m and
// TEXEL_m for each map, and FOAM where a channel reads the foam's past.
#define LINES COLUMNS
#include "wave/foam_cover.glsl"
#include "wave/surface.glsl"
#include "compute/complex.glsl"
#include "compute/line_transform.glsl"
#include "compute/packs.glsl"
#include "compute/channels.glsl"

layout(local_size_x = COLUMNS, local_size_y = THREADS) in;

layout(binding = 0, FORMAT_0) writeonly restrict uniform image2D map_0;
#if MAPS > 1
layout(binding = 1, FORMAT_1) writeonly restrict uniform image2D map_1;
#endif
#if MAPS > 2
layout(binding = 2, FORMAT_2) writeonly restrict uniform image2D map_2;
#endif
#if MAPS > 3
layout(binding = 3, FORMAT_3) writeonly restrict uniform image2D map_3;
#endif
#if MAPS > 4
layout(binding = 4, FORMAT_4) writeonly restrict uniform image2D map_4;
#endif
#if MAPS > 5
layout(binding = 5, FORMAT_5) writeonly restrict uniform image2D map_5;
#endif
#if MAPS > 6
layout(binding = 6, FORMAT_6) writeonly restrict uniform image2D map_6;
#endif
#if FOAM
layout(binding = 0) uniform sampler2D foam_past;
#endif
layout(location = 3) uniform float gradient_scale;  // as in pass one

#define READ_AND_TRANSFORM(VALUES, PACK) \
    vec2 VALUES[8]; \
    for (uint e = 0u; e < 8u; ++e) VALUES[e] = PACK.value[pack_index(x, thread + e * THREADS)]; \
    inverse_transform(VALUES, thread, line)

void main() {
    uint line = gl_LocalInvocationID.x;
    uint thread = gl_LocalInvocationID.y;
    uint x = gl_WorkGroupID.x * COLUMNS + line;
    READ_AND_TRANSFORM(values_0, pack_0);
#if PACKS > 1
    READ_AND_TRANSFORM(values_1, pack_1);
#endif
#if PACKS > 2
    READ_AND_TRANSFORM(values_2, pack_2);
#endif
#if PACKS > 3
    READ_AND_TRANSFORM(values_3, pack_3);
#endif
#if PACKS > 4
    READ_AND_TRANSFORM(values_4, pack_4);
#endif
#if PACKS > 5
    READ_AND_TRANSFORM(values_5, pack_5);
#endif
    for (uint e = 0u; e < 8u; ++e) {
        ivec2 at = ivec2(x, thread + e * THREADS);
        Fields p = Fields(FIELD_height, FIELD_displacement_x, FIELD_displacement_y, FIELD_slope_x,
                          FIELD_slope_y, FIELD_gradient_xx, FIELD_gradient_yy, FIELD_gradient_xy,
                          FIELD_height_rate, FIELD_displacement_x_rate, FIELD_displacement_y_rate);
#if FOAM
        float previous_foam = texelFetch(foam_past, at % textureSize(foam_past, 0), 0).x;
#else
        const float previous_foam = 0.0;
#endif
        imageStore(map_0, at, TEXEL_0);
#if MAPS > 1
        imageStore(map_1, at, TEXEL_1);
#endif
#if MAPS > 2
        imageStore(map_2, at, TEXEL_2);
#endif
#if MAPS > 3
        imageStore(map_3, at, TEXEL_3);
#endif
#if MAPS > 4
        imageStore(map_4, at, TEXEL_4);
#endif
#if MAPS > 5
        imageStore(map_5, at, TEXEL_5);
#endif
#if MAPS > 6
        imageStore(map_6, at, TEXEL_6);
#endif
    }
}
