// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Caustics by the areas of refracted cells [Watt 1990].
//
// The samples of a map cut the surface into triangles, two a cell. The parallel light of the sun
// through a triangle is proportional to its area seen from the sun, which is the area of its shadow
// along the rays on the mean level: a signed area, whose sum over a period is the period's area for
// any waves. At the three corners the rays are refracted,
//   t = r s + (r c - sqrt(1 - r^2 (1 - c^2))) n,   c = -s.n,  r = 1 / kWaterIor
// with s the direction of the light and n the normal, and meet the plane at three points. The
// triangle's light is spread evenly over the triangle of these points: each cell of the plane takes
// the share that lies in it. Fresnel's losses are left out, because they differ by 0.02 up to 50
// degrees of incidence; so is absorption, because it equals flat water's.
//
// Limits: flat water has 1 everywhere. Below a crest of a wave a cos(k x), light from the zenith is
// 1 / (1 - d / f) at the depth d below it, with the focus f = n / (n - 1) / (a k^2), and
// 1 / (1 + d / f) below a trough [tests/unit/caustics_test.cpp].
//
// Sums are of integers, so that they do not depend on the order. Positions are counted from the
// cell that the light comes from, so that neither bits nor seams depend on that cell's position.
#include "ocean/internal/caustics.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <memory>
#include <string>

#include "ocean/error.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/internal/water_types.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {
namespace {

/// Light of one cell of flat water. The largest map has 2^26 cells; all their light in one cell is
/// 2^62.
constexpr double kCellLight = 0x1p36;
/// Rows of the map in one item of work, for any number of threads.
constexpr int kRowsAtOnce = 8;
/// Min descent of refracted rays: only folds of the surface would send flatter rays.
constexpr double kMinDescent = 0.2;
/// A triangle of a smaller area, in cells, counts as a line.
constexpr double kThin = 1e-10;

struct Point {
    double x, y;  // in cells
};
Point middle(Point a, Point b) {
    return {0.5 * (a.x + b.x), 0.5 * (a.y + b.y)};
}
using Triangle = std::array<Point, 3>;

double signed_area(const Triangle& t) {
    return 0.5 * ((t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[1].y - t[0].y) * (t[2].x - t[0].x));
}

/// A triangle clipped by lines: each of four cuts adds one corner at most.
struct Polygon {
    std::array<Point, 8> corner{};
    int count = 0;

    void add(Point p) { corner[static_cast<std::size_t>(count++)] = p; }
    Point operator[](int i) const { return corner[static_cast<std::size_t>(i)]; }
};

double area(const Polygon& p) {
    double twice = 0.0;
    for (int i = 2; i < p.count; ++i) {
        twice +=
            (p[i - 1].x - p[0].x) * (p[i].y - p[0].y) - (p[i - 1].y - p[0].y) * (p[i].x - p[0].x);
    }
    return 0.5 * std::abs(twice);
}

/// Cuts along x = at, or y = at: returns the part below, and leaves the other in `rest`.
Polygon cut_off(Polygon& rest, double Point::*axis, double at) {
    Polygon below, above;
    for (int i = 0; i < rest.count; ++i) {
        const Point a = rest[i], b = rest[i + 1 < rest.count ? i + 1 : 0];
        const double from = a.*axis - at, to = b.*axis - at;
        if (from <= 0.0) below.add(a);
        if (from >= 0.0) above.add(a);
        if ((from < 0.0 && to > 0.0) || (from > 0.0 && to < 0.0)) {
            const double f = from / (from - to);
            Point p = {a.x + f * (b.x - a.x), a.y + f * (b.y - a.y)};
            p.*axis = at;
            below.add(p);
            above.add(p);
        }
    }
    rest = above;
    return below;
}

struct Span {
    std::int64_t first, last;  // cells
};
Span cells_of(const Polygon& p, double Point::*axis) {
    double low = p[0].*axis, high = low;
    for (int i = 1; i < p.count; ++i) {
        low = std::min(low, p[i].*axis);
        high = std::max(high, p[i].*axis);
    }
    // A part that ends on a line does not reach into the next cell.
    const auto first = static_cast<std::int64_t>(std::floor(low));
    return {first, std::max(first, static_cast<std::int64_t>(std::ceil(high)) - 1)};
}

/// The lit plane. Cell (i, j) reaches from i to i + 1 and repeats with the map.
class Plane {
  public:
    explicit Plane(int resolution)
        : side_(resolution),
          light_(std::make_unique<std::atomic<std::int64_t>[]>(
              static_cast<std::size_t>(resolution) * static_cast<std::size_t>(resolution))) {}

