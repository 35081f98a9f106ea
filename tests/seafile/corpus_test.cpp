// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads the corpus of spectrum files (corpus/README.md): each file gives the records, and each edit
// of it the records or the sentence, that the table beside it says.

#include <iostream>
#include <set>

#include "corpus.hpp"
#include "corpus_records.hpp"
#include "gzip.hpp"
#include "helpers.hpp"

namespace ocean::test {
namespace {

namespace fs = std::filesystem;

std::string file_bytes(const fs::path& path) {
    const std::string bytes = text::read_file(path.string(), kMaxSpectrumFileBytes);
    return is_gzip(bytes) ? gunzip(bytes, path.string(), kMaxSpectrumFileBytes) : bytes;
}

/// Returns where line `number`, counted from 1, begins.
std::size_t line_start(const std::string& content, std::size_t number) {
    std::size_t at = 0;
    while (--number > 0) at = content.find('\n', at) + 1;
    return at;
}

/// A file of the corpus with the files beside it, some of them edited.
struct Input {
    fs::path folder;
    std::string name;                          // as the reader is told
    std::map<std::string, std::string> files;  // those that differ from the folder's
    std::set<std::string> missing;

    std::string content(const std::string& file) const {
        const auto found = files.find(file);
        return found != files.end() ? found->second : file_bytes(folder / file);
    }
    std::vector<SpectrumRecord> read() const {
        const auto companion = [&](const std::string& path) -> std::optional<std::string> {
            if (missing.contains(path)) return std::nullopt;
            if (!files.contains(path) && !fs::exists(folder / path)) return std::nullopt;
            return content(path);
        };
        const std::string own = content(name);
        return read_spectra_from({own, name, companion});
    }
};

/// Returns one of the alternatives of a replacement, or the only one.
std::string alternative(const toml::node& to, std::size_t index) {
    const toml::array* all = to.as_array();
    return text_of(all == nullptr ? to : (*all)[index]);
}
/// Returns how many alternatives the steps of a table have.
std::size_t alternatives(const toml::node& how) {
    const toml::array* all = how.as_array();
    if (all == nullptr || all->empty()) return 1;
    if (all->front().is_string())
        return all->back().is_array() ? all->back().as_array()->size() : 1;
    return alternatives(all->back());
}

/// Applies a step of the README to a content.
void edit(std::string& content, std::string_view what, const toml::node& how, std::size_t index) {
    const std::size_t number = how.value_or(std::size_t{0});
    if (what == "edit") {
        const toml::array& pair = *how.as_array();
        const std::string from = text_of(pair[0]);
        if (content.find(from) == std::string::npos) throw std::runtime_error("no " + from);
        content = replaced(content, from, alternative(pair[1], index));
    } else if (what == "edits") {
        for (const toml::node& one : *how.as_array()) edit(content, "edit", one, index);
    } else if (what == "text") {
        content = text_of(how);
    } else if (what == "append") {
        content += text_of(how);
    } else if (what == "lines") {
        content.resize(line_start(content, number + 1));
    } else if (what == "without_line") {
        const std::size_t at = line_start(content, number);
        content.erase(at, line_start(content, number + 1) - at);
    } else if (what == "cut") {
        content.resize(content.size() - number);
    }
}

Input edited(Input input, const toml::table& steps, std::size_t index = 0) {
    if (const auto name = steps["name"].value<std::string>()) {
        input.files[*name] = input.content(input.name);
        input.name = *name;
    }
    const std::string of = steps["of"].value_or(input.name);
    std::string content = input.content(of);
    for (const TomlEntry& step : in_file_order(steps)) edit(content, step.key, *step.node, index);
    input.files[of] = content;
    if (const toml::array* gone = steps["missing"].as_array()) {
        for (const toml::node& file : *gone) input.missing.insert(text_of(file));
    }
    return input;
}

/// The sentence of a fault, and what it costs: the file, a record, or the directions of a record.
struct Sentence {
    std::string key;
    std::string text;
};

Sentence sentence_of(const Input& broken) {
    std::vector<SpectrumRecord> records;
    const Refusal whole = refusal_of([&] { records = broken.read(); });
    if (whole.refused) {
        EXPECT_EQ(whole.kind, ErrorKind::bad_file);
        return {"refused", whole.message};
    }
    for (const SpectrumRecord& record : records) {
        if (!record.fault.empty()) return {"fault", record.fault};
    }
    for (const SpectrumRecord& record : records) {
        if (!record.warnings.empty()) return {"warning", record.warnings[0]};
    }
    return {};
}

class CorpusFile : public testing::TestWithParam<fs::path> {
  protected:
    CorpusFile() : table_(read_table(GetParam())) {
        const auto data = table_["data"].value<std::string>();
        const fs::path path =
            data ? fs::path(kData) / *data : fs::path(GetParam()).replace_extension();
        input_ = {path.parent_path(), path.filename().string(), {}, {}};
        content_ = input_.content(input_.name);
    }

