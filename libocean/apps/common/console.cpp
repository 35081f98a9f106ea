// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See console.hpp.
#include "console.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>

#include "ocean/error.hpp"
#include "standard_streams.hpp"
#include "text.hpp"

namespace ocean::app {
namespace {

double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

}  // namespace

// Takes no lock: a stalled reader must not delay the response to Ctrl-C.
void Console::data(std::string_view text) {
    const bool whole = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
    if (whole && std::fflush(stdout) == 0) return;
    if (errno == EPIPE) throw ClosedPipe();
    throw Error(ErrorKind::output,
                std::string("standard output cannot be written: ") + std::strerror(errno));
}

void Console::say(std::string_view kind, std::string_view text, bool wanted) {
    if (!wanted) return;
    const std::lock_guard lock(mutex_);
    if (options_.json) {
        write_event(kind, {{"message", text}});
    } else {
        const std::string label = kind == "error" ? "" : std::string(kind) + ": ";
        write_error_line(prefix_ + label + std::string(text));
    }
}

void Console::report(std::string_view event, std::string_view text, const Members& members) {
    const std::lock_guard lock(mutex_);
    if (options_.quiet) return;
    if (options_.json) {
        write_event(event, members);
    } else {
        write_error_line(prefix_ + std::string(text));
    }
}

void Console::begin(int total, std::string_view summary, const Members& more) {
    {
        const std::lock_guard lock(mutex_);
        total_ = total;
        done_ = skipped_ = failed_ = 0;
        started_ = now();
        percent_ = -1;
        print_percent(ended_percent());
    }
    Members members = {{"total", total}};
    members.insert(members.end(), more.begin(), more.end());
    report("start", summary, members);
}

void Console::deliver(const std::vector<std::string>& files) {
    if (options_.quiet) return;
    {
        const std::lock_guard lock(mutex_);
        clear_bar();
    }
    for (const std::string& file : files) data(file + "\n");
}

void Console::step(int frame, double seconds, const std::vector<std::string>& files) {
    {
        const std::lock_guard lock(mutex_);
        ++done_;
        print_percent(ended_percent());
    }
    deliver(files);
    const std::lock_guard lock(mutex_);
    if (options_.quiet) return;
    if (options_.json) {
        write_event("frame",
                    with_counts({{"frame", frame}}, {{"seconds", Json(seconds, decimals<3>)},
                                                     {"eta_seconds", Json(eta(), decimals<1>)},
                                                     {"files", json_array(files)}}));
    } else if (standard_error_is_terminal()) {
        draw_bar(frame, seconds);
    } else {
        write_error_line(
            prefix_ +
            format_text("frame %d done (%d of %d), %.2f s, ETA ", frame, done_, total_, seconds) +
            duration_text(eta()));
    }
}

void Console::skip(int frame, const std::vector<std::string>& files) {
    {
        const std::lock_guard lock(mutex_);
        ++done_;
        ++skipped_;
        print_percent(ended_percent());
    }
    deliver(files);
    report("skipped",
           format_text("frame %d skipped (%d of %d): it is complete", frame, done_, total_),
           with_counts({{"frame", frame}}, {{"files", json_array(files)}}));
}

void Console::fail(int frame, std::string_view message, bool continues) {
    const std::lock_guard lock(mutex_);
    ++failed_;
    print_percent(ended_percent());
    if (options_.json) {
        write_event("failed", with_counts({{"frame", frame}}, {{"message", message}}));
    } else if (continues) {
        write_error_line(prefix_ + format_text("frame %d failed: ", frame) + std::string(message));
    }
}

void Console::finish() {
    const double seconds = now() - started_;
    std::string text = format_text("%d of %d frames done", done_, total_);
    if (skipped_ > 0) text += format_text(", %d of them skipped", skipped_);
    if (failed_ > 0) text += format_text(", %d failed", failed_);
    report("done", text + " in " + duration_text(seconds),
           with_counts({}, {{"seconds", Json(seconds, decimals<3>)}}));
}

void Console::interrupted() {
    const std::lock_guard lock(mutex_);
    const std::string progress = format_text("%d of %d frames are done", done_, total_);
    if (options_.json) {
        write_event("interrupted", with_counts({}, {}));
    } else {
        write_error_line(prefix_ + "interrupted" + (total_ > 0 ? ": " + progress : std::string()));
    }
}

void Console::advance(double share) {
    const std::lock_guard lock(mutex_);
    print_percent(static_cast<int>(100.0 * share + 1e-9));
}

int Console::ended_percent() const {
    return total_ > 0 ? static_cast<int>(100LL * (done_ + failed_) / total_) : 100;
}

void Console::print_percent(int percent) {
    if (options_.progress.empty() || percent <= percent_) return;
    percent_ = percent;
    std::string line;
    for (const char c : options_.progress)
        line += c == '#' ? std::to_string(percent) : std::string{c};
    write_error_line(line);
}

Console::Members Console::with_counts(Members before, const Members& after) const {
    before.insert(before.end(),
                  {{"done", done_}, {"skipped", skipped_}, {"failed", failed_}, {"total", total_}});
    before.insert(before.end(), after.begin(), after.end());
    return before;
}

double Console::eta() const {
    const int made = done_ - skipped_;
    return made > 0 ? (now() - started_) / made * (total_ - done_ - failed_) : 0.0;
}

void Console::draw_bar(int frame, double seconds) {
    constexpr int kWidth = 24;
    const auto filled = static_cast<std::size_t>(kWidth * done_ / std::max(total_, 1));
    const std::string bar =
        std::string(filled, '#') + std::string(static_cast<std::size_t>(kWidth) - filled, '.');
    const std::string line = format_text("[%s] %d/%d  frame %d  %.2f s  ETA ", bar.c_str(), done_,
                                         total_, frame, seconds) +
                             duration_text(eta());
    std::fwrite(line.data(), 1, line.size(), stderr);
    bar_drawn_ = true;
}

void Console::clear_bar() {
    if (bar_drawn_) std::fputs("\r\033[K", stderr);
    bar_drawn_ = false;
}

/// Writes a line in one call, so that lines of several processes do not mix.
void Console::write_error_line(std::string_view line) {
    clear_bar();
    const std::string whole = std::string(line) + '\n';
    std::fwrite(whole.data(), 1, whole.size(), stderr);
}

void Console::write_event(std::string_view event, const Members& members) {
    JsonObject object;
    object.add("event", event);
    for (const auto& [key, value] : members) object.add(key, value);
    write_error_line(object.text());
}

std::function<void(std::int64_t, std::int64_t)> foam_progress_on(Console& console) {
    constexpr double kInterval = 10.0;  // [s]
    return [&console, last_report = now()](std::int64_t done, std::int64_t total) mutable {
        if (done == 0) last_report = now();
        if (now() - last_report < kInterval) return;
        last_report = now();
        console.report("foam",
                       "computing earlier foam: " + std::to_string(done) + " of " +
                           std::to_string(total) + " ticks",
                       {{"ticks_done", done}, {"ticks", total}});
    };
}

std::function<void(std::string_view, double)> build_progress_on(Console& console) {
    constexpr double kInterval = 2.0;  // [s]
    return [&console, last_report = now()](std::string_view work, double share) mutable {
        if (now() - last_report < kInterval) return;
        last_report = now();
        console.report(
            "build", format_text("computing %s: %.0f %%", std::string(work).c_str(), 100.0 * share),
            {{"work", std::string(work)}, {"share", Json(share, decimals<2>)}});
    };
}

std::function<void(std::size_t)> progress_on(Console& console, const std::string& steps,
                                             std::size_t total) {
    constexpr double kInterval = 5.0;  // [s]
    return [&console, steps, total, start = now(), last_report = now()](std::size_t done) mutable {
        const double time = now();
        if (time - last_report < kInterval) return;
        last_report = time;
        const double part = static_cast<double>(done) / static_cast<double>(total);
        const double left = (time - start) * (1.0 / part - 1.0);
        console.report(
            "progress",
            format_text("%zu of %zu %s, ETA ", done, total, steps.c_str()) + duration_text(left),
            {{"done", done}, {"total", total}, {"eta_seconds", Json(left, decimals<1>)}});
    };
}

}  // namespace ocean::app
