// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// From linear planes to the fields that users see: the displaced surface, its normal, Jacobian and
// velocity. Last stage of the pipeline.
#include "ocean/surface.hpp"

#include <algorithm>
#include <cmath>

#include "base/wave.hpp"
#include "kernel/map_kernel.hpp"
#include "ocean/error.hpp"
#include "ocean/foam.hpp"
#include "ocean/map_output.hpp"
#include "ocean/thread_pool.hpp"
#include "synthesis/synthesis.hpp"

namespace ocean {

ChannelSet FieldInfo::set() const {
    ChannelSet result;
    for (int i = 0; i < count; ++i) {
        result = result | ChannelSet{channels[static_cast<std::size_t>(i)]};
    }
    return result;
}

std::span<const FieldInfo> field_table() {
    using enum Channel;
    static constexpr FieldInfo kFields[] = {
        {"height", {height}, 1, "m"},
        {"displacement", {dx, dy, height}, 3, "m"},
        {"slope", {slope_x, slope_y}, 2, ""},
        {"normal", {nx, ny, nz}, 3, ""},
        {"jacobian", {jacobian}, 1, ""},
        {"whitecap", {whitecap}, 1, ""},
        {"foam", {foam}, 1, ""},
        {"velocity", {vx, vy, vz}, 3, "m/s"},
    };
    return kFields;
}

const FieldInfo& find_field(std::string_view name) {
    std::string known;
    for (const FieldInfo& field : field_table()) {
        if (field.name == name) return field;
        known += (known.empty() ? "" : ", ") + std::string(field.name);
    }
    throw Error(ErrorKind::invalid_value,
                "unknown product '" + std::string(name) + "'; known: " + known);
}

namespace {

[[noreturn]] void refuse_gl() {
    throw Error(ErrorKind::unsupported,
                "backend gl comes with a later version of libocean; use cpu");
}

}  // namespace

Backend find_backend(std::string_view name) {
    if (name == "cpu") return Backend::cpu;
    if (name == "radix2") return Backend::radix2;
    if (name == "dft") return Backend::dft;
    if (name == "gl") refuse_gl();
    throw Error(ErrorKind::invalid_value,
                "unknown backend '" + std::string(name) + "'; known: cpu, radix2, dft");
}

std::string_view backend_name(Backend backend) {
    switch (backend) {
        case Backend::gl:
            return "gl";
        case Backend::radix2:
            return "radix2";
        case Backend::dft:
            return "dft";
        case Backend::cpu:
            break;
    }
    return "cpu";
}

Surface::Surface(Lattice lattice, double time, ChannelSet channels)
    : lattice_(lattice), time_(time), channels_(channels) {
    for (int c = 0; c < kChannelCount; ++c) {
        if (has(static_cast<Channel>(c))) maps_[static_cast<std::size_t>(c)].resize(lattice.size());
    }
}

std::span<const float> Surface::channel(Channel channel) const {
    return maps_[static_cast<std::size_t>(channel)];
}

std::span<float> Surface::channel(Channel channel) {
    return maps_[static_cast<std::size_t>(channel)];
}

std::vector<MapOutput> outputs_of(Surface& surface) {
    std::vector<MapOutput> outputs;
    for (int c = 0; c < kChannelCount; ++c) {
        const auto channel = static_cast<Channel>(c);
        if (!surface.has(channel)) continue;
        outputs.push_back({surface.channel(channel).data(), 1, {{{channel, 1.0f}}}});
    }
    return outputs;
}

namespace {

constexpr ChannelSet kNormal = {Channel::nx, Channel::ny, Channel::nz};
constexpr ChannelSet kNeedsGradients =
    kNormal | ChannelSet{Channel::jacobian, Channel::whitecap, Channel::foam};

}  // namespace

bool is_made_of(ChannelSet channels, Linear field, bool flat) {
    switch (field) {
        case Linear::height:
            return channels.contains(Channel::height);
        case Linear::displacement_x:
            return channels.contains(Channel::dx);
        case Linear::displacement_y:
            return channels.contains(Channel::dy);
        case Linear::slope_x:
            return channels.intersects(kNormal | ChannelSet{Channel::slope_x});
        case Linear::slope_y:
            return channels.intersects(kNormal | ChannelSet{Channel::slope_y});
        case Linear::gradient_xx:
        case Linear::gradient_yy:
        case Linear::gradient_xy:
            return !flat && channels.intersects(kNeedsGradients);
        case Linear::height_rate:
            return channels.contains(Channel::vz);
        case Linear::displacement_x_rate:
            return channels.contains(Channel::vx);
        case Linear::displacement_y_rate:
            return channels.contains(Channel::vy);
    }
    return false;
}

std::vector<Linear> linear_fields(ChannelSet channels) {
    std::vector<Linear> fields;
    for (int f = 0; f < kLinearCount; ++f) {
        if (is_made_of(channels, static_cast<Linear>(f))) fields.push_back(static_cast<Linear>(f));
    }
    return fields;
}

namespace {

inline wave::single_precision::SurfaceNormal normal_of(float c, float xx, float yy, float xy,
                                                       float hx, float hy) {
    return wave::single_precision::surface_normal(c, xx, yy, xy, hx, hy);
}
inline wave::double_precision::SurfaceNormal normal_of(double c, double xx, double yy, double xy,
                                                       double hx, double hy) {
    return wave::double_precision::surface_normal(c, xx, yy, xy, hx, hy);
}
inline float jacobian_of(float c, float xx, float yy, float xy) {
    return wave::single_precision::surface_jacobian(c, xx, yy, xy);
}
inline double jacobian_of(double c, double xx, double yy, double xy) {
    return wave::double_precision::surface_jacobian(c, xx, yy, xy);
}
inline float whitecap_of(float jacobian, float threshold, float width) {
    return wave::single_precision::surface_whitecap(jacobian, threshold, width);
}
inline double whitecap_of(double jacobian, double threshold, double width) {
    return wave::double_precision::surface_whitecap(jacobian, threshold, width);
}

/// Turns planes into channels, in the precision of the backend, rounding once at the end.
template <typename Real>
class Combination {
  public:
    Combination(const LinearPlanes<Real>& planes, const SurfaceSettings& settings, Surface& surface,
                ThreadPool& pool)
        : planes_(planes),
          choppiness_(static_cast<Real>(settings.choppiness)),
          threshold_(static_cast<Real>(settings.foam_threshold)),
          width_(static_cast<Real>(settings.foam_width)),
          surface_(surface),
          pool_(pool) {}

