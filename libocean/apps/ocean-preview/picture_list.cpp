// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "picture_list.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <vector>

#include "command.hpp"
#include "command_parser.hpp"
#include "ocean/bake/plan.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/io/png.hpp"
#include "ocean/internal/nearest_name.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/internal/preview/canvas.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/io/exr.hpp"

namespace ocean::app {
namespace {

/// rgba: row after row, the bottom row first.
void write_light(const std::string& path, int width, int height, const std::vector<float>& rgba) {
    io::Image image;
    image.width = width;
    image.height = height;
    std::array<std::vector<float>, 3> channels;
    for (std::size_t c = 0; c < channels.size(); ++c) {
        channels[c].reserve(rgba.size() / 4);
        for (std::size_t i = c; i < rgba.size(); i += 4) channels[c].push_back(rgba[i]);
        image.planes.push_back({.name = std::string(1, "RGB"[c]), .samples = channels[c]});
    }
    io::write_exr(image, path, io::ExrCompression::zip);
}

constexpr std::size_t kMaxPicturesBytes = std::size_t{16} << 20;

std::vector<std::string> words_of(std::string_view line) {
    constexpr std::string_view kBlanks = " \t\r";
    std::vector<std::string> words;
    for (std::size_t at = 0; (at = line.find_first_not_of(kBlanks, at)) != line.npos;) {
        if (line[at] == '#') break;
        std::string word;
        bool quoted = false;
        for (; at < line.size() && (quoted || kBlanks.find(line[at]) == kBlanks.npos); ++at) {
            if (line[at] == '"') {
                quoted = !quoted;
            } else {
                word += line[at];
            }
        }
        if (quoted) throw Error(ErrorKind::bad_file, "a \" has no other end");
        words.push_back(std::move(word));
    }
    return words;
}

/// Returns whether an option belongs to one picture, and not to the sea or the whole run.
bool is_of_a_picture(const OptionGroup& group, const Option& option) {
    constexpr std::array kGroups{"When", "Camera", "Light", "Picture"};
    constexpr std::array kOthers{"--offscreen", "--record", "--frames", "--pictures", "--probe"};
    return std::ranges::count(kGroups, group.name) != 0 &&
           std::ranges::count(kOthers, option.names) == 0;
}

/// Clears the options of all pictures that an option of a line excludes.
void clear_excluded(const std::string& name, PreviewWords& words) {
    if (name == "--time") words.frame.reset();
    if (name == "--frame") words.time.reset();
    if (name == "--look-at") words.heading.reset(), words.pitch.reset();
    if (name == "--heading" || name == "--pitch") words.look_at.clear();
    if (name == "--environment") words.sun.clear();
    if (name == "--sun") words.environment.clear(), words.environment_turn.reset();
}

const Option& option_of(const std::vector<OptionGroup>& groups, const std::string& name) {
    std::vector<std::string_view> names;
    for (const OptionGroup& group : groups) {
        for (const Option& option : group.options) {
            if (!is_of_a_picture(group, option)) continue;
            if (option.names == name) return option;
            names.push_back(option.names);
        }
    }
    refuse("'" + name + "' is no option of one picture" + did_you_mean(name, names) +
           "; allowed are those of when, camera, light and "
           "picture");
}

/// "--heading 90", "--heading=90", "--wireframe".
std::vector<GivenOption> given_options(const std::vector<std::string>& line,
                                       const std::vector<OptionGroup>& groups) {
    std::vector<GivenOption> given;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const std::size_t equals = line[i].find('=');
        const Option& option = option_of(groups, line[i].substr(0, equals));
        std::string value;
        if (takes(option) == Takes::nothing) {
            // A flag has no value.
        } else if (equals != std::string::npos) {
            value = line[i].substr(equals + 1);
        } else if (++i < line.size()) {
            value = line[i];
        } else {
            refuse(option.names + " has no value");
        }
        given.push_back({&option, std::move(value)});
    }
    return given;
}

ListedPicture picture_of(const std::vector<std::string>& line, PreviewWords words,
                         EnvironmentFiles& environments) {
    require_picture_name(line[0], "a line begins with the file of its picture");
    words.offscreen = line[0];
    const std::vector<OptionGroup> groups = preview_option_groups(words);
    const std::vector<GivenOption> given = given_options(line, groups);
    for (const auto& [option, value] : given) clear_excluded(option->names, words);
    RunOptions of_no_picture;
    for (const auto& [option, value] : given) assign(*option, value, of_no_picture);
    if (words.time && words.frame) {
        refuse("--frame excludes --time");
    }
    return {words.offscreen, preview_options(words, given, environments)};
}

}  // namespace

void require_picture_name(const std::string& path, const std::string& option) {
    const std::string extension = OutputPattern(path).extension();
    if (extension == ".png" || extension == ".exr") return;
    refuse(option + ": '" + path + "' does not end in .png or .exr");
}

void require_picture_folder(const std::string& path) {
    const std::filesystem::path folder = utf8_path(path).parent_path();
    std::error_code unreadable;
    if (folder.empty() || std::filesystem::is_directory(folder, unreadable)) return;
    throw Error(ErrorKind::output,
                "cannot write '" + path + "': there is no folder " + text::to_utf8(folder));
}

void write_picture(const std::string& path, preview::Renderer& renderer, const Scene& scene,
                   const preview::Camera& camera, const preview::Look& look,
                   preview::DrawOptions options, int samples) {
    options.linear = OutputPattern(path).extension() == ".exr";
    const preview::Canvas canvas(options.width, options.height,
                                 options.linear ? GL_RGBA32F : GL_RGBA8, samples);
    if (scene.is_finer_than_pixels()) options.shaded_samples = canvas.samples();
    scene.draw(renderer, camera, look, options);
    if (options.linear) {
        write_light(path, options.width, options.height, canvas.rgba());
    } else {
        io::write_png(path, options.width, options.height, canvas.rgb());
    }
}

std::vector<ListedPicture> read_picture_list(const std::string& file, const PreviewWords& words) {
    std::vector<ListedPicture> pictures;
    EnvironmentFiles environments;
    std::size_t number = 0;
    for (const std::string& line : split(text::read_file_or_pipe(file, kMaxPicturesBytes), '\n')) {
        ++number;
        try {
            const std::vector<std::string> of_line = words_of(line);
            if (!of_line.empty()) pictures.push_back(picture_of(of_line, words, environments));
        } catch (const Error& error) {
            throw text::error_at(error.kind(), file, number, error.what());
        }
    }
    if (pictures.empty()) throw Error(ErrorKind::bad_file, file + ": names no picture");
    return pictures;
}

}  // namespace ocean::app
