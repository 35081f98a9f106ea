// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Records of spectra against a table of the corpus, in every part.
#include "corpus_records.hpp"

#include <iostream>

#include "corpus.hpp"
#include "helpers.hpp"
#include "ocean/internal/directional_record.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/text.hpp"

namespace ocean::test {
namespace {

using Numbers = std::vector<double>;
/// A part of a record. `amount`: by how much its numbers may be off, those of sines and cosines.
template <typename Member>
struct Part {
    const char* key;
    Member member;
    double amount = 0.0;
};
constexpr Part<std::string SpectrumRecord::*> kTexts[] = {{"station", &SpectrumRecord::station},
                                                          {"time", &SpectrumRecord::time},
                                                          {"fault", &SpectrumRecord::fault}};
constexpr Part<double SpectrumRecord::*> kNumbers[] = {{"latitude", &SpectrumRecord::latitude},
                                                       {"longitude", &SpectrumRecord::longitude},
                                                       {"depth", &SpectrumRecord::depth}};
constexpr Part<Numbers SpectrumRecord::*> kLists[] = {
    {"frequency", &SpectrumRecord::frequency},
    {"density", &SpectrumRecord::density},
    {"direction", &SpectrumRecord::direction},
    {"directional_density", &SpectrumRecord::directional_density},
    {"a1", &SpectrumRecord::a1, 1e-12},
    {"b1", &SpectrumRecord::b1, 1e-12},
    {"a2", &SpectrumRecord::a2, 1e-12},
    {"b2", &SpectrumRecord::b2, 1e-12}};
constexpr Part<double (*)(const RecordSummary&)> kSums[] = {
    {"height", [](const RecordSummary& s) { return 4.0 * std::sqrt(s.m0); }},
    {"peak_period", [](const RecordSummary& s) { return s.peak_period; }},
    {"mean_period", [](const RecordSummary& s) { return s.mean_period; }},
    {"from", [](const RecordSummary& s) { return coming_from(s.mean_direction / kDegree); }, 1e-9},
    {"spread", [](const RecordSummary& s) { return s.directional_spread / kDegree; }, 1e-9}};

/// The expected record: a key has the value of the first of two tables that holds it.
class Expected {
  public:
    Expected(const toml::table* own, const toml::table* base, const toml::table& file)
        : own_(own), base_(base), file_(file) {}

    const toml::node* find(std::string_view key) const {
        if (own_ != nullptr && own_->contains(key)) return own_->get(key);
        const bool lost = own_ != nullptr && own_->contains("fault");
        constexpr std::string_view kKept[] = {"station", "time", "latitude", "longitude"};
        if (base_ == nullptr || (lost && std::ranges::count(kKept, key) == 0)) return nullptr;
        return base_->get(key);
    }
    /// Records of large files are judged by what their table says, others in every part.
    bool skips(std::string_view key) const {
        return file_.contains("data") && find(key) == nullptr;
    }
    /// Expects a number of a part; the table's `within` is an amount or a share, as the part has
    /// it.
    template <typename Member>
    void expect(double actual, const toml::node& node, const Part<Member>& part) const {
        const double wanted = number_of(node).value();
        const double within = file_["within"][part.key].value_or(0.0);
        const double off = part.amount > 0.0 ? part.amount + within : within * std::abs(wanted);
        if (same_bits(actual, wanted) || std::abs(actual - wanted) <= off) return;
        ADD_FAILURE() << part.key << ": " << shortest_text(actual) << " is not "
                      << shortest_text(wanted);
    }

