// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Returns foam where a whitecap lies over earlier foam; alone: the part of a whitecap that shows
// where there is none. 1: the foam is max(whitecap, earlier). 0: the earlier foam was made by
// longer waves than the whitecap, which sharpens their front: it shows as a whole where foam is
// younger than ln 2 lifetimes. Waves too short to leave a trace would otherwise cover the sea with
// dots.
formula real foam_with_whitecap(real whitecap, real earlier, real alone) {
    return max(whitecap * min(real(1.0), alone + real(2.0) * earlier), earlier);
}

// Returns the share of the water that foam hides. At the right power its mean over the sea is that
// of the whitecaps; from far away the mean of this is seen, not that of the foam.
formula real foam_cover(real foam, real cover_power) {
    return pow(max(foam, real(0.0)), cover_power);
}
