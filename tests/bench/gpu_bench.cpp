// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What a frame of the backend `gl` takes on the GPU of this machine, pass by pass, beside a copy of
// memory in the same run and the transform by stages (`thesis`), as a Markdown table.
// usage: ocean_gpu_bench [--sizes 512,1024] [--frames N]
#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "map_frame.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/gl/context.hpp"
#include "ocean/internal/map_request.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/ocean.hpp"
#include "thesis_frame.hpp"

using namespace ocean;
using namespace ocean::gl;

namespace {

/// Points of time on the GPU. A processor that plays a GPU has no clock for it: then it is waited
/// for.
class GpuClock {
  public:
    explicit GpuClock(bool software) : software_(software) {}
    ~GpuClock() { glDeleteQueries(static_cast<GLsizei>(queries_.size()), queries_.data()); }
    GpuClock(const GpuClock&) = delete;
    GpuClock& operator=(const GpuClock&) = delete;

    void mark() {
        if (software_) {
            glFinish();
            waited_.push_back(std::chrono::steady_clock::now());
            return;
        }
        if (used_ == queries_.size()) glGenQueries(1, &queries_.emplace_back());
        glQueryCounter(queries_[used_++], GL_TIMESTAMP);
    }
    /// Seconds from each mark to the next; then there are none.
    std::vector<double> seconds() {
        std::vector<double> result;
        glFinish();
        if (software_) {
            for (std::size_t i = 1; i < waited_.size(); ++i) {
                result.push_back(
                    std::chrono::duration<double>(waited_[i] - waited_[i - 1]).count());
            }
            waited_.clear();
            return result;
        }
        GLuint64 before = 0;
        for (std::size_t i = 0; i < used_; ++i) {
            GLuint64 now = 0;
            glGetQueryObjectui64v(queries_[i], GL_QUERY_RESULT, &now);
            if (i > 0) result.push_back(1e-9 * static_cast<double>(now - before));
            before = now;
        }
        used_ = 0;
        return result;
    }

  private:
    bool software_;
    std::vector<std::chrono::steady_clock::time_point> waited_;
    std::vector<GLuint> queries_;
    std::size_t used_ = 0;
};

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Bytes a second, read and written, of a copy too large for any cache.
double copy_bandwidth(GpuClock& clock, int rounds, bool software) {
    const GLsizeiptr bytes = (software ? 128 : 1024) << 20;
    Buffer from;
    Buffer to;
    resize_storage(from, static_cast<std::size_t>(bytes), nullptr);
    resize_storage(to, static_cast<std::size_t>(bytes), nullptr);
    glBindBuffer(GL_COPY_READ_BUFFER, from.name());
    glBindBuffer(GL_COPY_WRITE_BUFFER, to.name());
    std::vector<double> seconds;
    for (int i = 0; i < rounds; ++i) {
        clock.mark();
        glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, bytes);
        clock.mark();
        seconds.push_back(clock.seconds()[0]);
    }
    return 2.0 * static_cast<double>(bytes) / median(seconds);
}

Parameters sea_of(int resolution) {
    Parameters parameters;
    parameters.grid.resolution = resolution;
    parameters.grid.patch_size = 0.8 * resolution;
    parameters.waves.front().spectrum = SpectrumKind::jonswap;
    return parameters;
}

struct Row {
    double rows, columns, thesis, bytes;  // s, s, s for the same eight fields, B
};

Row measure(int resolution, const ContextInfo& limits, GpuClock& clock, int frames) {
    using enum Linear;
    Ocean sea(sea_of(resolution));
    const Modes& modes = sea.modes();
    const std::vector<Quantity> eight = {height,  displacement_x, displacement_y, gradient_xy,
                                         slope_x, slope_y,        gradient_xx,    gradient_yy};
    std::vector<double> rows;
    std::vector<double> columns;
    {
        MapFrame frame(resolution, limits);
        frame.watch([&] { clock.mark(); });
        for (int i = 0; i < frames + 2; ++i) {
            frame.make({map_modes(modes, i / 60.0, resolution), {}, {}, {}}, eight, nullptr,
                       sea.pool());
            const std::vector<double> seconds = clock.seconds();
            if (i < 2) continue;  // compiled, uploaded
            rows.push_back(seconds[0]);
            columns.push_back(seconds[1]);
        }
    }
    std::vector<double> thesis;
    ThesisFrame frame(resolution, limits);
    for (int i = 0; i < frames + 1; ++i) {
        const MapRequest request{map_modes(modes, i / 60.0, resolution), {}, {}, {}};
        frame.load(request, sea.pool());
        clock.mark();
        for (const Quantity field : eight) frame.transform(field.linear(), request);
        clock.mark();
        const double seconds = clock.seconds()[0];
        if (i > 0) thesis.push_back(seconds);
    }
    return {median(rows), median(columns), median(thesis), 124.0 * resolution * resolution};
}

std::vector<int> sizes_of(const std::string& text) {
    std::vector<int> sizes;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find(',', at), text.size());
        sizes.push_back(parse_whole_number(text.substr(at, end - at), "--sizes", kMinResolution,
                                           kMaxResolution));
        require_resolution(sizes.back());
        at = end + 1;
    }
    return sizes;
}

void run(int argc, char** argv) {
    const HeadlessContext context;
    const HeadlessContext::Current current(context);
    const ContextInfo& limits = context.info();
    std::vector<int> sizes = {512, 1024, 2048, 4096};
    if (limits.software) sizes = {256, 512};
    int frames = limits.software ? 5 : 200;
    for (int i = 1; i < argc; ++i) {
        if (i + 1 < argc && std::strcmp(argv[i], "--sizes") == 0) {
            sizes = sizes_of(argv[++i]);
        } else if (i + 1 < argc && std::strcmp(argv[i], "--frames") == 0) {
            frames = parse_whole_number(argv[++i], "--frames", 1, 100000);
        } else {
            throw Error(ErrorKind::invalid_value,
                        "usage: ocean_gpu_bench [--sizes 512,1024] [--frames N]");
        }
    }
    GpuClock clock(limits.software);
    const double copy = copy_bandwidth(clock, limits.software ? 5 : 50, limits.software);
    std::printf("%s. Copy of memory: %.0f GB/s, read and written.\n\n", limits.text().c_str(),
                1e-9 * copy);
    std::printf(
        "| N | rows, ms | columns, ms | frame, ms | MB | GB/s | of the copy | "
        "thesis, ms | thesis / frame |\n");
    std::printf("| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
    for (const int size : sizes) {
        const Row row = measure(size, limits, clock, frames);
        const double frame = row.rows + row.columns;
        std::printf("| %d | %.3g | %.3g | %.3g | %.0f | %.0f | %.2f | %.3g | %.1f |\n", size,
                    1e3 * row.rows, 1e3 * row.columns, 1e3 * frame, 1e-6 * row.bytes,
                    1e-9 * row.bytes / frame, row.bytes / frame / copy, 1e3 * row.thesis,
                    row.thesis / frame);
        std::fflush(stdout);
    }
}

}  // namespace

int main(int argc, char** argv) {
    try {
        run(argc, argv);
    } catch (const Error& error) {
        std::fprintf(stderr, "ocean_gpu_bench: %s\n", error.what());
        return 1;
    }
}
