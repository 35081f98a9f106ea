// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "live_sea.hpp"

#include <utility>

#include "ocean/parameter_table.hpp"

namespace ocean::app {

LiveSea::LiveSea(Sea sea, int threads, const preview::SeaMapsOptions& maps)
    : clock(sea.parameters.time.start),
      ocean_(std::move(sea), {.threads = threads, .foam_start = FoamStart::empty}),
      maps_(maps) {}

void LiveSea::set(const std::string& name, const std::string& value) {
    const ParameterRef ref = find_parameter(name);
    const Sea& before = ocean_.sea();
    const bool again =
        !before.take.events.empty() && clock.time() < before.take.events.back().seconds;
    const bool performs = ref.info->change == ParameterClass::live &&
                          before.parameters.time.loop_period == 0.0 && !again;
    if (performs) {
        ocean_.perform(clock.time(), name, value);
        maps_.foam_changed(clock.time());
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
