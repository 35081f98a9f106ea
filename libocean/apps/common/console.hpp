// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What a command says, and where: data and paths on standard output, everything else on standard
// error, as text for people or as JSON lines for schedulers. Any thread may speak on standard
// error.
#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "command.hpp"
#include "ocean/internal/json.hpp"

namespace ocean::app {

/// Who read standard output has had enough, as `head` does: the program ends without a word.
class ClosedPipe : public std::exception {
  public:
    const char* what() const noexcept override { return "standard output is closed"; }
};

class Console {
  public:
    /// Of a JSON object.
    using Members = std::vector<std::pair<std::string_view, Json>>;

    /// Lines for people begin with the program's name. `options` is read at each call: it is
    /// filled when the command line is parsed.
    Console(const std::string& program, const RunOptions& options)
        : prefix_(program + ": "), options_(options) {}

    /// Standard output; the main thread only. Throws ClosedPipe, or Error output if it cannot be
    /// written, so that a full disk behind a redirection is not taken for success.
    void data(std::string_view text);
    /// Standard error. Notes need -v; notes and warnings are silent with -q.
    void note(std::string_view text) { say("note", text, options_.verbose && !options_.quiet); }
    void warning(std::string_view text) { say("warning", text, !options_.quiet); }
    void error(std::string_view text) { say("error", text, true); }

    /// A run of `total` steps begins; `summary` says what is to be done, `more` its JSON line.
    void begin(int total, std::string_view summary, const Members& more);
    /// One more frame is there: its files were written, or kept as they were. Prints their paths
    /// and the progress.
    void step(int frame, double seconds, const std::vector<std::string>& files);
    void skip(int frame, const std::vector<std::string>& files);
    /// A frame could not be written. Silent as text if the run ends with it: its error says it.
    void fail(int frame, std::string_view message, bool goes_on);
    /// The run went to its end.
    void finish();
    /// One line of facts: `text` for people or a JSON object of `event` and `members`.
    void report(std::string_view event, std::string_view text, const Members& members);
    /// The run is cut off by a signal. Says how far it came.
    void interrupted();

  private:
    void deliver(const std::vector<std::string>& files);
    void say(std::string_view kind, std::string_view text, bool wanted);
    void draw_bar(int frame, double seconds);
    void clear_bar();
    void write_error_line(std::string_view line);
    void write_event(std::string_view event, const Members& members);
    double eta() const;
    Members with_counts(Members before, const Members& after) const;

    const std::string prefix_;
    const RunOptions& options_;
    std::mutex mutex_;
    int total_ = 0;
    int done_ = 0;  // skipped ones too
    int skipped_ = 0;
    int failed_ = 0;
    double started_ = 0.0;  // s, of the steady clock
    bool bar_drawn_ = false;
};

/// What an Ocean tells of the foam that it follows, said every few seconds.
std::function<void(std::int64_t done, std::int64_t total)> foam_progress_on(Console& console);
/// Says every few seconds how many of `total` steps, such as "times", are done.
std::function<void(std::size_t done)> progress_on(Console& console, const std::string& steps,
                                                  std::size_t total);

}  // namespace ocean::app
