// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Sunlight that enters the far side of a crest and leaves it towards the viewer, as a share 0 .. 1:
// a model of appearance, not of light transport in water. It is high where a crest rises above its
// surroundings; strong where the surface is compressed, as in thin crests about to break; visible
// looking against the sun, on the side that faces away from it. It falls as the sun rises from the
// horizon.
//
// height: above still water, in significant wave heights. jacobian: of the displaced surface. With
// s the horizontal part of the unit vector to the sun, against: v.s, v from the eye to the point;
// toward: n.s, n the normal of the waves that a mesh has.
formula real crest_light(real height, real jacobian, real against, real toward) {
    real high = min(max(height - real(0.1), real(0.0)), real(1.0));
    real squeezed = min(max(real(1.4) - jacobian, real(0.0)), real(1.0));
    real away = min(max(real(0.15) - toward, real(0.0)), real(1.0));
    if (against <= real(0.0) || away <= real(0.0)) return real(0.0);
    return high * squeezed * against * against * pow(away, real(0.7));
}
