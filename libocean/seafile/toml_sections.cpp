// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/internal/toml_sections.hpp"

#include <algorithm>

#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/nearest_name.hpp"
#include "toml_input.hpp"

namespace ocean {
namespace {

/// Reads the sections of one file.
class SectionReader {
  public:
    SectionReader(const std::string& name, std::span<const std::string_view> known)
        : name_(name), known_(known) {}

    std::vector<TomlSection> read(const toml::table& table) const {
        std::vector<TomlSection> sections;
        for (const TomlEntry& entry : in_file_order(table)) {
            if (std::ranges::find(known_, entry.key) == known_.end()) {
                throw fail(entry.line, "unknown key '" + text::printable(entry.key) + "'" +
                                           did_you_mean(entry.key, known_) +
                                           "; allowed: " + allowed());
            }
            const toml::array* list = entry.node->as_array();
            if (list == nullptr) throw no_list(entry);
            for (const toml::node& item : *list) {
                const toml::table* section = item.as_table();
                if (section == nullptr) throw no_list(entry);
                sections.push_back({std::string(entry.key), line_of(item), keys_of(*section)});
            }
        }
        std::ranges::stable_sort(sections, {}, &TomlSection::line);
        return sections;
    }

  private:
    std::string allowed() const {
        std::string text;
        for (const std::string_view name : known_) {
            text += (text.empty() ? "[[" : ", [[") + std::string(name) + "]]";
        }
        return text;
    }
    Error fail(std::size_t line, const std::string& message) const {
        return text::error_at(ErrorKind::bad_file, name_, line, message);
    }
    Error no_list(const TomlEntry& entry) const {
        return fail(entry.line, std::string(entry.key) + " = " + shown(*entry.node) +
                                    ": allowed: " + allowed());
    }

    std::vector<TomlKey> keys_of(const toml::table& section) const {
        std::vector<TomlKey> keys;
        for (const TomlEntry& entry : in_file_order(section)) {
            keys.push_back({std::string(entry.key), entry.line, value_of(entry)});
        }
        return keys;
    }

    decltype(TomlKey::value) value_of(const TomlEntry& entry) const {
        const auto refused = [&] {
            return fail(entry.line, text::printable(entry.key) + " = " + shown(*entry.node) +
                                        ": allowed: a number, a text, true, false or a list of "
                                        "numbers");
        };
        if (const auto* flag = entry.node->as_boolean()) return flag->get();
        if (const auto* text = entry.node->as_string()) return text->get();
        if (const auto number = number_of(*entry.node)) return *number;
        const toml::array* list = entry.node->as_array();
        if (list == nullptr) throw refused();
        std::vector<double> numbers;
        for (const toml::node& item : *list) {
            const auto number = number_of(item);
            if (!number) throw refused();
            numbers.push_back(*number);
        }
        return numbers;
    }

    const std::string& name_;
    std::span<const std::string_view> known_;
};

}  // namespace

std::vector<TomlSection> parse_toml_sections(std::string_view text, const std::string& name,
                                             std::span<const std::string_view> known) {
    return SectionReader(name, known).read(parse_toml(text, name));
}

}  // namespace ocean
