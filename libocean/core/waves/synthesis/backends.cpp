// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The backends of core, in one table.
#include "ocean/backend.hpp"

#include <complex>
#include <string>

#include "ocean/error.hpp"
#include "ocean/internal/map_request.hpp"
#include "ocean/internal/nearest_name.hpp"
#include "ocean/internal/text.hpp"
#include "waves/kernel/cpu_backend.hpp"
#include "waves/surface/plane_channels.hpp"
#include "waves/synthesis/synthesis.hpp"

namespace ocean {

MapModes map_modes(const Modes& modes, double time, int resolution) {
    return {modes.cascades,     modes.lattice.period,   1,
            modes.tau(time),    modes.rate_unit(),      resolution,
            modes.revision,     modes.lattice_revision, 0,
            modes.binding_limit};
}

MapModes map_modes(const Modes& from, const Modes& to, float share, double time, int resolution) {
    MapModes modes = map_modes(from, time, resolution);
    modes.toward = to.cascades;
    modes.toward_revision = to.revision;
    modes.share = share;
    return modes;
}

MapModes cascade_modes(const Modes& modes, std::size_t cascade, double time, int resolution) {
    const CascadeModes& own = modes.cascades[cascade];
    return {{&own, 1},
            own.lattice.period,
            own.divisor,
            modes.tau(time),
            modes.rate_unit(),
            resolution,
            modes.revision,
            modes.lattice_revision,
            0,
            cascade == 0 ? modes.binding_limit : 0.0};
}

namespace {

/// Returns a reference backend. It computes planes of all fields that the channels may need, and
/// keeps nothing.
template <auto kSynthesize>
MapFunction start_reference() {
    return [](const MapRequest& request, ThreadPool& pool) {
        const LinearSet fields =
            fields_of(request.outputs) | fields_of(channels_of(request.outputs));
        write_channels(kSynthesize(request.modes, fields, pool), request, {}, pool);
        return false;
    };
}

/// Returns the bytes of a complex grid in `Real` and a plane in float for each field.
template <typename Real>
std::uint64_t reference_bytes(const Grid&, LinearSet fields, int resolution) {
    return Lattice{resolution, 1.0}.size() * static_cast<std::uint64_t>(fields.size()) *
           (sizeof(std::complex<Real>) + sizeof(float));
}

}  // namespace

constexpr Backend Backend::cpu = {.name = "cpu",
                                  .makes = kCpuChannels,
                                  .start = start_cpu,
                                  .work_bytes = kernel_bytes,
                                  .keeps_foam = true,
                                  .interpolates = true};
constexpr Backend Backend::radix2 = {"radix2", kEveryChannel, start_reference<synthesize_radix2>,
                                     reference_bytes<float>};
constexpr Backend Backend::dft = {"dft", kEveryChannel, start_reference<synthesize_dft>,
                                  reference_bytes<double>};

std::span<const Backend> core_backends() {
    static constexpr Backend kBackends[] = {Backend::cpu, Backend::radix2, Backend::dft};
    return kBackends;
}

const Backend& find_backend(std::string_view name) {
    const std::span<const Backend> known = core_backends();
    const auto found = std::ranges::find(known, name, &Backend::name);
    if (found != known.end()) return *found;
    if (name == "gl" || name == "thesis") {
        throw Error(ErrorKind::unsupported,
                    "backend " + std::string(name) +
                        " is not in this program, which was built without a GPU library; the build "
                        "of `cmake --preset release` has it where libepoxy is installed");
    }
    throw Error(ErrorKind::invalid_value, "unknown backend '" + std::string(name) + "'" +
                                              did_you_mean(name, known, &Backend::name) +
                                              "; known: " + joined(known, ", ", &Backend::name));
}

}  // namespace ocean
