// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Live changes become events of the sea's own take, so that what was shown can be made again.
#pragma once

#include <cstddef>
#include <string_view>

#include "ocean/sea.hpp"

namespace ocean {

class Performer {
  public:
    /// Of a valid sea, which others do not change meanwhile.
    explicit Performer(const Sea& sea);

    /// See Ocean::perform. Returns the time from which on the sea is another, infinity if it is
    /// not.
    double perform(Sea& sea, double time, std::string_view name, std::string_view value);

  private:
    double last_;        // time that was performed at
    std::size_t bytes_;  // of the take as text
};

}  // namespace ocean
