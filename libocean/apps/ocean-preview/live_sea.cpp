// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "live_sea.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "command.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/hull_rules.hpp"
#include "ocean/internal/modes.hpp"
#include "ocean/internal/open_sea.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/parameter_table.hpp"
#include "subject_argument.hpp"

namespace ocean::app {
namespace {

constexpr double kFadeSeconds = 1.0;
/// Seas that have so much in common take each other's place at any moment without a jump.
constexpr double kSameWaves = 0.9;
/// Glides that no take has, before they are forgotten: each costs a little at every time.
constexpr std::size_t kMaxGlides = 2000;

double end_of(const Sea& sea) {
    return sea.take.empty() ? sea.parameters.time.start : sea.take.events.back().seconds;
}

}  // namespace

LiveSea::LiveSea(Sea sea, LiveSeaOptions options)
    : options_(std::move(options)),
      computing_(options_.computing(sea)),
      kept_(std::move(sea)),
      time_(kept_.parameters.time.start),
      performed_until_(end_of(kept_)),
      ocean_(std::make_unique<Ocean>(kept_, ocean_options(computing_))),
      maps_(make_maps(computing_)),
      has_coast_(options_.waits_for_coast && kept_.parameters.water.bed) {
    if (kept_.parameters.water.bed && !has_coast_) begin_coast(kept_, std::nullopt);
}

OceanOptions LiveSea::ocean_options(const Computing& computing) const {
    return {.threads = options_.threads,
            .backend = computing.backend,
            .foam_start = options_.foam_start,
            .foam_progress = options_.foam_progress};
}

std::unique_ptr<preview::SeaMaps> LiveSea::make_maps(const Computing& computing) const {
    return std::make_unique<preview::SeaMaps>(computing.maps, options_.after_stage);
}

preview::DrawnSea LiveSea::show(const std::array<double, 3>& eye) {
    const auto eye_of = [&](bool has_coast, const Ocean& sea) {
        return has_coast || !sea.parameters().water.bed ? std::optional(eye) : std::nullopt;
    };
    maps_->set_detail(near_detail);
    preview::DrawnSea shown = maps_->show(*ocean_, time_, eye_of(has_coast_, *ocean_));
    if (!before_) return shown;
    maps_before_->set_detail(near_detail);
    const preview::DrawnSea from =
        maps_before_->show(*before_, time_before_, eye_of(had_coast_, *before_));
    shown = maps_->fade_from(from, faded_);
    return preview::cross_fade(from, shown, faded_, correlation_);
}

void LiveSea::advance(double wall_seconds) {
    if (work_ && work_->done() && !fading()) end_coast();
    if (!paused) {
        time_ += speed * wall_seconds;
        time_before_ += speed * wall_seconds;
        follow_drive();
    }
    const double start = kept_.parameters.time.start;
    if (play_again_after && !recording_ && !drive_ && time_ >= start + *play_again_after) {
        const double over = time_ - (start + *play_again_after);
        go_to(start + std::min(over, *play_again_after));
    }
    if (!before_) return;
    faded_ += wall_seconds / kFadeSeconds;
    if (faded_ < 1.0) return;
    before_.reset();
    if (std::exchange(waiting_, false)) fade_to(kept_, time_);
}

void LiveSea::go_to(double time) {
    if (time != time_) stop_drive();
    if (time < time_) {
        stop_recording();
        if (ocean_->sea().take.events.size() != kept_.take.events.size()) become(kept_);
    }
    time_before_ += time - time_;
    time_ = time;
}

void LiveSea::fade_to(const Sea& sea, double time) {
    if (sea.parameters.water.bed) {
        return begin_coast(sea, time == time_ ? std::nullopt : std::optional(time));
    }
    work_.reset();
    const Computing computing = options_.computing(sea);
    auto next = std::make_unique<Ocean>(*ocean_, ocean_options(computing));
    next->change(sea);
    const double correlation =
        height_correlation(ocean_->modes(time_), time_, next->modes(time), time);
    now_time_.reset();
    waiting_ = fading() && correlation < kSameWaves && time == time_ && !recording_;
    if (waiting_) return;
    fade_in(std::move(next), computing, correlation, time);
    has_coast_ = false;
}

void LiveSea::fade_in(std::unique_ptr<Ocean> next, const Computing& computing, double correlation,
                      double time) {
    if (!maps_before_ || computing != computing_) {
        maps_before_ = make_maps(computing);
    }
    std::swap(maps_, maps_before_);
    maps_->foam_changed();
    before_ = std::exchange(ocean_, std::move(next));
    had_coast_ = has_coast_;
    time_before_ = std::exchange(time_, time);
    computing_ = computing;
    correlation_ = correlation;
    faded_ = 0.0;
    performed_until_ = end_of(ocean_->sea());
}

void LiveSea::begin_coast(const Sea& sea, std::optional<double> time) {
    validate(sea);
    static_cast<void>(options_.computing(sea));  // throws if it cannot be computed
    waiting_ = false;
    now_time_.reset();
    work_.reset();  // stops the one before
    work_ = std::make_unique<CoastWork>(*ocean_, sea);
    work_time_ = time;
}

void LiveSea::end_coast() {
    const std::unique_ptr<CoastWork> work = std::exchange(work_, nullptr);
    now_time_.reset();
    try {
        const Ocean& made = work->result();
        const Computing computing = options_.computing(made.sea());
        auto next = std::make_unique<Ocean>(made, ocean_options(computing));
        const double time = work_time_.value_or(time_);
        if (ocean_->parameters().water.bed && !has_coast_) {
            // Nothing to fade from. The open sea goes on as it was shown.
            next->open_sea().take_foam(ocean_->open_sea());
            ocean_ = std::move(next);
            time_ = time;
        } else {
            const double correlation =
                height_correlation(ocean_->modes(time_), time_, next->modes(time), time);
            fade_in(std::move(next), computing, correlation, time);
        }
        has_coast_ = true;
    } catch (const Error&) {
        kept_ = ocean_->sea();
        throw;
    }
}

void LiveSea::become(const Sea& sea) {
    waiting_ = false;
    ocean_->change(sea);
    maps_->foam_changed();
    performed_until_ = end_of(sea);
    now_time_.reset();
}

void LiveSea::perform(const std::string& name, const std::string& value) {
    ocean_->perform(time_, name, value);
    maps_->foam_changed(time_);
    performed_until_ = time_;
    now_time_.reset();
}

void LiveSea::set(const std::string& name, const std::string& value) {
    const ParameterRef parameter = find_parameter(name);
    const bool live = parameter.info->change == ParameterClass::live;
    const auto done = [&] {
        if (after_set) after_set(name, value);
    };
    if (live && recording_) {
        perform(name, value);
        return done();
    }
    const std::vector<TakeEvent>& played = sea().take.events;
    if (live && std::ranges::any_of(played, [&](const TakeEvent& event) {
            return event.parameter.same_as(parameter);
        })) {
        refuse(name + ": is played by the take; record to play it anew");
    }
    Sea changed = sea();
    set_in_sea(changed, name, value);
    const bool glides = live && changed.parameters.time.loop_period == 0.0 &&
                        !changed.parameters.water.bed && changed.parameters.crests.empty() &&
                        time_ >= performed_until_;
    if (glides) {
        if (ocean_->sea().take.events.size() > kept_.take.events.size() + kMaxGlides) {
            become(kept_);
        }
        perform(name, value);
    } else {
        fade_to(changed, time_);
    }
    kept_ = std::move(changed);
    if (kept_.parameters.time.loop_period != 0.0) recording_ = false;
    check_drive();
    done();
}

void LiveSea::change(Sea sea) {
    validate(sea);
    fade_to(sea, time_);
    kept_ = std::move(sea);
    check_drive();
}

void LiveSea::open(Sea sea) {
    validate(sea);
    fade_to(sea, sea.parameters.time.start);
    recording_ = false;
    kept_ = std::move(sea);
    drive_.reset();
    if (after_open) after_open();
}

void LiveSea::start_drive(std::size_t hull) {
    const std::size_t hulls = kept_.parameters.hulls.size();
    if (hull >= hulls) {
        throw Error(ErrorKind::not_found,
                    "hulls." + std::to_string(hull) +
                        ": the sea has no such hull to drive; allowed: " +
                        (hulls == 0 ? "none" : "0 .. " + std::to_string(hulls - 1)));
    }
    stop_drive();
    begin_drive(sea(), hull);
}

void LiveSea::drive_new_hull(double x, double y, double heading) {
    stop_drive();
    Sea with = sea();
    auto track = std::make_shared<HullTrack>();
    track->rows = {{time_, x, y}};
    track->courses = {{heading, 0.0}};
    with.parameters.hulls.emplace_back().track = std::move(track);
    const std::size_t hull = with.parameters.hulls.size() - 1;
    begin_drive(std::move(with), hull);
}

void LiveSea::begin_drive(Sea sea, std::size_t hull) {
    if (sea.parameters.time.loop_period != 0.0) {
        refuse("time.loop_period = " + shortest_text(sea.parameters.time.loop_period) +
               " s: a loop repeats and a driven hull does not; allowed: 0 to drive");
    }
    Hull& driven = sea.parameters.hulls[hull];
    HullDrive motion(driven, time_);
    driven = hull_to_drive(std::move(driven), sea.parameters.water);
    driven.track = motion.planned();
    validate(sea);
    drive_ = {hull, std::move(motion), driven.track};
    if (waiting_) become(kept_);
    Sea shown = ocean_->sea();
    shown.parameters.hulls = sea.parameters.hulls;
    ocean_->change(std::move(shown));
    kept_.parameters.hulls = std::move(sea.parameters.hulls);
    now_time_.reset();
}

void LiveSea::set_track(std::shared_ptr<const HullTrack> track) {
    Sea shown = ocean_->sea();
    const auto set = [&](Parameters& in) {
        if (drive_->hull < in.hulls.size()) in.hulls[drive_->hull].track = track;
    };
    set(shown.parameters);
    validate_hulls(shown.parameters);
    ocean_->change(std::move(shown));
    set(kept_.parameters);
    drive_->shown = std::move(track);
    now_time_.reset();
}

void LiveSea::follow_drive() {
    if (!drive_ || !drive_->motion.advance(time_)) return;
    try {
        set_track(drive_->motion.planned());
    } catch (const Error&) {
        drive_.reset();
        throw;
    }
}

void LiveSea::stop_drive() {
    if (!drive_) return;
    set_track(drive_->motion.driven());
    drive_.reset();
}

void LiveSea::check_drive() {
    if (!drive_) return;
    const std::vector<Hull>& hulls = kept_.parameters.hulls;
    if (drive_->hull < hulls.size() && hulls[drive_->hull].track == drive_->shown) return;
    drive_.reset();
}

void LiveSea::settle() {
    if (work_) {
        work_->wait();
        end_coast();
    } else if (!recording_) {
        become(kept_);
    }
    before_.reset();
}

void LiveSea::compute_anew() {
    const Computing computing = options_.computing(sea());
    if (computing == computing_) return;
    auto maps = make_maps(computing);
    ocean_ = std::make_unique<Ocean>(*ocean_, ocean_options(computing));
    maps_ = std::move(maps);
    computing_ = computing;
    before_.reset();
    maps_before_.reset();
    waiting_ = false;
}

void LiveSea::start_recording() {
    if (recording_) return;
    if (kept_.parameters.time.loop_period != 0.0) {
        refuse("time.loop_period = " + shortest_text(kept_.parameters.time.loop_period) +
               " s: a loop repeats and a recording does not; allowed: 0 to record");
    }
    if (kept_.parameters.water.bed) {
        throw Error(ErrorKind::unsupported,
                    "this sea has a bed (water.seabed), whose coast is computed for one sea state: "
                    "nothing can be recorded over it");
    }
    require_takes(kept_.parameters);
    Sea recorded = kept_;
    std::erase_if(recorded.take.events,
                  [&](const TakeEvent& event) { return event.seconds > time_; });
    if (waiting_ || ocean_->sea().take.events.size() != recorded.take.events.size()) {
        become(recorded);
    }
    kept_ = std::move(recorded);
    recording_ = true;
}

void LiveSea::stop_recording() {
    if (!recording_) return;
    kept_ = ocean_->sea();
    recording_ = false;
}

double LiveSea::take_end() const {
    return end_of(sea());
}

double LiveSea::foam_settling() const {
    return static_cast<double>(maps_->foam_settling_ticks(*ocean_)) *
           ocean_->parameters().surface.foam_step;
}

preview::Pending LiveSea::pending() const {
    if (!work_) return maps_->pending();
    return work_->done() ? preview::Pending::ready : preview::Pending::in_work;
}

const Parameters& LiveSea::now() {
    if (!now_time_ || *now_time_ != time_) {
        now_ = (waiting_ || work_ ? kept_ : ocean_->sea()).at(time_);
        now_time_ = time_;
    }
    return now_;
}

}  // namespace ocean::app
