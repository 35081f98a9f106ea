// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0

// What the air hides of a thing at a distance, both in metres, and shows its own light instead:
// the visibility is where 2 % of the contrast are left, ln 50 = 3.912 [Koschmieder 1924].
formula real haze(real distance, real visibility) {
    return real(1.0) - exp(real(-3.912) * distance / visibility);
}
