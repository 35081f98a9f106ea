// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "window/opened_file.hpp"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/io/panorama.hpp"
#include "ocean/internal/io/read_provenance.hpp"
#include "ocean/internal/line_reader.hpp"
#include "ocean/internal/platform.hpp"
#include "scene_argument.hpp"

namespace ocean::app {
namespace {

constexpr std::string_view kExrMagic = "\x76\x2f\x31\x01";
constexpr std::size_t kHeadBytes = 4096;
constexpr const char* kKinds = "a window opens seas, terrains, takes, baked files and skies (.exr)";

/// Returns true if the first line that is no comment begins with a number, as each line of a take.
bool looks_like_a_take(std::string_view head) {
    while (!head.empty()) {
        std::string_view line = head.substr(0, head.find('\n'));
        head.remove_prefix(std::min(head.size(), line.size() + 1));
        line = line.substr(0, line.find('#'));
        const std::string_view first = next_word(line);
        if (!first.empty()) return text::parse_number(first) && !next_word(line).empty();
    }
    return false;
}

/// Returns true if the bytes are no text: a picture, an archive, a program.
bool is_binary(std::string_view head) {
    return head.find('\0') != std::string_view::npos;
}

OpenedFile read_exr(const std::string& path) {
    std::optional<io::Panorama> sphere;
    try {
        if (io::read_provenance(path)) return {.scene = open_scene({path, {}})};
    } catch (const Error& no_sea) {
        try {
            sphere = io::read_exr_panorama(path);
        } catch (const Error& no_sky) {
            throw Error(ErrorKind::bad_file,
                        std::string(no_sea.what()) + "; nor is it a sky: " + no_sky.what());
        }
    }
    if (!sphere) throw Error(ErrorKind::bad_file, path + ": " + kKinds);
    return {.sky = std::make_shared<const preview::Environment>(
                preview::make_environment(sphere->width, sphere->height, sphere->rgb))};
}

}  // namespace

OpenedFile read_opened_file(const std::string& path, const Subject& shown) {
    std::error_code error;
    if (std::filesystem::is_directory(utf8_path(path), error)) {
        throw Error(ErrorKind::bad_file, path + ": is a folder; " + kKinds);
    }
    if (text::is_pipe_or_device(path)) {
        throw Error(ErrorKind::bad_file, path + ": is a pipe or a device; " + kKinds);
    }
    const std::string head = text::first_bytes(path, kHeadBytes);
    if (head.starts_with(kExrMagic)) return read_exr(path);
    if (looks_like_a_take(head)) {
        const Sea* const of = find_sea(shown);
        if (of == nullptr) {
            throw Error(ErrorKind::bad_file, path + ": is a take, and a " +
                                                 std::string(shown.kind()) +
                                                 " has none; open its sea first");
        }
        Sea sea = *of;
        sea.take = {};
        set_in_sea(sea, "time.take", path);
        const std::size_t changes = sea.take.events.size();
        return {.scene = make_subject(std::move(sea)), .take_changes = changes};
    }
    const bool is_baked = io::read_header(path).has_value();
    if (!is_baked && is_binary(head)) {
        throw Error(ErrorKind::bad_file, path + ": is none of these; " + kKinds);
    }
    return {.scene = open_scene({path, {}})};
}

}  // namespace ocean::app
