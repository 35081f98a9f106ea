// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Linear albedos of sand, Rec. 709.
const vec3 sand_albedo = vec3(0.42, 0.36, 0.26);
const vec3 wet_sand_albedo = vec3(0.19, 0.155, 0.11);
// Sand below water, whose ripples shade each other.
const vec3 bed_albedo = 0.55 * sand_albedo;
