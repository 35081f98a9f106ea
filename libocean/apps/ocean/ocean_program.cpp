// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See ocean_program.hpp.
#include "ocean_program.hpp"

#include <vector>

#include "command_line.hpp"
#include "commands.hpp"
#include "ocean/version.hpp"
#if OCEAN_HAS_GL
#include "ocean/gl/backend.hpp"
#endif

namespace ocean::app {
namespace {

constexpr char kProgramFooter[] =
    R"(A sea is a sea file, a baked EXR file or preset:NAME (see `ocean presets`).
`ocean COMMAND --help` lists the options of a command.
Exit codes: 0 done, 1 failed at run time (disk, memory), 2 wrong usage or bad
sea file, 130 interrupted, 141 standard output was closed.)";

}  // namespace

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

int run_ocean(int argc, char** argv, const Catalogue& catalogue) {
    return run_program(
        argc, argv,
        {.main =
             {.name = "ocean",
              .summary =
                  "One statistical ocean, in real units, for Blender, POV-Ray, OpenGL and OpenEXR.",
              .options = {run_options("JSON lines on standard error; `info` prints JSON")},
              .footer = kProgramFooter},
         .version = "ocean " OCEAN_VERSION "\n" OCEAN_LIBRARY_VERSIONS,
         .commands = {info_command(), bake_command(catalogue), terrain_command(catalogue),
                      terrain_import_command(), terrain_fit_command(), check_command(),
                      farm_command(catalogue), povray_command(), query_command(), gauge_command(),
                      foam_texture_command(), spectrum_command(), records_command(),
                      params_command(), presets_command(), verify_command()}});
}

}  // namespace ocean::app
