// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The source file of the precompiled header that CMakeLists.txt of this folder lists.