    void run() {
        copy(Channel::height, Linear::height, 1);
        copy(Channel::dx, Linear::displacement_x, -choppiness_);
        copy(Channel::dy, Linear::displacement_y, -choppiness_);
        copy(Channel::slope_x, Linear::slope_x, 1);
        copy(Channel::slope_y, Linear::slope_y, 1);
        copy(Channel::vz, Linear::height_rate, 1);
        copy(Channel::vx, Linear::displacement_x_rate, -choppiness_);
        copy(Channel::vy, Linear::displacement_y_rate, -choppiness_);
        if (surface_.has(Channel::jacobian)) {
            from_jacobian(Channel::jacobian, [](Real jacobian) { return jacobian; });
        }
        if (surface_.has(Channel::whitecap)) {
            from_jacobian(Channel::whitecap, [this](Real jacobian) {
                return whitecap_of(jacobian, threshold_, width_);
            });
        }
        if (surface_.channels().intersects(kNormal)) normals();
    }

  private:
    template <typename Body>
    void each_row(const Body& body) {
        const auto width = static_cast<std::size_t>(surface_.resolution());
        pool_.for_each_range(surface_.resolution(), [&](int first, int last) {
            body(static_cast<std::size_t>(first) * width, static_cast<std::size_t>(last) * width);
        });
    }

    void copy(Channel channel, Linear field, Real factor) {
        if (!surface_.has(channel)) return;
        const PageVector<Real>& from = planes_[field];
        const std::span<float> to = surface_.channel(channel);
        each_row([&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) to[i] = static_cast<float>(factor * from[i]);
        });
    }

    template <typename Function>
    void from_jacobian(Channel channel, const Function& function) {
        const std::span<float> to = surface_.channel(channel);
        each_row([&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) {
                to[i] = static_cast<float>(function(
                    jacobian_of(choppiness_, planes_[Linear::gradient_xx][i],
                                planes_[Linear::gradient_yy][i], planes_[Linear::gradient_xy][i])));
            }
        });
    }

    void normals() {
        float* const nx = surface_.channel(Channel::nx).data();  // null: not asked for
        float* const ny = surface_.channel(Channel::ny).data();
        float* const nz = surface_.channel(Channel::nz).data();
        each_row([&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) {
                const auto n =
                    normal_of(choppiness_, planes_[Linear::gradient_xx][i],
                              planes_[Linear::gradient_yy][i], planes_[Linear::gradient_xy][i],
                              planes_[Linear::slope_x][i], planes_[Linear::slope_y][i]);
                if (nx != nullptr) nx[i] = static_cast<float>(n.x);
                if (ny != nullptr) ny[i] = static_cast<float>(n.y);
                if (nz != nullptr) nz[i] = static_cast<float>(n.z);
            }
        });
    }

    const LinearPlanes<Real>& planes_;
    Real choppiness_;
    Real threshold_;
    Real width_;
    Surface& surface_;
    ThreadPool& pool_;
};

