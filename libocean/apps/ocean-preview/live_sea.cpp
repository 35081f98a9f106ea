// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "live_sea.hpp"

#include <utility>

#include "ocean/error.hpp"
#include "ocean/parameter_table.hpp"
#include "ocean/text.hpp"

namespace ocean::app {
namespace {

constexpr double kFadeSeconds = 1.0;

double end_of_take(const Sea& sea) {
    return sea.take.empty() ? sea.parameters.time.start : sea.take.events.back().seconds;
}

}  // namespace

LiveSea::LiveSea(Sea sea, int threads, const preview::SeaMapsOptions& maps,
                 std::size_t most_cascades)
    : clock(sea.parameters.time.start),
      options_{.threads = threads, .foam_start = FoamStart::empty},
      ocean_(std::move(sea), options_),
      maps_(std::make_unique<preview::SeaMaps>(maps)),
      most_cascades_(most_cascades),
      maps_before_(std::make_unique<preview::SeaMaps>(maps)),
      performed_until_(end_of_take(ocean_.sea())) {}

preview::ShownSea LiveSea::show() {
    preview::ShownSea shown = maps_->show(ocean_, clock.time());
    if (!before_) return shown;
    const preview::ShownSea from = maps_before_->show(*before_, time_before_);
    if (from.cascades.size() + shown.cascades.size() > most_cascades_) return shown;
    return preview::cross_fade(from, shown, faded_);
}

void LiveSea::advance(double wall_seconds) {
    const double time = clock.time();
    clock.advance(wall_seconds);
    if (!before_) return;
    time_before_ += clock.time() - time;
    faded_ += wall_seconds / kFadeSeconds;
    if (faded_ >= 1.0) before_.reset();
}

void LiveSea::change(Sea sea) {
    auto before = std::make_unique<Ocean>(ocean_, options_);
    ocean_.change(std::move(sea));
    before_ = std::move(before);
    std::swap(maps_, maps_before_);
    time_before_ = clock.time();
    faded_ = 0.0;
    maps_->foam_changed();
    now_known_ = false;
}

void LiveSea::set(const std::string& name, const std::string& value) {
    const ParameterRef ref = find_parameter(name);
    const Sea& before = ocean_.sea();
    const bool loops = before.parameters.time.loop_period != 0.0;
    if (ref.info->change == ParameterClass::live && !loops) {
        if (clock.time() < performed_until_) {
            throw Error(ErrorKind::invalid_value,
                        format_text("%s: the sea was performed until %.2f s; go to that end first",
                                    name.c_str(), performed_until_));
        }
        ocean_.perform(clock.time(), name, value);
        maps_->foam_changed(clock.time());
        performed_until_ = clock.time();
    } else {
        Sea changed = before;
        set_parameter(changed.parameters, name, value);
        validate(changed);
        change(std::move(changed));
    }
    now_known_ = false;
}

void LiveSea::open(Sea sea) {
    validate(sea);
    const double start = sea.parameters.time.start;
    performed_until_ = end_of_take(sea);
    change(std::move(sea));
    clock.go_to(start);
}

const Parameters& LiveSea::now() {
    if (!now_known_ || now_time_ != clock.time()) {
        now_ = ocean_.sea().at(clock.time());
        now_time_ = clock.time();
        now_known_ = true;
    }
    return now_;
}

}  // namespace ocean::app