    Input with(std::string content) const {
        Input input = input_;
        input.files[input.name] = std::move(content);
        return input;
    }
    std::vector<const toml::table*> tables(std::string_view key) const {
        std::vector<const toml::table*> tables;
        const toml::array* all = table_[key].as_array();
        if (all == nullptr) return tables;
        for (const toml::node& one : *all) tables.push_back(one.as_table());
        return tables;
    }

    void expect_case(const toml::table& own) const {
        const std::string says = own["says"].value_or(std::string());
        std::size_t ways = 1;
        for (const auto& [key, how] : own) ways = std::max(ways, alternatives(how));
        for (std::size_t index = 0; index < ways; ++index) {
            SCOPED_TRACE(says + ", way " + std::to_string(index));
            if (kPrints) std::cout << "# " << says << "\n";
            expect_records(edited(input_, own, index).read(), table_, &own);
        }
    }

    void expect_fault(const toml::table& row) const {
        SCOPED_TRACE("line " + std::to_string(line_of(row)) + " of the table");
        const Sentence sentence = sentence_of(edited(input_, row));
        if (kPrints)
            std::cout << "[[broken]]\n" << sentence.key << " = \"" << sentence.text << "\"\n";
        expect_sentence(sentence.text, row.get(sentence.key));
    }

    /// Expects the same records with other line ends, and with a byte order mark.
    void expect_the_same_with_other_line_ends() const {
        std::string unix, windows;
        for (const char c : content_) {
            if (c == '\n') windows += '\r';
            if (c != '\r') unix += c, windows += c;
        }
        for (const std::string& other : {unix, windows, "\xEF\xBB\xBF" + windows}) {
            expect_records(with(other).read(), table_);
        }
    }

    /// Expects that a file which is cut after a line is refused, unless a time is complete there.
    void expect_cuts_of_lines_refused(const toml::table& cut) const {
        const auto count = static_cast<std::size_t>(std::ranges::count(content_, '\n'));
        const auto whole = cut["whole"].value<std::size_t>();
        const auto none = cut["holds_no_spectrum"].value<std::size_t>();
        for (std::size_t lines = 1; lines < count; ++lines) {
            const Input shorter = with(content_.substr(0, line_start(content_, lines + 1)));
            const Refusal fault = first_fault_of([&] { return shorter.read(); });
            EXPECT_EQ(fault.refused, lines != whole) << lines;
            const std::string where = ":" + std::to_string(lines) + ": the file ends ";
            EXPECT_TRUE(lines == whole || fault.says(lines == none ? "holds no spectrum" : where))
                << lines << fault.message;
        }
    }

    void expect_cuts_of_bytes_refused(const std::string& behind) const {
        const std::size_t first = content_.find(behind);
        ASSERT_NE(first, std::string::npos);
        for (std::size_t size = first; size + 1 < content_.size(); ++size) {
            const Input shorter = with(content_.substr(0, size));
            const Refusal fault = first_fault_of([&] { return shorter.read(); });
            ASSERT_TRUE(fault.says(input_.name + ":")) << size << fault.message;
        }
    }

    toml::table table_;
    Input input_;
    std::string content_;
};

TEST_P(CorpusFile, IsWhatItsTableSays) {
    if (table_.contains("refused")) {
        expect_sentence(sentence_of(input_).text, table_.get("refused"));
        return;
    }
    expect_records(input_.read(), table_);
    if (!table_.contains("data")) expect_the_same_with_other_line_ends();
    for (const toml::table* own : tables("case")) expect_case(*own);
    for (const toml::table* row : tables("broken")) expect_fault(*row);
    if (const toml::table* cut = table_["cut_lines"].as_table()) expect_cuts_of_lines_refused(*cut);
    if (const toml::node* behind = table_.get("cut_bytes_from")) {
        expect_cuts_of_bytes_refused(text_of(*behind));
    }
}

INSTANTIATE_TEST_SUITE_P(Of, CorpusFile, testing::ValuesIn(tables_in("seafile/corpus")),
                         name_of_table);

}  // namespace
}  // namespace ocean::test
