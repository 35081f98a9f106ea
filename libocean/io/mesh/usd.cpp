// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/io/usd.hpp"

#include <utility>

#include "ocean/error.hpp"
#include "ocean/io/output_file.hpp"
#include "ocean/text.hpp"
#include "usd_crate.hpp"

namespace ocean::io {
namespace {

constexpr const char* kPrim = "Ocean";
constexpr const char* kLabel = "userProperties:ocean";
constexpr std::string_view kLine = "-";  // what each line of the label begins with

/// As text of USD, on several lines if need be.
std::string quoted(const std::string& text) {
    if (text.find_first_of("\"\\\n") == std::string::npos) return "\"" + text + "\"";
    std::string quoted = "\"\"\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') quoted += '\\';
        quoted += c;
    }
    return quoted + "\"\"\"";
}

/// As USD quotes the path of a file beside it.
std::string asset(const std::string& name) {
    const std::string mark = name.find('@') == std::string::npos ? "@" : "@@@";
    return mark + "./" + name + mark;
}

std::string attributes(const UsdSequence& sequence) {
    std::string text = "    point3f[] points\n";
    if (sequence.normals) text += "    normal3f[] normals\n";
    if (sequence.velocities) text += "    vector3f[] velocities\n";
    if (sequence.foam) text += "    float[] primvars:foam\n";
    return text;
}

std::string of_each_vertex(const std::string& attribute) {
    return "    " + attribute + " (\n        interpolation = \"vertex\"\n    )\n";
}

/// "sea.####.usdc" of one frame.
std::string frame_name(const std::string& name, int frame) {
    const std::size_t first = name.find('#');
    const std::size_t end = name.find_first_not_of('#', first);
    return name.substr(0, first) + format_text("%0*d", static_cast<int>(end - first), frame) +
           name.substr(end);
}

/// Names the clips of frames, by a template where their steps are even: a reader then takes any
/// file whose name fits. Else each by its name, so that it takes no other.
std::vector<std::pair<std::string, std::string>> clip_names(const UsdSequence& sequence) {
    if (const std::optional<int> step = even_step(sequence.numbers)) {
        return {{"string templateAssetPath", quoted("./" + sequence.frames)},
                {"double templateStartTime", std::to_string(sequence.numbers.front())},
                {"double templateEndTime", std::to_string(sequence.numbers.back())},
                {"double templateStride", std::to_string(*step)}};
    }
    std::string paths, active, times;
    for (std::size_t i = 0; i < sequence.numbers.size(); ++i) {
        const std::string number = std::to_string(sequence.numbers[i]);
        const char* separator = i == 0 ? "" : ", ";
        paths += separator + asset(frame_name(sequence.frames, sequence.numbers[i]));
        active += separator + ("(" + number + ", " + std::to_string(i) + ")");
        times += separator + ("(" + number + ", " + number + ")");
    }
    return {{"asset[] assetPaths", "[" + paths + "]"},
            {"double2[] active", "[" + active + "]"},
            {"double2[] times", "[" + times + "]"}};
}

}  // namespace

std::optional<int> even_step(std::span<const int> frames) {
    if (frames.size() < 2) return 1;
    const int step = frames[1] - frames[0];
    for (std::size_t i = 1; i < frames.size(); ++i) {
        if (frames[i] - frames[i - 1] != step) return std::nullopt;
    }
    return step > 0 ? std::optional(step) : std::nullopt;
}

