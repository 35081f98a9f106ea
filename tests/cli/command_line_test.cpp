// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: every kind of option reaches its target, each mistake gets the sentence that says what is
// wrong and a command with one does not run, a failure becomes one line with the program's name and
// an exit code, and a program may be a single command without a name. test_usage.py tests the
// options of `ocean` itself.
#include "command_line.hpp"

#include <new>

#include "console.hpp"
#include "mistakes.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/text.hpp"

namespace ocean::app {
namespace {

struct Values {
    bool flag = false;
    bool foam = true;
    int whole = 0;
    std::string word;
    std::optional<int> maybe_whole;
    std::optional<double> maybe_number;
    std::vector<std::string> list;
};

std::vector<OptionGroup> options_for(Values& values) {
    return {{"",
             {{"WORD", &values.word, "", "A word without a name"},
              {"-f,--flag", &values.flag, "", "A flag"},
              {"!--no-foam", &values.foam, "", "A flag that clears"}}},
            {"Numbers",
             {{"--whole", &values.whole, "N", "Within a range", kOptional, Within{-2, 64}},
              {"--maybe", &values.maybe_whole, "N", "Perhaps"},
              {"--number", &values.maybe_number, "X", "Perhaps"}}},
            {"Texts",
             {{"--list", &values.list, "TEXT", "As often as you like"},
              {.names = "--not-flag",
               .target = &RunOptions::verbose,
               .help = "Not beside --flag",
               .excludes = "--flag"}}},
            run_options("Lines of JSON")};
}

struct Outcome {
    int code;
    std::string output;
    std::string error;
};

Outcome run(const Program& program, std::vector<std::string> words) {
    words.insert(words.begin(), program.main.name);
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int code = run_program(static_cast<int>(arguments.size()), arguments.data(), program);
    return {code, testing::internal::GetCapturedStdout(), testing::internal::GetCapturedStderr()};
}

Program single(Command command) {
    command.name = "ocean-preview";
    command.summary = "Shows a sea.";
    return {.main = std::move(command), .version = "ocean-preview 1.2"};
}

TEST(CommandLine, EveryKindOfOptionReachesItsTarget) {
    Values values;
    RunOptions seen;
    const Program program =
        single({.options = options_for(values),
                .run = [&](const Context& context) { seen = context.options; }});
    const Outcome outcome =
        run(program, {"-f", "--no-foam", "--whole", "-2", "--maybe=7", "--number", "0.5", "--list",
                      "a", "--list", "b", "word", "--threads", "3", "--json"});
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    EXPECT_TRUE(values.flag);
    EXPECT_FALSE(values.foam);
    EXPECT_EQ(values.whole, -2);
    EXPECT_EQ(values.maybe_whole, 7);
    EXPECT_EQ(values.maybe_number, 0.5);
    EXPECT_EQ(values.list, (std::vector<std::string>{"a", "b"}));
    EXPECT_EQ(values.word, "word");
    EXPECT_EQ(seen.threads, 3);
    EXPECT_TRUE(seen.json);
    EXPECT_FALSE(seen.quiet);
}

TEST(CommandLine, OptionsThatAreNotGivenKeepTheirDefaults) {
    Values values;
    EXPECT_EQ(run(single({.options = options_for(values), .run = [](const Context&) {}}), {}).code,
              0);
    EXPECT_TRUE(values.foam);
    EXPECT_FALSE(values.maybe_whole || values.maybe_number);
    EXPECT_TRUE(values.list.empty());
}

TEST(CommandLine, WrongUsageNamesTheProgramAndRunsNothing) {
    std::string needed, one_of, filled;
    Values values;
    std::vector<OptionGroup> options = options_for(values);
    options.push_back({"Rules",
                       {{"--needed", &needed, "TEXT", "", kRequired},
                        {"--one-of", &one_of, "TEXT", "", kOptional, OneOf{{"cpu", "gl"}}},
                        {"--filled", &filled, "TEXT", "", kOptional, NotEmpty{}}}});
    const Program program = single({.options = options, .run = [](const Context&) { FAIL(); }});
    const std::vector<std::vector<std::string>> wrong = {
        {},
        {"--needed"},
        {"--needed", "a", "--needed", "b"},
        {"--needed", "a", "--unknown"},
        {"--needed", "a", "--whole", "65"},
        {"--needed", "a", "--whole", "x"},
        {"--needed", "a", "--one-of", "cuda"},
        {"--needed", "a", "--filled", ""},
        {"--needed", "a", "--flag", "--not-flag"},
        {"--needed", "a", "word", "another"},
    };
    for (const std::vector<std::string>& words : wrong) {
        const Outcome outcome = run(program, words);
        EXPECT_EQ(outcome.code, 2);
        EXPECT_EQ(outcome.output, "");
        EXPECT_TRUE(outcome.error.starts_with("ocean-preview: ")) << outcome.error;
        EXPECT_TRUE(outcome.error.ends_with("(see `ocean-preview --help`)\n")) << outcome.error;
    }
}

TEST(CommandLine, AFailureHasAnExitCode) {
    const auto code = [](const std::function<void()>& fail) {
        return run(single({.run = [&](const Context&) { fail(); }}), {}).code;
    };
    EXPECT_EQ(code([] { throw Error(ErrorKind::output, "full"); }), 1);
    EXPECT_EQ(code([] { throw Error(ErrorKind::out_of_memory, "large"); }), 1);
    EXPECT_EQ(code([] { throw std::bad_alloc(); }), 1);
    EXPECT_EQ(code([] { throw Error(ErrorKind::invalid_value, "wrong"); }), 2);
    EXPECT_EQ(code([] { throw Error(ErrorKind::bad_file, "broken"); }), 2);
    EXPECT_EQ(code([] { throw Error(ErrorKind::interrupted, "Ctrl-C"); }), 130);
}

TEST(CommandLine, HelpAndVersionGoToStandardOutput) {
    Values values;
    const Program program =
        single({.options = options_for(values), .footer = "The end.", .run = {}});
    const Outcome help = run(program, {"--help"});
    EXPECT_EQ(help.code, 0);
    for (const char* part : {"Shows a sea.", "Numbers:", "--whole N", "Not beside", "The end."}) {
        EXPECT_NE(help.output.find(part), std::string::npos) << part;
    }
    EXPECT_EQ(run(program, {"--version"}).output, "ocean-preview 1.2\n");
}

TEST(CommandLine, ACommandRunsAloneWithItsOwnOptions) {
    std::string ran;
    std::string first, second;
    const auto command = [&](const char* name, std::string& word) {
        return Command{.name = name,
                       .summary = "",
                       .options = {{"", {{"WORD", &word, "", ""}}}},
                       .run = [&ran, name](const Context&) { ran += name; }};
    };
    const Program program{.main = {.name = "ocean", .footer = "", .run = {}},
                          .version = "",
                          .commands = {command("first", first), command("second", second)}};
    EXPECT_EQ(run(program, {"second", "x"}).code, 0);
    EXPECT_EQ(ran, "second");
    EXPECT_EQ(second, "x");
    EXPECT_EQ(first, "");
    EXPECT_EQ(run(program, {}).code, 2);
    EXPECT_EQ(run(program, {"third"}).code, 2);
    const Outcome wrong = run(program, {"first", "x", "y"});
    EXPECT_TRUE(wrong.error.ends_with("(see `ocean first --help`)\n")) << wrong.error;
    EXPECT_EQ(ran, "second");
}

/// The kinds of options that `ocean bake` has.
struct BakeProgram {
    Values values;
    std::string sea, output, frames, backend;
    std::optional<std::string> learnt;
    bool ran = false;
    Program program{
        .main = {.name = "ocean", .options = {run_options("")}, .run = {}},
        .version = "ocean 1.2",
        .commands = {{.name = "bake",
                      .options = {{"",
                                   {{"SEA", &sea, "", "", kRequired},
                                    {"-o,--output", &output, "FILE", "", kRequired},
                                    {"--frames", &frames, "RANGES", "", kOptional, NotEmpty{}},
                                    {"--backend", &backend, "NAME", "", kOptional,
                                     OneOf{{"auto", "gl", "cpu"}}},
                                    {"--time", &values.maybe_number, "T"},
                                    {.names = "--frame",
                                     .target = &values.maybe_whole,
                                     .type = "N",
                                     .excludes = "--time"},
                                    {"--set", &values.list, "NAME=VALUE"},
                                    {"--learn", &learnt, "[NAME]"},
                                    {"!--no-foam", &values.foam}}},
                                  run_options("JSON")},
                      .run = [this](const Context&) { ran = true; }}}};