template <typename Real>
Surface combine(const LinearPlanes<Real>& planes, const Lattice& lattice, double time,
                const SurfaceSettings& settings, ChannelSet channels, ThreadPool& pool) {
    Surface surface(lattice, time, channels);
    Combination<Real>(planes, settings, surface, pool).run();
    return surface;
}

Surface kernel_surface(const SynthesisRequest& request, const Lattice& lattice, double time,
                       const SurfaceSettings& settings, ChannelSet channels, ThreadPool& pool) {
    Surface surface(lattice, time, channels);
    const std::vector<MapOutput> outputs = outputs_of(surface);
    MapKernel(pack_modes(request, pool)).run({request.tau, settings, outputs, {}}, pool);
    return surface;
}

int chosen_resolution(int resolution, int own) {
    if (resolution == 0) return own;
    require_resolution(resolution);
    return resolution;
}

}  // namespace

SurfaceSettings with_threshold(const SurfaceSettings& settings, const Modes& modes,
                               int resolution) {
    SurfaceSettings result = settings;
    result.foam_threshold =
        whitecap_threshold(modes.gradient_covariance(resolution), settings, modes.wind_speed);
    result.foam_coverage = FoamCoverage::threshold;
    return result;
}

Surface make_surface(const Modes& modes, const SurfaceSettings& settings, double time,
                     ChannelSet channels, Backend backend, ThreadPool& pool, int resolution) {
    require_finite_time(time);
    resolution = chosen_resolution(resolution, modes.lattice.resolution);
    if (channels.contains(Channel::foam)) {
        throw Error(ErrorKind::invalid_value,
                    "foam has a past: it is made by Ocean or a FoamState, not from one moment");
    }
    const SurfaceSettings found = channels.contains(Channel::whitecap)
                                      ? with_threshold(settings, modes, resolution)
                                      : settings;
    const Lattice lattice{resolution, modes.lattice.period};
    const SynthesisRequest request =
        synthesis_request(modes, time, resolution, linear_fields(channels));
    switch (backend) {
        case Backend::cpu:
            return kernel_surface(request, lattice, time, found, channels, pool);
        case Backend::radix2:
            return combine(synthesize_radix2(request, pool), lattice, time, found, channels, pool);
        case Backend::dft:
            return combine(synthesize_dft(request, pool), lattice, time, found, channels, pool);
        case Backend::gl:
            break;
    }
    refuse_gl();
}

LinearPlanes<float> make_cascade_planes(const Modes& modes, std::size_t cascade, double time,
                                        std::span<const Linear> fields, Backend backend,
                                        ThreadPool& pool, int resolution) {
    require_finite_time(time);
    const CascadeModes& own = modes.cascades[cascade];
    const SynthesisRequest request{{&own, 1},
                                   own.lattice.period,
                                   own.divisor,
                                   modes.tau(time),
                                   modes.rate_unit(),
                                   chosen_resolution(resolution, own.lattice.resolution),
                                   {fields.begin(), fields.end()}};
    switch (backend) {
        case Backend::cpu:
            return synthesize_cpu(request, pool);
        case Backend::radix2:
            return synthesize_radix2(request, pool);
        case Backend::dft: {
            const LinearPlanes<double> exact = synthesize_dft(request, pool);
            LinearPlanes<float> planes;
            for (const Linear field : fields) {
                planes[field].assign(exact[field].begin(), exact[field].end());
            }
            return planes;
        }
        case Backend::gl:
            break;
    }
    refuse_gl();
}

Surface combine_planes(const LinearPlanes<float>& planes, const Lattice& lattice, double time,
                       const SurfaceSettings& settings, ChannelSet channels, ThreadPool& pool) {
    Surface surface(lattice, time, channels);
    const std::vector<MapOutput> outputs = outputs_of(surface);
    PlanarFields fields{{}, static_cast<std::size_t>(lattice.resolution)};
    for (int f = 0; f < kLinearCount; ++f) {
        fields.plane[static_cast<std::size_t>(f)] = planes[static_cast<Linear>(f)].data();
    }
    pool.for_each_range(lattice.resolution, [&](int first, int last) {
        write_rows(fields, lattice.resolution, first, last, {0.0, settings, outputs, {}});
    });
    return surface;
}

}  // namespace ocean
