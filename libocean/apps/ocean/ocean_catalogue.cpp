// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See ocean_catalogue.hpp.
#include "ocean_catalogue.hpp"

#if OCEAN_HAS_GL
#include <vector>

#include "ocean/gl/backend.hpp"
#endif

namespace ocean::app {

const Catalogue& ocean_catalogue() {
#if OCEAN_HAS_GL
    static const std::vector<Backend> backends = [] {
        const std::span<const Backend> core = core_backends();
        std::vector<Backend> all(core.begin(), core.end());
        all.push_back(gl::kBackend);
        all.push_back(gl::kThesisBackend);
        return all;
    }();
    static const Catalogue catalogue = [] {
        Catalogue longer = standard_catalogue();
        longer.backends = backends;
        return longer;
    }();
    return catalogue;
#else
    return standard_catalogue();
#endif
}

}  // namespace ocean::app
