// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "hulls/hull_marks.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "field/ease.hpp"

namespace ocean {
namespace {

constexpr double kTick = 0.5;         // between the nodes of the trail [s]
constexpr double kLives = 5.0;        // lifetimes after which the trail has ended
constexpr double kAtRest = 0.05;      // [m/s]
constexpr double kStern = 0.48;       // lengths from the middle of a hull to its stern
constexpr std::size_t kGroup = 16;    // pieces
constexpr double kGravity = 9.80665;  // of the Froude number alone
constexpr double kFull = 0.2;         // shares of the half width up to which the trail is whole,
constexpr double kEdge = 1.3;         // and where it ends
constexpr double kShareOfBeam = 0.1;  // over which the inside falls

/// Returns how much of the water a hull makes white: none at rest, all from Fr = 0.4 on.
double white_share(double speed, double length) {
    return ease(0.1, 0.4, speed / std::sqrt(kGravity * length));
}

}  // namespace

HullMarks::HullMarks(const Hull& hull, double loop_period)
    : path_(hull.track, loop_period),
      length_(hull.length),
      beam_(hull.beam),
      lifetime_(hull.trail_lifetime) {}

// The wake of a body that propels itself spreads as the fifth root of the distance [Milgram 1993].
double HullMarks::half_width(double astern) const {
    const double lengths = astern / length_;
    return 0.5 * beam_ * (0.7 + 0.9 * ease(0.0, 4.0, lengths)) * std::pow(1.0 + lengths / 4.0, 0.2);
}

void HullMarks::move_to(double time) {
    place_ = path_.place(time);
    heading_ = path_.heading(time);
    pieces_.clear();
    groups_.clear();
    if (lifetime_ <= 0.0) return;
    const auto stern = [&](double at) {
        const PathVector middle = path_.place(at);
        const PathVector ahead = path_.heading(at);
        return PathVector{middle.x - kStern * length_ * ahead.x,
                          middle.y - kStern * length_ * ahead.y};
    };
    // Nodes lie on an absolute clock, so that the trail stays where it is; the newest is now.
    const double oldest = std::max(path_.begin(), time - kLives * lifetime_);
    double newer = time;
    PathVector end = stern(time);
    double astern = 0.0;
    while (newer > oldest) {
        const double older = std::max(oldest, (std::ceil(newer / kTick - 1e-9) - 1.0) * kTick);
        const PathVector from = stern(older);
        const PathVector way{end.x - from.x, end.y - from.y};
        const double reach = std::hypot(way.x, way.y);
        const double seconds = newer - older;
        astern += reach;
        if (reach > kAtRest * seconds) {
            const double share = white_share(reach / seconds, length_);
            if (share > 0.0) {
                pieces_.push_back({from, way, reach, time - older, seconds, astern, share,
                                   kEdge * half_width(astern)});
            }
        }
        newer = older;
        end = from;
    }
    gather();
}

void HullMarks::Box::widen(PathVector place, double margin) {
    low = {std::min(low.x, place.x - margin), std::min(low.y, place.y - margin)};
    high = {std::max(high.x, place.x + margin), std::max(high.y, place.y + margin)};
}

void HullMarks::gather() {
    if (!pieces_.empty()) all_ = {pieces_.front().from, pieces_.front().from};
    for (std::size_t first = 0; first < pieces_.size(); first += kGroup) {
        Group group{{pieces_[first].from, pieces_[first].from},
                    first,
                    std::min(first + kGroup, pieces_.size())};
        for (std::size_t i = first; i < group.end; ++i) {
            const Piece& piece = pieces_[i];
            group.box.widen(piece.from, piece.margin);
            group.box.widen({piece.from.x + piece.way.x, piece.from.y + piece.way.y}, piece.margin);
        }
        all_.widen(group.box.low, 0.0);
        all_.widen(group.box.high, 0.0);
        groups_.push_back(group);
    }
}

float HullMarks::trail(WorldPoint label) const {
    double most = 0.0;
    if (groups_.empty() || !all_.holds(label)) return 0.0f;
    for (const Group& group : groups_) {
        if (!group.box.holds(label)) continue;
        for (std::size_t i = group.first; i < group.end; ++i) {
            const Piece& piece = pieces_[i];
            const double x = label.x - piece.from.x;
            const double y = label.y - piece.from.y;
            const double ahead = x * piece.way.x + y * piece.way.y;
            const double square = piece.reach * piece.reach, beyond = piece.margin * piece.reach;
            if (ahead < -beyond || ahead > square + beyond) continue;
            const double along = std::clamp(ahead / square, 0.0, 1.0);
            const double off = std::hypot(x - along * piece.way.x, y - along * piece.way.y);
            if (off >= piece.margin) continue;
            const double lives = (piece.age - along * piece.seconds) / lifetime_;
            const double across =
                ease(kEdge, kFull, off / half_width(piece.astern - along * piece.reach));
            const double end = ease(kLives, kLives - 1.0, lives);
            most = std::max(most, piece.share * std::exp(-lives) * end * across);
        }
    }
    return static_cast<float>(most);
}

float HullMarks::inside(WorldPoint place) const {
    const double x = place.x - place_.x;
    const double y = place.y - place_.y;
    const double along = (x * heading_.x + y * heading_.y) / (0.5 * length_);
    const double across = std::abs(y * heading_.x - x * heading_.y);
    if (heading_.x == 0.0 && heading_.y == 0.0) return 0.0f;
    const double half_breadth = 0.5 * beam_ * (1.0 - along * along);
    const double within = (half_breadth - across) / (kShareOfBeam * beam_);
    return static_cast<float>(std::clamp(0.5 + within, 0.0, 1.0));
}

}  // namespace ocean