  private:
    const toml::table* own_;
    const toml::table* base_;
    const toml::table& file_;
};

void expect_list(const Numbers& actual, const Expected& expected,
                 const Part<Numbers SpectrumRecord::*>& part) {
    const toml::node* node = expected.find(part.key);
    if (node == nullptr) {
        EXPECT_EQ(actual, Numbers()) << part.key;
    } else if (const toml::array* all = node->as_array()) {
        ASSERT_EQ(actual.size(), all->size()) << part.key;
        for (std::size_t i = 0; i < actual.size(); ++i) {
            SCOPED_TRACE("number " + std::to_string(i));
            expected.expect(actual[i], (*all)[i], part);
        }
    } else {  // some of them, by their index
        ASSERT_TRUE(node->is_table()) << part.key;
        const toml::table& some = *node->as_table();
        ASSERT_EQ(actual.size(), some["count"].value_or(std::size_t{0})) << part.key;
        for (const auto& [key, value] : some) {
            if (key.str() == "count") continue;
            expected.expect(actual.at(std::stoul(std::string(key.str()))), value, part);
        }
    }
}

void expect_record(const SpectrumRecord& actual, const Expected& expected) {
    for (const auto& part : kTexts) {
        if (expected.skips(part.key)) continue;
        const toml::node* text = expected.find(part.key);
        EXPECT_EQ(actual.*part.member, text == nullptr ? "" : text_of(*text)) << part.key;
    }
    for (const auto& part : kNumbers) {
        if (const toml::node* number = expected.find(part.key)) {
            expected.expect(actual.*part.member, *number, part);
        } else if (!expected.skips(part.key)) {
            EXPECT_TRUE(std::isnan(actual.*part.member)) << part.key << actual.*part.member;
        }
    }
    for (const auto& part : kLists) {
        if (!expected.skips(part.key)) expect_list(actual.*part.member, expected, part);
    }
    for (const auto& part : kSums) {
        const toml::node* sum = expected.find(part.key);
        if (sum != nullptr) expected.expect(part.member(summarize(actual)), *sum, part);
    }
    if (expected.skips("warnings")) return;
    std::vector<std::string> warnings;
    if (const toml::node* all = expected.find("warnings")) {
        for (const toml::node& one : *all->as_array()) warnings.push_back(text_of(one));
    }
    EXPECT_EQ(actual.warnings, warnings);
}

/// Prints records as a table has them: for a new case, once they are judged by other means.
void print(const std::vector<SpectrumRecord>& records, const std::string& section) {
    const auto list = [](const auto& all, const auto& text) {
        std::string line = "[";
        for (const auto& one : all) line += (line.size() > 1 ? ", " : "") + text(one);
        return line + "]";
    };
    const auto quoted = [](const std::string& text) { return '"' + text + '"'; };
    for (const SpectrumRecord& record : records) {
        std::cout << "[[" << section << "]]\n";
        const auto put = [](const std::string& key, const std::string& text) {
            std::cout << key << " = " << text << "\n";
        };
        for (const auto& [key, member, amount] : kTexts) {
            if (!(record.*member).empty()) put(key, quoted(record.*member));
        }
        for (const auto& [key, member, amount] : kNumbers) {
            if (!std::isnan(record.*member)) put(key, shortest_text(record.*member));
        }
        for (const auto& [key, member, amount] : kLists) {
            if ((record.*member).empty()) continue;
            put(key, list(record.*member, [](double x) { return shortest_text(x); }));
        }
        if (!record.warnings.empty()) put("warnings", list(record.warnings, quoted));
    }
}

/// Returns the tables of records, by the index of the record that each is about.
using Tables = std::map<std::size_t, const toml::table*>;
Tables by_index(const toml::table& table) {
    Tables tables;
    const toml::array* all = table["record"].as_array();
    if (all == nullptr) return tables;
    std::size_t next = 0;
    for (const toml::node& one : *all) {
        const toml::table& own = *one.as_table();
        const std::size_t at = own["at"].value_or(next);
        tables[at] = &own;
        next = at + 1;
    }
    return tables;
}

}  // namespace

void expect_records(const std::vector<SpectrumRecord>& records, const toml::table& file,
                    const toml::table* of_case) {
    const Tables base = by_index(file);
    const Tables own = of_case == nullptr ? Tables() : by_index(*of_case);
    std::size_t count = file["count"].value_or(base.size());
    if (of_case != nullptr) count = (*of_case)["count"].value_or(count);
    if (kPrints) print(records, of_case == nullptr ? "record" : "case.record");
    ASSERT_EQ(records.size(), count);
    for (std::size_t i = 0; i < count; ++i) {
        const toml::table* its = own.contains(i) ? own.at(i) : nullptr;
        const std::size_t like = its == nullptr ? i : (*its)["like"].value_or(i);
        if (its == nullptr && !base.contains(i)) continue;
        SCOPED_TRACE("record " + std::to_string(i));
        expect_record(records[i], {its, base.contains(like) ? base.at(like) : nullptr, file});
    }
}

}  // namespace ocean::test
