// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean verify`: runs the public verification suite on this machine.
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "commands.hpp"
#include "console.hpp"
#include "input_files.hpp"
#include "interrupt.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/io/output_file.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/internal/verify.hpp"
#include "ocean/seafile.hpp"
#include "subject_argument.hpp"
#include "verify/report.hpp"
#if OCEAN_HAS_GL
#include "ocean/gl/backend.hpp"
#endif

namespace ocean::app {
namespace {

struct VerifyOptions {
    SubjectArgument subject;
    std::vector<std::string> only;
    std::string output;
};

/// Returns true for a page that this command wrote.
bool is_report(const std::string& path) {
    std::ifstream file(utf8_path(path));
    std::string head(512, '\0');
    file.read(head.data(), static_cast<std::streamsize>(head.size()));
    return head.find("<title>Verification of libocean ") != std::string::npos;
}

void check_output(const VerifyOptions& options, const std::vector<std::string>& named) {
    if (options.output.empty()) return;
    if (utf8_path(options.output).extension() != ".html") {
        refuse("-o " + options.output + ": the report is a page of HTML; allowed is NAME.html");
    }
    InputFiles(options.subject.source, named).spare(options.output);
    io::refuse_to_replace_foreign_file(options.output, "`ocean verify`",
                                       [&] { return is_report(options.output); });
}

void run(const VerifyOptions& options, const Context& context) {
    verify::Request request;
    request.threads = context.options.threads;
    for (const std::string& names : options.only) {
        for (const std::string& name : split(names, ',')) request.only.push_back(name);
    }
    if (options.subject.source.empty() && !options.subject.assignments.empty()) {
        refuse("--set changes SEA, which is not given");
    }
    if (!options.subject.source.empty()) request.sea = open_sea(options.subject);
    check_output(options, request.sea ? named_files(*request.sea) : std::vector<std::string>());
#if OCEAN_HAS_GL
    request.backends = {gl::kBackend};
#endif
    Console& console = context.console;
    request.begin = [&](const verify::Group& group) {
        console.report("group", lower_case(group.title) + " ...", {{"group", group.name}});
    };
    request.done = [&](const verify::Row& row) {
        if (!context.options.json && !context.options.quiet) console.data(row_line(row) + "\n");
    };
    const std::vector<verify::Row> rows = verify::run(request);
    const VerifyReport report{rows, options.subject.source};
    if (context.options.json) console.data(report.json());
    if (!options.output.empty()) {
        write_output(context.interrupts, options.output, report.html());
        if (!context.options.json) console.deliver({options.output});
    }
    if (!context.options.json) console.data(report.summary() + "\n");
    if (report.count(verify::Verdict::fail) == 0) return;
    std::vector<std::string> failed;
    for (const verify::Row& row : rows) {
        if (row.verdict() == verify::Verdict::fail) failed.push_back(row.id);
    }
    throw Error(ErrorKind::output, joined(failed, ", ") + ": outside the tolerance");
}

constexpr char kVerifyFooter[] =
    R"(Measures spectra, maps, regions and queries on this machine and compares them
with equations and measurements of the literature, each within a stated
tolerance. With SEA, an open sea's own statistics too. A line is printed for each
case: its verdict, what is measured and expected, the tolerance, and the digits
of agreement, -log10 of the relative error. `shortfall` marks what the
documentation says is not met; it is no failure.
Exit codes: 0 no case fails, 1 one fails, 2 wrong usage, 130 interrupted.)";

}  // namespace

Command verify_command() {
    auto options = std::make_shared<VerifyOptions>();
    return {
        .name = "verify",
        .summary = "Compare the sea with equations and measurements, on this machine",
        .options = {subject_options(options->subject, kSeaKind, kOptional),
                    {"Verification",
                     {{"--only", &options->only, "GROUPS",
                       "Groups of cases, by commas: " +
                           joined(verify::groups(), ", ", &verify::Group::name)},
                      {"-o,--output", &options->output, "FILE.html",
                       "Write a page with all cases and their plots"}}},
                    run_options("Print one JSON object; progress as JSON lines")},
        .footer = kVerifyFooter,
        .run = [options](const Context& context) { run(*options, context); },
    };
}

}  // namespace ocean::app