    /// Spreads light evenly over a triangle, whose corners are relative to cell (i, j).
    void spread(const Triangle& triangle, std::int64_t light, int i, int j) {
        const double size = std::abs(signed_area(triangle));
        if (!(size > kThin)) return spread_line(triangle, light, i, j);
        Polygon rest;
        for (const Point p : triangle) rest.add(p);
        const Span rows = cells_of(rest, &Point::y);
        double lit = 0.0;
        std::int64_t given = 0;
        for (std::int64_t row = rows.first; row <= rows.last; ++row) {
            const bool last_row = row == rows.last;
            Polygon strip = rest;
            if (!last_row) strip = cut_off(rest, &Point::y, static_cast<double>(row + 1));
            if (strip.count == 0) continue;
            const Span columns = cells_of(strip, &Point::x);
            for (std::int64_t column = columns.first; column <= columns.last; ++column) {
                const bool last_column = column == columns.last;
                const Polygon part =
                    last_column ? strip
                                : cut_off(strip, &Point::x, static_cast<double>(column + 1));
                lit += area(part);
                // The last cell receives the remainder of the rounding: no light is lost.
                const std::int64_t until =
                    last_row && last_column
                        ? light
                        : std::llround(static_cast<double>(light) * std::min(1.0, lit / size));
                add(i + column, j + row, until - given);
                given = until;
            }
        }
    }

    /// Returns the light of each cell relative to an even distribution.
    std::vector<float> irradiance() const {
        const std::size_t count = static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_);
        std::int64_t all = 0;
        for (std::size_t cell = 0; cell < count; ++cell) all += light_[cell];
        const double to_mean = static_cast<double>(count) / static_cast<double>(all);
        std::vector<float> map(count);
        for (std::size_t cell = 0; cell < count; ++cell) {
            map[cell] = static_cast<float>(static_cast<double>(light_[cell]) * to_mean);
        }
        return map;
    }

  private:
    /// Spreads light over a triangle without area, by halving it until it is short.
    void spread_line(const Triangle& t, std::int64_t light, int i, int j) {
        const auto length = [&t](int a, int b) {
            const Point p = t[static_cast<std::size_t>(a)], q = t[static_cast<std::size_t>(b)];
            return std::max(std::abs(p.x - q.x), std::abs(p.y - q.y));
        };
        int a = 0, b = 1, c = 2;
        if (length(1, 2) > length(a, b)) a = 1, b = 2, c = 0;
        if (length(2, 0) > length(a, b)) a = 2, b = 0, c = 1;
        const Point from = t[static_cast<std::size_t>(a)], to = t[static_cast<std::size_t>(b)];
        const Point half = middle(from, to), tip = t[static_cast<std::size_t>(c)];
        if (!(length(a, b) > 0.5)) {
            add(i + static_cast<std::int64_t>(std::floor(half.x)),
                j + static_cast<std::int64_t>(std::floor(half.y)), light);
            return;
        }
        spread_line({from, half, tip}, light / 2, i, j);
        spread_line({half, to, tip}, light - light / 2, i, j);
    }

    void add(std::int64_t i, std::int64_t j, std::int64_t light) {
        const std::int64_t mask = side_ - 1;
        const auto cell = static_cast<std::size_t>((j & mask) * side_ + (i & mask));
        light_[cell].fetch_add(light, std::memory_order_relaxed);
    }

    std::int64_t side_;  // a power of two
    std::unique_ptr<std::atomic<std::int64_t>[]> light_;
};

/// One ray: the points where it crosses the mean level and where it meets the plane, in cells from
/// the centre of its sample's own cell.
struct Ray {
    Point level, plane;
};

class Rays {
  public:
    Rays(const Surface& surface, const CausticsSettings& settings)
        : side_(surface.resolution()),
          per_metre_(surface.resolution() / surface.period()),
          depth_(settings.depth),
          dx_(surface.channel(Channel::dx)),
          dy_(surface.channel(Channel::dy)),
          height_(surface.channel(Channel::height)),
          nx_(surface.channel(Channel::nx)),
          ny_(surface.channel(Channel::ny)),
          nz_(surface.channel(Channel::nz)) {
        const double altitude = settings.sun_altitude * kDegree;
        const double bearing = settings.sun_bearing * kDegree;
        // Exactly 0 at the zenith, where the cosine of a rounded right angle would not be.
        const double level = settings.sun_altitude == 90.0 ? 0.0 : std::cos(altitude);
        light_ = {-level * std::cos(bearing), -level * std::sin(bearing), -std::sin(altitude)};
    }

