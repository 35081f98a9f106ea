// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Lines of a take, checked one by one. The file of a take and the [take] of a sea file hold the
// same lines.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "ocean/sea.hpp"

namespace ocean {

/// The section of a sea file that holds a take, and its only key.
inline constexpr std::string_view kTakeSection = "take";
inline constexpr std::string_view kTakeLines = "lines";

/// Converts lines to the events of a sea whose parameters are known.
class TakeReader {
  public:
    TakeReader(const Parameters& parameters, std::string name)
        : checked_(parameters), name_(std::move(name)) {}

    /// Adds a line "<seconds> <name> <value>"; ignores blank lines and comments. Throws Error
    /// "NAME:LINE: ...".
    void add(std::string_view line, std::size_t number);
    std::vector<TakeEvent> finish() { return std::move(events_); }

  private:
    TakeEvent event_of(std::string_view line);

    Parameters checked_;
    std::string name_;
    std::vector<TakeEvent> events_;
};

/// Reads the take that `time.take` names, unless the sea has it already.
void resolve_take(Sea& sea, const std::string& base_dir);

}  // namespace ocean
