// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Linear albedos of sand, Rec. 709.
const vec3 sand_albedo = vec3(0.42, 0.36, 0.26);
// Water between the grains takes half of the light [Lobell and Asner 2002].
const vec3 wet_sand_albedo = 0.5 * sand_albedo;
