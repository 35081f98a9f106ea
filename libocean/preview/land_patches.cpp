// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "land_patches.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <thread>
#include <utility>

#include "wave/wave.hpp"

namespace ocean::preview {
namespace {

using wave::double_precision::earth_drop, wave::double_precision::horizon_distance;

constexpr double kFarthest = 150e3;  // [m]
/// Slopes are made for texels below so many texels of the land's map.
constexpr double kDetailOfTexel = 0.75;
/// Cell of the ground under the eye that distances are measured from [m]: calm as the eye moves.
constexpr double kCalmCell = 32.0;
/// Pictures that a flight is looked ahead, and the farthest way that is a flight and no jump [m].
constexpr double kPicturesAhead = 30.0;
constexpr double kMaxWay = 500.0;
/// The coarsest level that a picture may lack. Of the levels above it all squares in sight take a
/// few frames; on meshes that were coarser yet an eye near the ground would be below it.
constexpr int kMaxLackingLevel = 7;
constexpr std::size_t kMaxAhead = 600;  // patches made in advance at once

/// Returns the threads that make patches: beside live pictures one core is left to draw them.
int makers_of(const RendererOptions& options) {
    if (options.land_threads > 0) return options.land_threads;
    const int cores = static_cast<int>(std::thread::hardware_concurrency());
    return std::max(1, options.live ? cores - 1 : cores);
}

double calm_ground(const DrawnLand& land, double x, double y) {
    ThreadPool caller(1);
    const WorldPoint point{x, y};
    QuerySample sample{};
    land.function->query({&point, 1}, {&sample, 1}, kCalmCell, caller);
    return sample.height;
}

/// Returns true if the function has slopes that the map of a land lacks.
bool has_finer_waves(const DrawnLand& land) {
    constexpr int kPlaces = 256;
    constexpr double kSlope = 2e-3;  // rms
    std::vector<WorldPoint> points(kPlaces);
    for (std::size_t n = 0; n < points.size(); ++n) {
        // Spread evenly over the map by the fractions of multiples of irrational numbers.
        const double u = 0.7548776662 * static_cast<double>(n);
        const double v = 0.5698402910 * static_cast<double>(n);
        points[n] = {land.image->origin[0] + land.image->period * (u - std::floor(u)),
                     land.image->origin[1] + land.image->period * (v - std::floor(v))};
    }
    ThreadPool caller(1);
    std::vector<QuerySample> fine(points.size()), coarse(points.size());
    land.function->query(points, fine, QuadtreeSettings{}.spacing, caller);
    land.function->query(points, coarse, texel_of(land), caller);
    double sum = 0.0;
    for (std::size_t n = 0; n < points.size(); ++n) {
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const double step = fine[n].normal[axis] / fine[n].normal[2] -
                                coarse[n].normal[axis] / coarse[n].normal[2];
            sum += step * step;
        }
    }
    return sum > kPlaces * kSlope * kSlope;
}

/// Returns the planes of a frustum in the world, of an eye at (x, y).
std::array<std::array<double, 4>, 4> planes_of(const Frustum& frustum, double x, double y) {
    std::array<std::array<double, 4>, 4> planes{};
    for (std::size_t p = 0; p < planes.size(); ++p) {
        const glm::dvec4& plane = frustum.planes[p];
        planes[p] = {plane.x, plane.y, plane.z, plane.w - plane.x * x - plane.y * y};
    }
    return planes;
}

}  // namespace

LandPatches::LandPatches(const RendererOptions& options)
    : live_(options.live),
      shows_detail_(options.land_detail),
      patience_(options.land_patience),
      maker_(makers_of(options), make_patch_heights),
      detail_maker_(makers_of(options), make_patch_slopes),
      rows_((QuadtreeSettings{}.patch + 1) * (QuadtreeSettings{}.patch + 1)),
      layers_(detail_side({})) {
    make_grid();
}

