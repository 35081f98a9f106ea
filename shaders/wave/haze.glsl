// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0

// Returns the share of an object's light that the air replaces by its own at a distance [m].
// visibility: the distance where 2 % of the contrast remain [m], ln 50 = 3.912 [Koschmieder 1924].
formula real haze(real distance, real visibility) {
    return real(1.0) - exp(real(-3.912) * distance / visibility);
}