    /// Returns the ray of sample (i, j), both modulo the resolution.
    Ray of(int i, int j) const {
        const int mask = side_ - 1;
        const auto at = static_cast<std::size_t>((j & mask)) * static_cast<std::size_t>(side_) +
                        static_cast<std::size_t>(i & mask);
        const double x = dx_[at], y = dy_[at], z = height_[at];
        const std::array<double, 3> n = {nx_[at], ny_[at], nz_[at]};
        constexpr double r = 1.0 / kWaterIor;
        const double c = std::max(0.0, -(light_[0] * n[0] + light_[1] * n[1] + light_[2] * n[2]));
        const double along = r * c - std::sqrt(1.0 - r * r * (1.0 - std::min(1.0, c * c)));
        const double descent = std::max(kMinDescent, -(r * light_[2] + along * n[2]));
        const double fall = std::max(0.0, depth_ + z) / descent;
        const double rise = z / light_[2];
        return {{(x - light_[0] * rise) * per_metre_, (y - light_[1] * rise) * per_metre_},
                {(x + (r * light_[0] + along * n[0]) * fall) * per_metre_,
                 (y + (r * light_[1] + along * n[1]) * fall) * per_metre_}};
    }

  private:
    static constexpr double kDegree = kTwoPi / 360.0;

    int side_;
    double per_metre_, depth_;
    std::span<const float> dx_, dy_, height_, nx_, ny_, nz_;
    std::array<double, 3> light_{};
};

Ray shifted(const Ray& ray, double x, double y) {
    return {{ray.level.x + x, ray.level.y + y}, {ray.plane.x + x, ray.plane.y + y}};
}

/// Adds the light through one triangle of the surface. Parts seen from below lie behind other
/// parts, which already have their light.
void send(Plane& plane, const Ray& a, const Ray& b, const Ray& c, int i, int j) {
    const double seen = signed_area({a.level, b.level, c.level});
    if (!(seen > 0.0)) return;
    // Cells begin half a cell before the samples at their centres.
    const auto lit = [](const Ray& ray) { return Point{ray.plane.x + 0.5, ray.plane.y + 0.5}; };
    plane.spread({lit(a), lit(b), lit(c)}, std::llround(seen * kCellLight), i, j);
}

void require(double value, const char* what, double least, double most) {
    if (value >= least && value <= most) return;
    const std::string given = shortest_text(value);
    const std::string allowed = shortest_text(least) + " .. " + shortest_text(most);
    throw Error(ErrorKind::invalid_value,
                std::string(what) + " = " + given + "; allowed: " + allowed,
                {.parameter = what, .value = given, .allowed = allowed});
}

}  // namespace

std::uint64_t caustics_bytes(int resolution) {
    const auto side = static_cast<std::uint64_t>(resolution);
    return side * side * (sizeof(std::int64_t) + sizeof(float));
}

std::vector<float> make_caustics(const Surface& surface, const CausticsSettings& settings,
                                 ThreadPool& pool) {
    require(settings.depth, "the depth of caustics", kMinCausticsDepth, kMaxCausticsDepth);
    require(settings.sun_altitude, "the sun's altitude", kMinCausticsSunAltitude, 90.0);
    require(settings.sun_bearing, "the sun's bearing", -3600.0, 3600.0);
    if (!surface.channels().contains(kCausticsChannels)) {
        throw Error(ErrorKind::invalid_value, "caustics need a surface with positions and normals");
    }
    const int side = surface.resolution();
    const Rays rays(surface, settings);
    Plane plane(side);
    pool.for_each_item(side / kRowsAtOnce, [&](int item, int) {
        std::vector<Ray> row(static_cast<std::size_t>(side) + 1), next(row.size());
        const auto read = [&](std::vector<Ray>& to, int j) {
            for (int i = 0; i < side; ++i) to[static_cast<std::size_t>(i)] = rays.of(i, j);
            to.back() = to.front();
        };
        read(next, item * kRowsAtOnce);
        for (int j = item * kRowsAtOnce; j < (item + 1) * kRowsAtOnce; ++j) {
            std::swap(row, next);
            read(next, j + 1);
            for (int i = 0; i < side; ++i) {
                const auto at = static_cast<std::size_t>(i);
                const Ray &a = row[at], b = shifted(row[at + 1], 1.0, 0.0),
                          c = shifted(next[at + 1], 1.0, 1.0), d = shifted(next[at], 0.0, 1.0);
                send(plane, a, b, c, i, j);
                send(plane, a, c, d, i, j);
            }
        }
    });
    return plane.irradiance();
}

}  // namespace ocean
