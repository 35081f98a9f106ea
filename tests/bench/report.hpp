// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What a run finds: a line for people, and a line of JSON for scripts/bench, which puts the lines
// of several processes together.
#pragma once

#include <cstdio>
#include <string>

#include "measure.hpp"
#include "subject.hpp"

namespace ocean::bench {

struct FrameResult {
    std::string frame;
    int n;
    int threads;
    std::string simd;
    State state;
    std::string library;
    std::string variant;
    bool pairs;
    double milliseconds;
    double ratio;  // ours / this subject
    double error;  // of its fields; < 0: not looked at
    int rounds;
    int loaded;
    int dropped;
};

/// Milliseconds of the two passes of a frame, and of their bytes at the speed of a copy.
struct TrafficResult {
    std::string frame;
    int n;
    int threads;
    std::string simd;
    double milliseconds[2];
    double limits[2];
};

class Report {
  public:
    /// "" = no JSON.
    explicit Report(const std::string& json_file);
    ~Report();
    Report(const Report&) = delete;
    Report& operator=(const Report&) = delete;

    void add(const FrameResult& result);
    void add(const TrafficResult& result);
    void figure(const std::string& name, const std::string& simd, int threads, double value,
                const std::string& unit);
    /// Machine, compiler, libraries.
    void fact(const std::string& name, const std::string& value);

  private:
    std::FILE* json_ = nullptr;
};

}  // namespace ocean::bench