std::string usd_stage(const UsdSequence& sequence, std::span<const HeaderString> strings) {
    std::string text = "#usda 1.0\n(\n    customLayerData = {\n";
    for (const HeaderString& string : strings) {
        text += "        string \"" + string.name + "\" = " + quoted(string.text) + "\n";
    }
    text += "    }\n    defaultPrim = \"" + std::string(kPrim) + "\"\n";
    const auto set = [&](const std::string& name, const std::string& value) {
        text += "    " + name + " = " + value + "\n";
    };
    set("metersPerUnit", "1");
    set("upAxis", sequence.y_up ? "\"Y\"" : "\"Z\"");
    set("startTimeCode", std::to_string(sequence.numbers.front()));
    set("endTimeCode", std::to_string(sequence.numbers.back()));
    set("timeCodesPerSecond", shortest_text(sequence.rate));
    set("framesPerSecond", shortest_text(sequence.rate));
    text += ")\ndef Mesh \"" + std::string(kPrim) +
            "\" (\n    prepend references = " + asset(sequence.topology) + "</" + kPrim +
            ">\n    clips = {\n        dictionary default = {\n";
    const auto clip = [&](const std::string& name, const std::string& value) {
        text += "            " + name + " = " + value + "\n";
    };
    clip("asset manifestAssetPath", asset(sequence.manifest));
    clip("string primPath", "\"/" + std::string(kPrim) + "\"");
    for (const auto& [name, value] : clip_names(sequence)) clip(name, value);
    text += "        }\n    }\n)\n{\n";
    if (sequence.foam) text += of_each_vertex("float[] primvars:foam");
    if (sequence.normals) text += of_each_vertex("normal3f[] normals");
    return text + "}\n";
}

std::string usd_clip_manifest(const UsdSequence& sequence) {
    return "#usda 1.0\n(\n    doc = \"What the frames of a sea by libocean have\"\n    defaultPrim "
           "= \"" +
           std::string(kPrim) + "\"\n)\nover \"" + kPrim + "\"\n{\n" + attributes(sequence) + "}\n";
}

void write_usd_frame(const Mesh& mesh, std::span<const HeaderString> strings, double time_code,
                     const std::string& path) {
    OutputFile file(path);
    UsdCrate crate(file, kPrim, "Mesh");
    const auto add = [&](const char* name, const char* type, UsdCrate::Value value) {
        crate.add_sample(name, type, time_code, value);
    };
    add("points", "point3f[]", crate.vectors(mesh.positions));
    if (!mesh.normals.empty()) add("normals", "normal3f[]", crate.vectors(mesh.normals));
    if (!mesh.velocities.empty()) add("velocities", "vector3f[]", crate.vectors(mesh.velocities));
    if (!mesh.foam.empty()) add("primvars:foam", "float[]", crate.floats(mesh.foam));
    crate.add_default(kLabel, "string", crate.string(comment_lines(strings, kLine)));
    crate.finish();
    file.commit();
}

void write_usd_topology(int resolution, const std::string& path) {
    constexpr int kCorners = 4;
    const auto n = static_cast<std::size_t>(resolution);
    std::vector<int> indices;
    indices.reserve(kCorners * n * n);
    const int width = resolution + 1;
    for (int j = 0; j < resolution; ++j) {
        for (int i = 0; i < resolution; ++i) {
            const int a = j * width + i;
            for (const int corner : {a, a + 1, a + width + 1, a + width}) indices.push_back(corner);
        }
    }
    OutputFile file(path);
    UsdCrate crate(file, kPrim, "Mesh");
    crate.add_default("faceVertexCounts", "int[]",
                      crate.integers(std::vector<int>(n * n, kCorners)));
    crate.add_default("faceVertexIndices", "int[]", crate.integers(indices));
    crate.add_uniform("subdivisionScheme", "token", crate.token("none"));
    const HeaderString mark[] = {{"ocean:resolution", std::to_string(resolution)}};
    crate.add_default(kLabel, "string", crate.string(comment_lines(mark, kLine)));
    crate.finish();
    file.commit();
}

std::vector<HeaderString> read_usd_header(const std::string& path) {
    std::vector<HeaderString> strings = parse_comment_lines(read_usd_string(path), kLine);
    if (!strings.empty() && strings.front().name.starts_with("ocean:")) return strings;
    throw Error(ErrorKind::bad_file, path + ": says no sea; only files that `ocean bake` wrote do");
}

}  // namespace ocean::io