/// Makes the grid of a quarter, whose quads are cut from (0, 0) to (1, 1).
void LandPatches::make_grid() {
    const int quads = settings_.patch / 2;
    std::vector<std::int32_t> grid;
    for (int j = 0; j <= quads; ++j) {
        for (int i = 0; i <= quads; ++i) grid.insert(grid.end(), {i, j});
    }
    std::vector<std::uint16_t> indices;
    const auto vertex = [&](int i, int j) {
        return static_cast<std::uint16_t>(j * (quads + 1) + i);
    };
    for (int j = 0; j < quads; ++j) {
        for (int i = 0; i < quads; ++i) {
            indices.insert(indices.end(), {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1),
                                           vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
        }
    }
    index_count_ = static_cast<int>(indices.size());
    array_ = gl::make_vertex_array();
    vertices_ = gl::make_buffer();
    indices_ = gl::make_buffer();
    instances_ = gl::make_buffer();
    glBindVertexArray(array_.name());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.name());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(grid.size() * sizeof(grid[0])),
                 grid.data(), GL_STATIC_DRAW);
    glEnableVertexAttribArray(0);
    glVertexAttribIPointer(0, 2, GL_INT, 0, nullptr);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
    glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(indices.size() * sizeof(indices[0])), indices.data(),
                 GL_STATIC_DRAW);
    glBindBuffer(GL_ARRAY_BUFFER, instances_.name());
    const auto per_instance = [](GLuint attribute, GLint components, std::size_t offset) {
        glEnableVertexAttribArray(attribute);
        glVertexAttribIPointer(attribute, components, GL_INT, sizeof(Instance),
                               reinterpret_cast<const void*>(offset));
        glVertexAttribDivisor(attribute, 1);
    };
    per_instance(1, 4, offsetof(Instance, place));
    per_instance(2, 2, offsetof(Instance, corner));
    per_instance(3, 1, offsetof(Instance, layer));
    glBindVertexArray(0);
}

void LandPatches::show(const DrawnLand& land) {
    land_ = &land;
    if (land.function == function_) return;
    function_ = land.function;
    eye_before_.reset();
    const LandImage& image = *land.image;
    ranges_.emplace(image, 1.0 + 2.0 * land.rms_slope * texel_of(land));
    settings_ = {};
    const Domain& domain = function_->domain();
    if (!domain.wraps) {
        settings_.edge = LandEdge{
            domain.origin, {domain.origin[0] + domain.size[0], domain.origin[1] + domain.size[1]}};
    }
    maker_.begin({function_, land.mean, settings_});
    detail_maker_.begin({function_, land.mean, settings_});
    layers_.slots.clear();
    const bool detailed = shows_detail_ && has_finer_waves(land);
    detail_cell_ = detailed ? kDetailOfTexel * texel_of(land) : 0.0;
    rows_.slots.clear();
}

double LandPatches::farthest(double eye_height) const {
    const auto [low, high] = land_->heights;
    const double seen = 1.05 * (horizon_distance(eye_height - low) + horizon_distance(high - low)) +
                        std::min(land_->image->period, 1e4);
    return std::min(seen, kFarthest);
}

QuadtreeSettings LandPatches::settings_for(double eye_height) const {
    QuadtreeSettings settings = settings_;
    settings.farthest = farthest(eye_height);
    return settings;
}

std::pair<float, float> LandPatches::bounds(const LandView& view, double x, double y,
                                            double side) const {
    const auto [low, high] = ranges_->in(x, y, side);
    const double left = x - view.eye[0], down = y - view.eye[1];
    const auto far = [&](double from) { return std::max(std::abs(from), std::abs(from + side)); };
    const auto near = [&](double from) { return std::max({from, -from - side, 0.0}); };
    return {low - static_cast<float>(earth_drop(std::hypot(far(left), far(down)))),
            high - static_cast<float>(earth_drop(std::hypot(near(left), near(down))))};
}

