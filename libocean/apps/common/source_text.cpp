// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See source_text.hpp.
#include "source_text.hpp"

#include <algorithm>

#include "ocean/channel.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/io/read_provenance.hpp"
#include "ocean/internal/io/subject_words.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/seafile.hpp"
#include "standard_input.hpp"

namespace ocean::app {
namespace {

/// Throws Error for the file of an elevation model, from which a terrain can be fitted.
void refuse_elevation_model(const std::string& source, std::string_view kind) {
    constexpr std::string_view kExtensions[] = {".asc", ".flt", ".hdr", ".hgt"};
    const std::string extension = text::to_utf8(utf8_path(source).extension());
    if (std::ranges::find(kExtensions, extension) == std::end(kExtensions)) return;
    throw Error(ErrorKind::bad_file, source + ": is an elevation model, not " +
                                         io::subject_words(kind).noun + "; `ocean terrain fit " +
                                         source + " -o land.toml` makes a terrain with its " +
                                         "spectrum");
}

}  // namespace

SourceText read_source_text(const std::string& source, std::string_view kind) {
    if (source == kStandardInput) {
        return {read_standard_input(kMaxSeaFileBytes), "standard input", ""};
    }
    if (text::is_pipe_or_device(source)) {
        // The first bytes of a pipe cannot be read twice.
        return {text::read_file_or_pipe(source, kMaxSeaFileBytes), source, ""};
    }
    const auto provenance = io::read_provenance(source);
    if (!provenance) {
        refuse_elevation_model(source, kind);
        return {text::read_file(source, kMaxSeaFileBytes), source,
                text::to_utf8(utf8_path(source).parent_path())};
    }
    if (provenance->kind != kind) {
        throw Error(ErrorKind::bad_file,
                    source + ": shows a " + text::printable(provenance->kind) + " instead of " +
                        io::subject_words(kind).noun +
                        (provenance->kind == kTerrainKind ? kTerrainHint : ""));
    }
    return {provenance->text, source, ""};
}

}  // namespace ocean::app
