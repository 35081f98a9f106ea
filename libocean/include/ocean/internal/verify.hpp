// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The public verification suite: cases that measure the sea as hosts receive it, in spectra, maps,
// regions and queries, and compare it with the literature. The equations of the literature are
// written a second time in libocean/verify, apart from those of the library.
//
//     for (const verify::Row& row : verify::run({.only = {"spectra"}})) {
//         std::printf("%s: %.1f digits\n", row.id.c_str(), row.digits());
//     }
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/backend.hpp"
#include "ocean/sea.hpp"

namespace ocean::verify {

/// equations: the program solves what it says it solves. physics: that agrees with measurements.
enum class Kind { equations, physics };

/// shortfall: outside the tolerance, as the documentation says; no failure.
enum class Verdict { pass, fail, shortfall, not_run };
std::string_view verdict_name(Verdict verdict);

struct Point {
    double x, y;
    double error = 0.0;  // half of the bar
};

/// Measured points over the curve of the reference; a row without points has no plot.
struct Plot {
    std::string title = {}, x_label = {}, y_label = {};
    bool logarithmic = false;  // both axes
    std::vector<Point> curve = {}, measured = {};
};

/// One case. It passes if |measured - expected| <= tolerance.
struct Row {
    std::string id = {};  // "spectra.jonswap_height": the group, a dot, the case
    std::string claim = {};
    Kind kind = Kind::equations;
    std::string reference = {};  // a key of REFERENCES.md and the equation
    std::string method = {};     // what is measured, and at which resolution
    std::string unit = {};       // empty: a ratio or a count
    double expected = 0.0, measured = 0.0, tolerance = 0.0;
    std::string bound = {};      // where the tolerance comes from
    std::string shortfall = {};  // the page that states that the claim is not met; empty: it is
    std::string not_run = {};    // the reason; empty: it ran
    Plot plot = {};

    Verdict verdict() const;
    /// Returns the digits of agreement, -log10 of the relative error, at most 15; of the error
    /// itself where 0 is expected.
    double digits() const;
};

struct Group {
    std::string_view name, title;
};
/// Returns the groups in their order. The last one, "sea", runs for the user's sea alone.
std::span<const Group> groups();

/// Returns a sentence for each thing that the model leaves out.
std::span<const std::string_view> not_modelled();

struct Request {
    int threads = 0;                     // 0: the cores that this process may use
    std::vector<std::string> only = {};  // names of groups; empty: all
    std::optional<Sea> sea = {};
    /// Backends beside core's, which are compared with double precision where they run.
    std::vector<Backend> backends = {};
    std::function<void(const Group&)> begin = {};
    std::function<void(const Row&)> done = {};
};

/// Returns the rows of all groups requested. Throws Error invalid_value for an unknown group.
std::vector<Row> run(const Request& request);

/// The machine and the build, for the head of a report.
struct Build {
    std::string version, compiler, system, processor, instruction_set;
    int cores = 0;
};
Build this_build();

}  // namespace ocean::verify
