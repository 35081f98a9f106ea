// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The release version, apart from the sea file's format version and the C ABI's.
#pragma once

#define OCEAN_VERSION "0.1.0"
