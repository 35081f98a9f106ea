// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The release version. The sea file's format and the C ABI have versions of their own.
//
//     std::puts(OCEAN_VERSION);
#pragma once

#define OCEAN_VERSION "0.1.0"
