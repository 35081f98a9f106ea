// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Loads MKL's transforms if their module lies beside the program.
#include <dlfcn.h>

#include <cstdlib>

#include "transforms.hpp"

namespace ocean::bench {

const TransformLibrary* mkl_library(SimdLevel level) {
    static const TransformLibrary* const library = [level]() -> const TransformLibrary* {
        // Read by MKL when it is loaded, and on Intel's own processors only.
        setenv("MKL_ENABLE_INSTRUCTIONS", level == SimdLevel::avx512 ? "AVX512" : "AVX2", 1);
        // DEEPBIND: what is inside is MKL's own, whatever else the process has by these names.
        void* module = dlopen("$ORIGIN/ocean_bench_mkl.so", RTLD_NOW | RTLD_LOCAL | RTLD_DEEPBIND);
        if (module == nullptr) return nullptr;
        using Entry = const TransformLibrary* (*)();
        const auto entry = reinterpret_cast<Entry>(dlsym(module, "ocean_bench_mkl"));
        return entry == nullptr ? nullptr : entry();
    }();
    return library;
}

}  // namespace ocean::bench
