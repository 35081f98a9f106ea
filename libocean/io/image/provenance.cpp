// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/internal/io/provenance.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "ocean/error.hpp"
#include "ocean/internal/platform.hpp"

namespace ocean::io {

namespace {

/// Reads the header strings of one file.
class StringReader {
  public:
    StringReader(std::span<const HeaderString> strings, const std::string& path)
        : strings_(strings), path_(path) {}

    const std::string* text(std::string_view name) const {
        const auto found = std::ranges::find_if(strings_, [&](const HeaderString& string) {
            return string.name.starts_with(kHeaderPrefix) &&
                   std::string_view(string.name).substr(kHeaderPrefix.size()) == name;
        });
        return found == strings_.end() ? nullptr : &found->text;
    }

    template <typename Number>
    std::optional<Number> number(std::string_view name) const {
        const std::string* digits = text(name);
        return digits == nullptr ? std::nullopt : std::optional(parse<Number>(name, *digits));
    }

    template <typename Number>
    std::optional<std::array<Number, 2>> pair(std::string_view name) const {
        const std::string* both = text(name);
        if (both == nullptr) return std::nullopt;
        const std::size_t comma = std::min(both->find(','), both->size());
        const std::string_view first = std::string_view(*both).substr(0, comma);
        const std::string_view second =
            std::string_view(*both).substr(std::min(comma + 1, both->size()));
        return std::array{parse<Number>(name, first), parse<Number>(name, second)};
    }

  private:
    template <typename Number>
    Number parse(std::string_view name, std::string_view digits) const {
        Number value{};
        const char* const end = digits.data() + digits.size();
        const auto [stop, fault] = std::from_chars(digits.data(), end, value);
        if (fault == std::errc() && stop == end) return value;
        throw Error(ErrorKind::bad_file,
                    path_ + ": its ocean:" + std::string(name) + " is not a number");
    }

    std::span<const HeaderString> strings_;
    const std::string& path_;
};

std::optional<Domain> find_domain(const StringReader& reader) {
    if (const auto period = reader.number<double>("period")) {
        return Domain::tile(*period, reader.number<int>("resolution").value_or(0));
    }
    const auto size = reader.pair<double>("size");
    if (!size) return std::nullopt;
    const std::string* wraps = reader.text("wraps");
    return Domain{.origin = reader.pair<double>("origin").value_or(std::array{0.0, 0.0}),
                  .size = *size,
                  .samples = reader.pair<int>("samples").value_or(std::array{0, 0}),
                  .wraps = wraps != nullptr && *wraps == "yes"};
}

}  // namespace

std::string subject_kind(std::span<const HeaderString> strings) {
    const std::string no_path;
    const StringReader reader(strings, no_path);
    if (const std::string* kind = reader.text("subject")) return *kind;
    for (const std::string_view kind : kFirstKinds) {
        if (reader.text(kind) != nullptr) return std::string(kind);
    }
    return "";
}

std::optional<Provenance> find_provenance(std::span<const HeaderString> strings,
                                          const std::string& path) {
    const StringReader reader(strings, path);
    Provenance found;
    found.kind = subject_kind(strings);
    const std::string* text = reader.text(found.kind);
    if (found.kind.empty() || text == nullptr) return std::nullopt;
    found.text = *text;
    found.frame = reader.number<int>("frame");
    found.time = reader.number<double>("time");
    found.domain = find_domain(reader);
    if (const std::string* backend = reader.text("backend")) found.backend = *backend;
    return found;
}

std::string read_head(const std::string& path) {
    constexpr std::uintmax_t kMaxHead = std::uintmax_t{8} << 20;  // a sea with its take
    std::error_code missing;
    const std::uintmax_t size = std::filesystem::file_size(utf8_path(path), missing);
    if (missing) return {};
    std::ifstream file(utf8_path(path), std::ios::binary);
    std::string head(static_cast<std::size_t>(std::min(size, kMaxHead)), '\0');
    file.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(file.gcount()));
    return head;
}

std::string comment_lines(std::span<const HeaderString> strings, std::string_view prefix) {
    std::string lines;
    for (const HeaderString& string : strings) {
        std::string_view rest = string.text;
        for (bool more = true; more;) {
            const std::size_t end = rest.find('\n');
            more = end != std::string_view::npos && end + 1 < rest.size();
            lines += std::string(prefix) + ' ' + string.name + ' ';
            lines += rest.substr(0, end);
            lines += '\n';
            if (more) rest.remove_prefix(end + 1);
        }
    }
    return lines;
}

std::vector<HeaderString> parse_comment_lines(std::string_view text, std::string_view prefix) {
    std::vector<HeaderString> strings;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (!line.starts_with(prefix)) continue;
        line.remove_prefix(prefix.size());
        if (!line.starts_with(' ')) continue;
        line.remove_prefix(1);
        const std::size_t blank = line.find(' ');
        if (blank == std::string_view::npos) continue;
        const std::string_view name = line.substr(0, blank);
        if (strings.empty() || strings.back().name != name) {
            strings.push_back({std::string(name), ""});
        } else {
            strings.back().text += '\n';
        }
        strings.back().text += line.substr(blank + 1);
    }
    return strings;
}

}  // namespace ocean::io