    /// Runs the words of a line, in which '' is an empty word.
    Outcome operator()(const std::string& line) {
        std::vector<std::string> words = split(line, ' ');
        for (std::string& word : words) {
            if (word == "''") word.clear();
        }
        if (line.empty()) words.clear();
        return run(program, words);
    }
};

TEST(CommandLine, EachMistakeHasItsSentence) {
    for (const std::string usage : {"ocean", "ocean bake"}) {
        for (const auto& [line, says] : test::mistakes("cli/rows/usage.toml", usage)) {
            BakeProgram bake;
            const Outcome outcome = bake(line);
            EXPECT_EQ(outcome.error, "ocean: " + says + " (see `" + usage + " --help`)\n");
            EXPECT_EQ(outcome.code, 2) << line;
            EXPECT_EQ(outcome.output, "") << line;
            EXPECT_FALSE(bake.ran) << line;
        }
    }
    for (const char* flag : {"-q=3", "-v=yes", "-o=b"}) {
        EXPECT_EQ(BakeProgram()(std::string("bake a -o b ") + flag).error,
                  std::string("ocean: ") + flag +
                      ": the value of a short option follows after a blank, and a flag has none\n");
    }
}

TEST(CommandLine, UnusualSpellingsKeepTheirMeaning) {
    struct Spelling {
        const char* line;
        std::function<bool(const BakeProgram&)> is_right;
    };
    const Spelling spellings[] = {
        {"bake a -ob", [](const auto& bake) { return bake.output == "b"; }},
        {"bake -qvob a", [](const auto& bake) { return bake.output == "b" && bake.sea == "a"; }},
        {"bake --output=b=c a", [](const auto& bake) { return bake.output == "b=c"; }},
        {"bake -o -odd.exr a", [](const auto& bake) { return bake.output == "-odd.exr"; }},
        {"bake -o b -- -a", [](const auto& bake) { return bake.sea == "-a"; }},
        {"bake -o b -", [](const auto& bake) { return bake.sea == "-"; }},
        {"bake a -o b --time -5",
         [](const auto& bake) { return bake.values.maybe_number == -5.0; }},
        {"bake a -o b --frame 010", [](const auto& bake) { return bake.values.maybe_whole == 10; }},
        {"bake a -o b --learn", [](const auto& bake) { return bake.learnt == ""; }},
        {"bake a -o b --learn -q", [](const auto& bake) { return bake.learnt == ""; }},
        {"bake --learn knob a -o b", [](const auto& bake) { return bake.learnt == "knob"; }},
        {"bake a -o b", [](const auto& bake) { return bake.values.foam && !bake.learnt; }},
        {"bake a -o b -q -v -q -q", [](const auto& bake) { return bake.sea == "a"; }},
        {"bake a -o b --no-foam", [](const auto& bake) { return !bake.values.foam; }},
        {"bake a -o b --no-foam=false", [](const auto& bake) { return bake.values.foam; }},
        {"--threads 2 -q bake a -o b -q", [](const auto& bake) { return bake.sea == "a"; }},
    };
    for (const auto& [line, is_right] : spellings) {
        BakeProgram bake;
        const Outcome outcome = bake(line);
        EXPECT_EQ(outcome.error, "") << line;
        EXPECT_TRUE(bake.ran && is_right(bake)) << line;
    }
    EXPECT_EQ(BakeProgram()("--version bake").output, "ocean 1.2\n");
    EXPECT_TRUE(BakeProgram()("bake --threads x -qh").output.find("Usage: ocean bake") !=
                std::string::npos);
}

/// A program as `ocean` is: `terrain` runs by itself, `terrain import` is a command beside it, and
/// `shore` only begins the name of `shore wash`.
struct TwoWordProgram {
    std::string ran;
    std::string file;
    std::string output;
    Program program{.main = {.name = "ocean", .summary = "Makes seas.", .run = {}},
                    .version = "",
                    .commands = {command("terrain import"),
                                 command("bake"),
                                 command("terrain"),
                                 {.name = "shore", .summary = "Works on shores."},
                                 command("shore wash")}};