/// Returns true if a square may be inside the frustum.
bool LandPatches::sees(const LandView& view, double x, double y, double side) const {
    const auto [low, high] = bounds(view, x, y, side);
    return std::ranges::all_of(view.planes, [&](const std::array<double, 4>& plane) {
        const auto& [a, b, c, d] = plane;
        return a * (a > 0.0 ? x + side : x) + b * (b > 0.0 ? y + side : y) +
                   c * static_cast<double>(c > 0.0 ? high : low) + d >=
               0.0;
    });
}

void LandPatches::select_seen(const LandView& view) {
    const HeightBounds of_square = [&](double x, double y, double side) {
        return bounds(view, x, y, side);
    };
    select(settings_for(view.eye[2]), view, of_square, patches_);
}

std::vector<PatchKey> LandPatches::missing() {
    std::vector<PatchKey> lacking;
    for (const LandPatch& patch : patches_) {
        const PatchKey key = node_of(patch);
        if (!rows_.slots.hold(key)) lacking.push_back(key);
    }
    // Coarse squares first: with them alone the mesh is closed.
    std::ranges::stable_sort(lacking, std::ranges::greater{}, &PatchKey::level);
    return lacking;
}

void LandPatches::upload_made() {
    for (const PatchMaker::Made& made : maker_.take()) rows_.add(made);
    for (const PatchMaker::Made& made : detail_maker_.take()) layers_.add(made);
}

/// Requests patches and makes them with the other threads, for a live picture only for a while
/// unless they are needed `at_once`.
void LandPatches::fetch(std::vector<PatchKey> lacking, bool at_once) {
    using std::chrono::steady_clock;
    std::optional<steady_clock::time_point> until;
    if (live_ && !at_once) {
        until = steady_clock::now() + std::chrono::duration_cast<steady_clock::duration>(patience_);
    }
    maker_.request(lacking);
    const auto is_in_time = [&] { return !until || steady_clock::now() < *until; };
    do {
        while (is_in_time() && maker_.help()) continue;
        const bool in_time = maker_.wait(until);
        upload_made();
        if (!in_time) return;
    } while (std::ranges::any_of(lacking,
                                 [&](const PatchKey& key) { return !rows_.slots.contains(key); }) &&
             maker_.unfinished() + (maker_.has_made() ? 1 : 0) > 0);
}

DrawnLattice LandPatches::choose(const PictureFrame& frame) {
    const Camera& camera = frame.camera;
    const Frustum frustum(frame.projection.clip_from_world, camera.eye[2]);
    const auto planes = planes_of(frustum, camera.eye[0], camera.eye[1]);
    LandView view{camera.eye, calm_ground(*land_, camera.eye[0], camera.eye[1]), planes};
    const double height = std::abs(camera.eye[2] - view.ground);
    rows_.slots.begin_picture();
    layers_.slots.begin_picture();
    upload_made();
    select_seen(view);
    std::vector<PatchKey> lacking = missing();
    if (!lacking.empty()) {
        fetch(lacking, false);
        lacking = missing();
    }
    const std::vector<PatchKey> wanted = lacking;
    lacks_ = !lacking.empty();
    for (int level = 0; !lacking.empty(); ++level) {
        const bool is_last = level == std::min(kMaxLackingLevel, settings_.levels - 1);
        view.ground = camera.eye[2] - std::max(height, 1.001 * settings_.range_of(level));
        select_seen(view);
        lacking = missing();
        if (!is_last || lacking.empty()) continue;
        fetch(lacking, true);
        lacking.clear();
    }
    DrawnLattice lattice{settings_for(camera.eye[2]), {}, camera.eye[2] - view.ground};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        lattice.snapped[axis] =
            static_cast<std::int64_t>(std::floor(camera.eye[axis] / settings_.spacing));
    }
    fetch_detail();
    place_instances(lattice, view);
    if (lacks_) {
        maker_.request(wanted);
    } else if (live_) {
        prefetch(view);
    }
    eye_before_ = camera.eye;
    return lattice;
}

bool LandPatches::has_detail(const PatchKey& key) const {
    return settings_.spacing_of(key.level) / kTexelsOfQuad < detail_cell_;
}

