// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Stages as pictures; see ocean/internal/gl/stages.hpp.
#include "ocean/internal/gl/stages.hpp"

#include <bit>
#include <complex>
#include <map>

#include "checks.hpp"
#include "gpu_function.hpp"
#include "modes_on_gpu.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/gl/context.hpp"
#include "ocean/internal/nearest_name.hpp"
#include "thesis_frame.hpp"

namespace ocean::gl {

namespace {

int octaves_of(int resolution) {
    return std::countr_zero(static_cast<unsigned>(resolution));
}

StageImage amplitudes_image(const MapModes& modes, ThreadPool& pool) {
    const auto amplitudes = map_amplitudes(modes, pool);
    const auto size = static_cast<std::size_t>(modes.resolution);
    StageImage image{modes.resolution, modes.resolution, {"R", "G", "B", "A"}, {}};
    image.texels.reserve(4 * amplitudes.size());
    const auto index = [&](std::size_t centred) { return (centred + size / 2) % size; };
    for (std::size_t j = 0; j < size; ++j) {
        for (std::size_t i = 0; i < size; ++i) {
            const std::size_t x = index(i);
            const std::size_t y = index(j);
            const std::complex<float> own = amplitudes[y * size + x];
            const std::complex<float> mirror =
                amplitudes[(size - y) % size * size + (size - x) % size];
            image.texels.insert(image.texels.end(),
                                {own.real(), own.imag(), mirror.real(), -mirror.imag()});
        }
    }
    return image;
}

StageImage read_texture(const Texture& texture, int width, int height, GLenum format,
                        std::vector<std::string> channels) {
    StageImage image{width, height, std::move(channels), {}};
    image.texels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                        image.channels.size());
    glBindTexture(GL_TEXTURE_2D, texture.name());
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    glGetTexImage(GL_TEXTURE_2D, 0, format, GL_FLOAT, image.texels.data());
    require_no_error("reading a stage back");
    return image;
}

class StageFrames {
  public:
    explicit StageFrames(const ContextInfo& limits) : limits_(limits) {}

    ThesisFrame& of(int resolution) {
        const auto found = frames_.find(resolution);
        if (found != frames_.end()) return found->second;
        return frames_.emplace(resolution, ThesisFrame(resolution, limits_)).first->second;
    }

  private:
    ContextInfo limits_;
    std::map<int, ThesisFrame> frames_;
};

}  // namespace

struct StageMaker::Impl : GpuObjects<StageFrames> {};

StageMaker::StageMaker() : impl_(std::make_unique<Impl>()) {}

StageMaker::~StageMaker() = default;

std::vector<std::string> stage_names(int resolution) {
    std::vector<std::string> names = {"h0", "spectrum", "butterfly"};
    for (const char* axis : {"horizontal-", "vertical-"}) {
        for (int k = 1; k <= octaves_of(resolution); ++k) names.push_back(axis + std::to_string(k));
    }
    return names;
}

StageImage StageMaker::make(const MapModes& modes, std::string_view stage, ThreadPool& pool) {
    const int resolution = modes.resolution;
    const int octaves = octaves_of(resolution);
    const std::vector<std::string> names = stage_names(resolution);
    const auto found = std::ranges::find(names, stage);
    if (found == names.end()) {
        const std::vector<std::string_view> known(names.begin(), names.end());
        throw Error(ErrorKind::invalid_value,
                    "unknown stage '" + std::string(stage) + "'" + did_you_mean(stage, known) +
                        "; known: h0, spectrum, butterfly, horizontal-1 .. horizontal-" +
                        std::to_string(octaves) + ", vertical-1 .. vertical-" +
                        std::to_string(octaves));
    }
    if (stage == "h0") return amplitudes_image(modes, pool);

    return impl_->use([&](StageFrames& frames) {
        ThesisFrame& frame = frames.of(resolution);
        if (stage == "butterfly") {
            return read_texture(frame.butterflies(), octaves, resolution, GL_RGBA,
                                {"R", "G", "B", "A"});
        }
        const MapRequest request{modes, {}, {}, {}};
        frame.load(request, pool);
        // "spectrum" is name 1: no stage is done; horizontal-1 is name 3.
        const auto name = static_cast<int>(found - names.begin());
        frame.transform_stages(Linear::height, request, std::max(0, name - 2));
        return read_texture(frame.complex(), resolution, resolution, GL_RG, {"R", "G"});
    });
}

}  // namespace ocean::gl
