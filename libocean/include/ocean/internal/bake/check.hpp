// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads the files of a bake against its manifests, without its sea and without writing.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/bake/plan.hpp"

namespace ocean {

struct CheckRequest {
    std::string path;         // a manifest, or the output of the bake, "out/sea.####.exr"
    std::vector<int> frames;  // that every product must have; empty: no gap between the others
    std::string against;      // the text of the only subject that is allowed; empty: any one
    bool merge = false;       // without a fault, joins the manifests of shards to that of the whole
    int threads = 0;          // 0 = the cores this process may use
    /// Called with the share of the files that are read, as MapsOptions::build_progress; may be
    /// empty.
    std::function<void(std::string_view work, double share)> progress = {};
};

/// A fault of a file.
enum class BakeFault {
    missing,  // it does not exist
    damaged,  // its bytes are not those that were written
    foreign,  // no manifest lists it
    other,    // it is of another subject, of other options or of another version
};
std::string_view fault_name(BakeFault fault);

struct FaultyFile {
    BakeFault fault;
    std::string path;
    std::string reason;
};

struct BakeCheck {
    std::vector<FaultyFile> faults;  // by their paths
    std::size_t files = 0;           // that the manifests list
    std::size_t whole = 0;           // of these
    std::uint64_t bytes = 0;         // of these
    std::string merged;              // the path of the joined manifest; "" = none
};

/// Reads every file that a manifest of the bake lists, and its hash. A shard whose manifest lacks
/// is missing. Throws Error invalid_value for a path that names no output, and output if the joined
/// manifest cannot be written.
BakeCheck check_bake(const CheckRequest& request);

}  // namespace ocean