/// Requests the slopes of the selected squares, and waits for them unless the pictures are live.
void LandPatches::fetch_detail() {
    std::vector<PatchKey> lacking;
    const auto list = [&] {
        lacking.clear();
        for (const LandPatch& patch : patches_) {
            const PatchKey key = node_of(patch);
            if (has_detail(key) && !layers_.slots.hold(key)) lacking.push_back(key);
        }
    };
    list();
    if (!live_ && !lacking.empty()) {
        detail_maker_.request(lacking);
        while (detail_maker_.unfinished() > 0 || detail_maker_.has_made()) {
            detail_maker_.wait({});
            upload_made();
        }
        list();
    }
    // Beyond the capacity of a driver they stay without.
    lacks_detail_ = live_ && !lacking.empty();
    if (live_) detail_maker_.request(lacking);
}

/// Requests the squares all round a place ahead, so that neither a flight nor a turn waits.
void LandPatches::prefetch(const LandView& view) {
    LandView later{view.eye, view.ground, {}};
    if (eye_before_) {
        std::array<double, 3> way{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            way[axis] = kPicturesAhead * (view.eye[axis] - (*eye_before_)[axis]);
        }
        if (std::hypot(way[0], way[1]) < kMaxWay * kPicturesAhead) {
            for (std::size_t axis = 0; axis < 2; ++axis) later.eye[axis] += way[axis];
        }
    }
    select(settings_for(view.eye[2]), later, {}, ahead_);
    std::vector<PatchKey> keys;
    for (const LandPatch& patch : ahead_) {
        const PatchKey key = node_of(patch);
        if (!rows_.slots.contains(key)) keys.push_back(key);
        if (keys.size() >= kMaxAhead) break;
    }
    maker_.request(keys);
}

void LandPatches::place_instances(const DrawnLattice& lattice, const LandView& view) {
    placed_.clear();
    const int half = settings_.patch / 2;
    for (const LandPatch& patch : patches_) {
        const PatchKey key = node_of(patch);
        const std::int64_t side = std::int64_t{settings_.patch} << key.level;
        Instance instance{};
        instance.place = {static_cast<std::int32_t>(key.i * side - lattice.snapped[0]),
                          static_cast<std::int32_t>(key.j * side - lattice.snapped[1]), key.level,
                          rows_.slots.find(key).value_or(0)};
        instance.layer = has_detail(key) ? layers_.slots.find(key).value_or(-1) : -1;
        for (int quarter = 0; quarter < 4; ++quarter) {
            const int i = quarter % 2, j = quarter / 2;
            if (patch.quarter && (i != (patch.i & 1) || j != (patch.j & 1))) continue;
            const double half_side = settings_.spacing_of(key.level) * half;
            if (!patch.quarter &&
                !sees(view, static_cast<double>(2 * key.i + i) * half_side,
                      static_cast<double>(2 * key.j + j) * half_side, half_side)) {
                continue;
            }
            instance.corner = {i * half, j * half};
            placed_.push_back(instance);
        }
    }
    glBindBuffer(GL_ARRAY_BUFFER, instances_.name());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(placed_.size() * sizeof(Instance)),
                 placed_.data(), GL_STREAM_DRAW);
    statistics_ = {.patches = patches_.size(),
                   .triangles = placed_.size() * static_cast<std::size_t>(index_count_ / 3),
                   .resident_bytes = rows_.bytes() + layers_.bytes(),
                   .waiting = maker_.unfinished() + detail_maker_.unfinished()};
}

void LandPatches::draw() const {
    glBindVertexArray(array_.name());
    glDrawElementsInstanced(GL_TRIANGLES, index_count_, GL_UNSIGNED_SHORT, nullptr,
                            static_cast<GLsizei>(placed_.size()));
}

Pending LandPatches::pending() const {
    if (!lacks_ && !lacks_detail_) return Pending::nothing;
    const bool has_made = (lacks_ && maker_.has_made()) || detail_maker_.has_made();
    return has_made ? Pending::ready : Pending::in_work;
}

}  // namespace ocean::preview
