// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Turns live changes into events of the sea's own take, so that the displayed sea can be
// reproduced.
#pragma once

#include <cstddef>
#include <string_view>

#include "ocean/sea.hpp"

namespace ocean {

class Performer {
  public:
    /// Takes a valid sea. Only the performer may change its take afterwards.
    explicit Performer(const Sea& sea);

    /// Performs a change, see Ocean::perform. Returns the time from which on the sea differs;
    /// infinity if nothing changes.
    double perform(Sea& sea, double time, std::string_view name, std::string_view value);

  private:
    double last_;        // time of the last change
    std::size_t bytes_;  // of the take as text
};

}  // namespace ocean
