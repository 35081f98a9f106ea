// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The share of the water that foam hides. The power is that at which the mean over the sea is that
// of the whitecaps; what is seen from far away is the mean of this, not of the foam.
formula real foam_cover(real foam, real cover_power) {
    return pow(max(foam, real(0.0)), cover_power);
}