    Command command(const std::string& name) {
        return {.name = name,
                .summary = "Runs " + name + ".",
                .options = {{"", {{"FILE", &file, "", "The file"}}},
                            {"Output", {{"-o,--output", &output, "FILE", "The output"}}},
                            run_options("")},
                .run = [this, name](const Context&) { ran += "[" + name + "]"; }};
    }
};

TEST(CommandLine, ACommandOfTwoWordsRunsInsteadOfTheCommandOfItsFirstWord) {
    const std::vector<std::vector<std::string>> lines = {
        {"terrain", "import", "a.tif", "-o", "bed.flt"},
        {"terrain", "-o", "bed.flt", "-q", "import", "a.tif"}};
    for (const std::vector<std::string>& words : lines) {
        TwoWordProgram two;
        const Outcome outcome = run(two.program, words);
        EXPECT_EQ(outcome.code, 0) << outcome.error;
        EXPECT_EQ(two.ran, "[terrain import]");
        EXPECT_EQ(two.file, "a.tif");
        EXPECT_EQ(two.output, "bed.flt");
    }
}

TEST(CommandLine, AnArgumentKeepsItsMeaningBesideCommandsOfTwoWords) {
    for (const char* file : {"hills.toml", "./import", "preset:import"}) {
        TwoWordProgram two;
        EXPECT_EQ(run(two.program, {"terrain", "-o", "import", file}).code, 0);
        EXPECT_EQ(two.ran, "[terrain]") << file;
        EXPECT_EQ(two.file, file);
        EXPECT_EQ(two.output, "import");
    }
    TwoWordProgram two;
    EXPECT_EQ(run(two.program, {"bake", "import"}).code, 0);
    EXPECT_EQ(two.ran + two.file, "[bake]import");
}

TEST(CommandLine, AMistypedSecondWordIsNoFile) {
    TwoWordProgram two;
    const Outcome outcome = run(two.program, {"terrain", "imprt", "a.tif"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.error,
              "ocean: unknown command 'terrain imprt'; did you mean import? (see `ocean terrain "
              "--help`)\n");
    const Outcome none = run(two.program, {"shore", "x"});
    EXPECT_EQ(none.error, "ocean: unknown command 'shore x' (see `ocean shore --help`)\n");
    const Outcome alone = run(two.program, {"shore"});
    EXPECT_EQ(alone.error,
              "ocean: a command is required after 'shore': wash (see `ocean shore --help`)\n");
    EXPECT_EQ(run(two.program, {"terrain.import", "a.tif"}).code, 2);
    EXPECT_EQ(two.ran, "");
    const Outcome option = run(two.program, {"terrain", "import", "--ouptut", "x"});
    EXPECT_EQ(option.error,
              "ocean: unknown option '--ouptut'; did you mean --output? (see `ocean terrain import "
              "--help`)\n");
    const Outcome extra = run(two.program, {"terrain", "import", "a", "b"});
    EXPECT_TRUE(extra.error.ends_with("(see `ocean terrain import --help`)\n")) << extra.error;
}

TEST(CommandLine, ACommandOfTwoWordsIsListedUnderTheFirst) {
    const TwoWordProgram two;
    const std::string all = run(two.program, {"--help"}).output;
    EXPECT_NE(all.find("  bake                      Runs bake.\n"
                       "  terrain                   Runs terrain.\n"
                       "  terrain import            Runs terrain import.\n"),
              std::string::npos)
        << all;
    const std::string parent = run(two.program, {"terrain", "--help"}).output;
    EXPECT_TRUE(
        parent.starts_with("Runs terrain.\n"
                           "Usage: ocean terrain [OPTIONS] [FILE]\n"
                           "       ocean terrain COMMAND [OPTIONS]\n"))
        << parent;
    EXPECT_NE(parent.find("Commands:\n  import                    Runs terrain import.\n"),
              std::string::npos);
    EXPECT_TRUE(run(two.program, {"terrain", "import", "--help"})
                    .output.starts_with("Runs terrain import.\nUsage: ocean terrain import"));
    EXPECT_TRUE(
        run(two.program, {"shore", "--help"})
            .output.starts_with("Works on shores.\nUsage: ocean shore [OPTIONS] COMMAND\n"));
}

}  // namespace
}  // namespace ocean::app
