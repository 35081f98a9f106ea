// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The backend `gl`: maps from the GPU into the host's buffers; see ocean/gl/backend.hpp.
#include "ocean/gl/backend.hpp"

#include <algorithm>
#include <map>

#include "checks.hpp"
#include "coast_sums.hpp"
#include "gpu_function.hpp"
#include "map_frame.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/gl/context.hpp"
#include "ocean/internal/map_request.hpp"
#include "ocean/page_vector.hpp"
#include "ocean/thread_pool.hpp"
#include "write_quantity.hpp"

namespace ocean::gl {

namespace {

std::vector<Quantity> quantities_of(std::span<const MapOutput> outputs) {
    std::vector<Quantity> quantities;
    for (const MapOutput& output : outputs) {
        for (const auto& [quantity, factor] : output.used()) {
            if (quantity == Quantity{}) continue;
            if (std::ranges::find(quantities, quantity) == quantities.end()) {
                quantities.push_back(quantity);
            }
        }
    }
    return quantities;
}

/// The objects of one context: the frames of each resolution, and a texture for earlier foam.
class GpuMaps {
  public:
    explicit GpuMaps(const ContextInfo& limits) : limits_(limits) {}

    bool write(const MapRequest& request, ThreadPool& pool) {
        const std::vector<Quantity> quantities = quantities_of(request.outputs);
        if (quantities.empty()) return false;
        const int resolution = request.modes.resolution;
        auto found = maps_.find(resolution);
        if (found == maps_.end()) {
            found = maps_.emplace(resolution, OneResolution{{resolution, limits_}, {}}).first;
        }
        OneResolution& maps = found->second;
        const bool has_past =
            request.foam.map != nullptr && ocean::has_past(foam_use(channels_of(request.outputs)));
        if (has_past) upload_past(request.foam, resolution, maps.past);
        const bool uploaded =
            maps.frame.make(request, quantities, has_past ? &maps.past : nullptr, pool);
        read_back(maps.frame, request, pool);
        return uploaded;
    }

  private:
    struct OneResolution {
        MapFrame frame;
        Texture past;
    };

    static void upload_past(const FoamLayer& foam, int resolution, Texture& past) {
        if (!past) past = make_texture(GL_R32F, resolution);
        glBindTexture(GL_TEXTURE_2D, past.name());
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, resolution, resolution, GL_RED, GL_FLOAT, foam.map);
        require_no_error("uploading the foam");
    }

    void read_back(const MapFrame& frame, const MapRequest& request, ThreadPool& pool) {
        const auto samples = Lattice{request.modes.resolution, 1.0}.size();
        glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
        for (std::size_t m = 0; m < frame.plan().maps.size(); ++m) {
            const MapTexture& map = frame.plan().maps[m];
            texels_.resize(samples * static_cast<std::size_t>(map.components()));
            glBindTexture(GL_TEXTURE_2D, frame.map(m).name());
            glGetTexImage(GL_TEXTURE_2D, 0, map.pixel_format(), GL_FLOAT, texels_.data());
            require_no_error("reading a frame back");
            for (std::size_t c = 0; c < map.quantities.size(); ++c) {
                write_quantity(request, map.quantities[c], texels_.data() + c, map.components(),
                               pool);
            }
        }
    }

    ContextInfo limits_;
    std::map<int, OneResolution> maps_;
    PageVector<float> texels_;
};

/// The sums over a coast's waves, in the context of their first call.
class GpuCoast {
  public:
    void operator()(const CoastRequest& request) {
        objects_.use([&](CoastSums& sums) {
            sums.write(request);
            return true;
        });
    }

  private:
    GpuObjects<CoastSums> objects_;
};

/// Returns the bytes of modes, packs, textures and the buffer for reading back.
std::uint64_t gpu_bytes(const Grid&, LinearSet fields, int resolution) {
    const auto count = static_cast<std::uint64_t>(fields.size());
    const std::uint64_t packs = 8 * ((count + 1) / 2);
    const std::uint64_t textures = 16 * ((count + 3) / 4);
    return Lattice{resolution, 1.0}.size() * (20 + packs + textures + 16);
}

BackendFitness gpu_fitness(int resolution) {
    try {
        const HeadlessContext context;
        const HeadlessContext::Current current(context);
        const MapFrame frame(resolution, context.info());
        const std::string machine = context.info().text();
        if (context.info().software) return {true, false, machine + ", is not a GPU"};
        return {true, true, machine};
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::no_gpu) throw;
        return {false, false, error.what()};
    }
}

}  // namespace

const Backend kBackend = {"gl",
                          kEveryChannel,
                          [] { return MapFunction(GpuFunction<GpuMaps>()); },
                          gpu_bytes,
                          gpu_fitness,
                          true,
                          [] { return CoastFunction(GpuCoast()); }};

}  // namespace ocean::gl
