// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/internal/io/subject_words.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace ocean::io {
namespace {

struct Row {
    std::string_view kind, noun, prim;
};
constexpr std::array kRows = {
    Row{kSeaKind, "a sea", "Ocean"},
    Row{kTerrainKind, "a terrain", "Terrain"},
};

/// Returns "Foam_texture" for "foam_texture": names in hosts have letters, digits and '_' only.
std::string capitalised(std::string_view kind) {
    std::string name(kind);
    for (char& c : name) {
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
    }
    name.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
    return name;
}

}  // namespace

SubjectWords subject_words(std::string_view kind) {
    if (kind.empty()) kind = kSeaKind;
    const auto row = std::ranges::find(kRows, kind, &Row::kind);
    if (row != kRows.end()) {
        return {std::string(row->kind), std::string(row->noun), std::string(row->prim)};
    }
    const bool vowel = std::string_view("aeiou").find(kind.front()) != std::string_view::npos;
    return {std::string(kind), (vowel ? "an " : "a ") + std::string(kind), capitalised(kind)};
}

SubjectWords subject_words(std::span<const HeaderString> strings) {
    return subject_words(subject_kind(strings));
}

}  // namespace ocean::io
