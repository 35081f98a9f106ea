// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "live_sea.hpp"

#include <utility>

#include "ocean/error.hpp"
#include "ocean/parameter_table.hpp"
#include "ocean/text.hpp"

namespace ocean::app {
namespace {

double end_of_take(const Sea& sea) {
    return sea.take.empty() ? sea.parameters.time.start : sea.take.events.back().seconds;
}

}  // namespace

LiveSea::LiveSea(Sea sea, int threads, const preview::SeaMapsOptions& maps)
    : clock(sea.parameters.time.start),
      ocean_(std::move(sea), {.threads = threads, .foam_start = FoamStart::empty}),
      maps_(maps),
      performed_until_(end_of_take(ocean_.sea())) {}

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
        maps_.foam_changed(clock.time());
        performed_until_ = clock.time();
    } else {
        Sea changed = before;
        set_parameter(changed.parameters, name, value);
        validate(changed);
        ocean_.change(std::move(changed));
        maps_.foam_changed();
    }
    now_known_ = false;
}

void LiveSea::open(Sea sea) {
    validate(sea);
    clock.go_to(sea.parameters.time.start);
    performed_until_ = end_of_take(sea);
    ocean_.change(std::move(sea));
    maps_.foam_changed();
    now_known_ = false;
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
