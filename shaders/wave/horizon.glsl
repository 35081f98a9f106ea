// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The round Earth seen by an eye near its surface, in metres: to the second order of distance over
// radius. Light travels straight; the air's refraction, which lifts the horizon by some hundredths
// of a degree, is neglected.

formula real earth_radius() { return real(6371000.0); }  // mean

// How far still water lies below the level of the eye's place, d^2/(2R).
formula real earth_drop(real distance) {
    return distance * distance / (real(2.0) * earth_radius());
}

// Where still water ends for an eye at a height, or a crest of it sinks below the horizon:
// sqrt(2 R h).
formula real horizon_distance(real height) {
    return sqrt(real(2.0) * earth_radius() * max(height, real(0.0)));
}
