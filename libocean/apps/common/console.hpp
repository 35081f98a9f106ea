// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The output of a command: data and paths on standard output, everything else on standard error, as
// readable text or as JSON lines for schedulers. Any thread may write to standard error.
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

/// The reader of standard output, such as `head`, has closed it: the program ends without a
/// message.
class ClosedPipe : public std::exception {
  public:
    const char* what() const noexcept override { return "standard output is closed"; }
};

class Console {
  public:
    /// The members of a JSON object.
    using Members = std::vector<std::pair<std::string_view, Json>>;

    /// Lines of text begin with the program's name. `options` is read at each call, because it is
    /// filled when the command line is parsed.
    Console(const std::string& program, const RunOptions& options)
        : prefix_(program + ": "), options_(options) {}

    /// Writes to standard output; main thread only. Throws ClosedPipe, or Error output if writing
    /// fails, so that a redirection to a full disk is not reported as a success.
    void data(std::string_view text);
    /// Write to standard error. Notes are printed with -v only; -q suppresses notes and warnings.
    void note(std::string_view text) { say("note", text, options_.verbose && !options_.quiet); }
    void warning(std::string_view text) { say("warning", text, !options_.quiet); }
    void error(std::string_view text) { say("error", text, true); }

    /// Starts a run of `total` steps; prints `summary`, or `more` as a JSON line.
    void begin(int total, std::string_view summary, const Members& more);
    /// Report a frame whose files were written, or kept. Print their paths and the progress.
    void step(int frame, double seconds, const std::vector<std::string>& files);
    void skip(int frame, const std::vector<std::string>& files);
    /// Reports a frame that could not be written. Prints text only if the run continues, because
    /// the error that ends it has the same message.
    void fail(int frame, std::string_view message, bool continues);
    /// Reports the end of the run.
    void finish();
    /// Prints `text` as a line, or a JSON object of `event` and `members`.
    void report(std::string_view event, std::string_view text, const Members& members);
    /// Reports that a signal ended the run, with its progress.
    void interrupted();

    /// Reports the share of a run that is done: prints the line of --progress for a further per
    /// cent.
    void advance(double share);

    /// Prints the paths of files that were written, unless -q.
    void deliver(const std::vector<std::string>& files);

  private:
    void say(std::string_view kind, std::string_view text, bool wanted);
    void draw_bar(int frame, double seconds);
    void clear_bar();
    void write_error_line(std::string_view line);
    void write_event(std::string_view event, const Members& members);
    double eta() const;
    int ended_percent() const;
    void print_percent(int percent);
    Members with_counts(Members before, const Members& after) const;

    const std::string prefix_;
    const RunOptions& options_;
    std::mutex mutex_;
    int total_ = 0;
    int done_ = 0;  // including skipped frames
    int skipped_ = 0;
    int failed_ = 0;
    int percent_ = -1;      // that was printed last
    double started_ = 0.0;  // of the steady clock [s]
    bool bar_drawn_ = false;
};

/// Returns a function that reports the progress of computing earlier foam every few seconds.
std::function<void(std::int64_t done, std::int64_t total)> foam_progress_on(Console& console);
/// Returns a function that reports every few seconds what is being computed and the share of it
/// that is done.
std::function<void(std::string_view work, double share)> build_progress_on(Console& console);
/// Returns a function that reports every few seconds how many of `total` steps, such as "times",
/// are done.
std::function<void(std::size_t done)> progress_on(Console& console, const std::string& steps,
                                                  std::size_t total);

}  // namespace ocean::app
