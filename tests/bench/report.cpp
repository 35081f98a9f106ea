// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Prints results.
#include "report.hpp"

#include "ocean/error.hpp"

namespace ocean::bench {

namespace {

/// Texts here are names of our own and of processors: quotes are all there is to escape.
std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') result += '\\';
        if (static_cast<unsigned char>(c) >= 0x20) result += c;
    }
    return result + '"';
}

}  // namespace

Report::Report(const std::string& json_file) {
    if (json_file.empty()) return;
    json_ = std::fopen(json_file.c_str(), "w");
    if (json_ == nullptr) throw Error(ErrorKind::output, json_file + " cannot be written");
}

Report::~Report() {
    if (json_ != nullptr) std::fclose(json_);
}

void Report::add(const FrameResult& r) {
    std::printf(
        "%-10s N=%-5d %d thr %-6s %-4s %-16s %-30s %9.3f ms  ratio %6.3f  error %8.1e"
        "  %3d rounds, %d under load, %d dropped\n",
        r.frame.c_str(), r.n, r.threads, r.simd.c_str(), state_name(r.state), r.library.c_str(),
        r.variant.c_str(), r.milliseconds, r.ratio, r.error, r.rounds, r.loaded, r.dropped);
    std::fflush(stdout);
    if (json_ == nullptr) return;
    std::fprintf(json_,
                 "{\"kind\": \"frame\", \"frame\": %s, \"n\": %d, \"threads\": %d, \"simd\": %s, "
                 "\"state\": \"%s\", \"library\": %s, \"variant\": %s, \"pairs\": %s, "
                 "\"ms\": %.6g, \"ratio\": %.6g, \"error\": %.3g, \"rounds\": %d, "
                 "\"loaded\": %d, \"dropped\": %d}\n",
                 quoted(r.frame).c_str(), r.n, r.threads, quoted(r.simd).c_str(),
                 state_name(r.state), quoted(r.library).c_str(), quoted(r.variant).c_str(),
                 r.pairs ? "true" : "false", r.milliseconds, r.ratio, r.error, r.rounds, r.loaded,
                 r.dropped);
    std::fflush(json_);
}

void Report::add(const TrafficResult& r) {
    std::printf(
        "%-10s N=%-5d %d thr %-6s pass one %8.3f ms, limit %8.3f; two %8.3f ms, limit %8.3f\n",
        r.frame.c_str(), r.n, r.threads, r.simd.c_str(), r.milliseconds[0], r.limits[0],
        r.milliseconds[1], r.limits[1]);
    std::fflush(stdout);
    if (json_ == nullptr) return;
    std::fprintf(json_,
                 "{\"kind\": \"traffic\", \"frame\": %s, \"n\": %d, \"threads\": %d, "
                 "\"simd\": %s, \"ms\": [%.6g, %.6g], \"limits\": [%.6g, %.6g]}\n",
                 quoted(r.frame).c_str(), r.n, r.threads, quoted(r.simd).c_str(), r.milliseconds[0],
                 r.milliseconds[1], r.limits[0], r.limits[1]);
    std::fflush(json_);
}

void Report::figure(const std::string& name, const std::string& simd, int threads, double value,
                    const std::string& unit) {
    std::printf("%-50s %-6s %d thr %10.3f %s\n", name.c_str(), simd.c_str(), threads, value,
                unit.c_str());
    std::fflush(stdout);
    if (json_ == nullptr) return;
    std::fprintf(json_,
                 "{\"kind\": \"figure\", \"name\": %s, \"simd\": %s, \"threads\": %d, "
                 "\"value\": %.6g, \"unit\": %s}\n",
                 quoted(name).c_str(), quoted(simd).c_str(), threads, value, quoted(unit).c_str());
    std::fflush(json_);
}

void Report::fact(const std::string& name, const std::string& value) {
    std::printf("%s: %s\n", name.c_str(), value.c_str());
    if (json_ == nullptr) return;
    std::fprintf(json_, "{\"kind\": \"fact\", \"name\": %s, \"value\": %s}\n", quoted(name).c_str(),
                 quoted(value).c_str());
}

}  // namespace ocean::bench
