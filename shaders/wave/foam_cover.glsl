// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Returns the share of the water that foam hides. At the right power its mean over the sea is that
// of the whitecaps; from far away the mean of this is seen, not that of the foam.
formula real foam_cover(real foam, real cover_power) {
    return pow(max(foam, real(0.0)), cover_power);
}
