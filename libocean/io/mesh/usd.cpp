// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/internal/io/usd.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "attribute_names.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/io/output_file.hpp"
#include "ocean/internal/text.hpp"
#include "usd_crate.hpp"

namespace ocean::io {
namespace {

constexpr const char* kLabel = "userProperties:ocean";
constexpr std::string_view kLine = "-";  // the prefix of each line of the header strings

/// Returns a string literal of USD, with triple quotes if it has several lines.
std::string quoted(const std::string& text) {
    if (text.find_first_of("\"\\\n") == std::string::npos) return "\"" + text + "\"";
    std::string quoted = "\"\"\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') quoted += '\\';
        quoted += c;
    }
    return quoted + "\"\"\"";
}

/// Returns the path of a file beside the stage in USD's quotes.
std::string asset(const std::string& name) {
    const std::string mark = name.find('@') == std::string::npos ? "@" : "@@@";
    return mark + "./" + name + mark;
}

/// The extent, which each frame has: the model has the bounds of its only mesh.
constexpr std::string_view kExtent = "extent", kHint = "extentsHint", kExtentType = "float3[]";

/// The faces, which all frames share, or of which each frame has its own.
constexpr std::string_view kCounts = "faceVertexCounts", kIndices = "faceVertexIndices",
                           kFacesType = "int[]";

/// Returns the declarations of all attributes of frames.
std::string frame_attributes(const UsdSequence& sequence) {
    std::string text = "    point3f[] points\n";
    for (const std::string_view name : {kExtent, kHint}) {
        text += "    " + std::string(kExtentType) + " " + std::string(name) + "\n";
    }
    for (const std::string_view name : {kCounts, kIndices}) {
        if (!sequence.own_faces) break;
        text += "    " + std::string(kFacesType) + " " + std::string(name) + "\n";
    }
    for (const Attribute& attribute : sequence.attributes) {
        const UsdName usd = usd_name(attribute);
        text += "    " + usd.type + " " + usd.name + "\n";
    }
    return text;
}

/// Returns the declarations of interpolations, and of the attributes that the schema of a mesh
/// lacks.
std::string stage_attributes(const UsdSequence& sequence) {
    std::string text = "    " + std::string(kExtentType) + " " + std::string(kHint) + "\n";
    std::vector<Attribute> attributes = {{.name = std::string(kUv), .components = 2}};
    attributes.insert(attributes.end(), sequence.attributes.begin(), sequence.attributes.end());
    for (const Attribute& attribute : attributes) {
        const UsdName usd = usd_name(attribute);
        if (!usd.interpolated) continue;
        text +=
            "    " + usd.type + " " + usd.name + " (\n        interpolation = \"vertex\"\n    )\n";
    }
    return text;
}

/// Returns the minimal and the maximal x, y, z.
std::array<float, 6> bounds(std::span<const float> positions) {
    std::array<float, 6> box{};
    for (std::size_t axis = 0; axis < 3 && !positions.empty(); ++axis) {
        box[axis] = box[3 + axis] = positions[axis];
    }
    for (std::size_t at = 0; at < positions.size(); at += 3) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            box[axis] = std::min(box[axis], positions[at + axis]);
            box[3 + axis] = std::max(box[3 + axis], positions[at + axis]);
        }
    }
    return box;
}

/// Returns "sea.####.usdc" with the number of a frame.
std::string frame_name(const std::string& name, int frame) {
    const std::size_t first = name.find('#');
    const std::size_t end = name.find_first_not_of('#', first);
    return name.substr(0, first) + format_text("%0*d", static_cast<int>(end - first), frame) +
           name.substr(end);
}

/// Returns the clips of the frames. Frames with even steps are a template, with which a reader
/// opens any file whose name fits; other frames are listed one by one.
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

/// Faces of equal numbers of corners, and the uv of their vertices or null.
struct Topology {
    std::span<const int> indices;
    int corners;
    const Attribute* uv;
};

/// Writes a crate of faces, marked by a number of samples or vertices.
void write_topology(const Topology& topology, int mark, const SubjectWords& words,
                    const std::string& path) {
    const std::size_t faces = topology.indices.size() / static_cast<std::size_t>(topology.corners);
    OutputFile file(path);
    UsdCrate crate(file, words.prim, "Mesh");
    crate.add_default(std::string(kCounts), std::string(kFacesType),
                      crate.integers(std::vector<int>(faces, topology.corners)));
    crate.add_default(std::string(kIndices), std::string(kFacesType),
                      crate.integers(topology.indices));
    crate.add_uniform("subdivisionScheme", "token", crate.token("none"));
    if (topology.uv != nullptr) {
        crate.add_default(usd_name(*topology.uv).name, usd_name(*topology.uv).type,
                          crate.floats(topology.uv->values, topology.uv->components));
    }
    const HeaderString strings[] = {{"ocean:resolution", std::to_string(mark)}};
    crate.add_default(kLabel, "string", crate.string(comment_lines(strings, kLine)));
    crate.finish();
    file.commit();
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
    const std::string& prim = sequence.words.prim;
    text += "    }\n    defaultPrim = \"" + prim + "\"\n";
    const auto set = [&](const std::string& name, const std::string& value) {
        text += "    " + name + " = " + value + "\n";
    };
    set("metersPerUnit", "1");
    set("upAxis", sequence.y_up ? "\"Y\"" : "\"Z\"");
    set("startTimeCode", std::to_string(sequence.numbers.front()));
    set("endTimeCode", std::to_string(sequence.numbers.back()));
    set("timeCodesPerSecond", shortest_text(sequence.rate));
    set("framesPerSecond", shortest_text(sequence.rate));
    text += ")\ndef Mesh \"" + prim +
            "\" (\n    prepend apiSchemas = [\"GeomModelAPI\"]\n    kind = \"component\"\n"
            "    prepend references = " +
            asset(sequence.topology) + "</" + prim +
            ">\n    clips = {\n        dictionary default = {\n";
    const auto clip = [&](const std::string& name, const std::string& value) {
        text += "            " + name + " = " + value + "\n";
    };
    clip("asset manifestAssetPath", asset(sequence.manifest));
    clip("string primPath", "\"/" + prim + "\"");
    for (const auto& [name, value] : clip_names(sequence)) clip(name, value);
    return text + "        }\n    }\n)\n{\n" + stage_attributes(sequence) + "}\n";
}

std::string usd_clip_manifest(const UsdSequence& sequence) {
    const SubjectWords& words = sequence.words;
    return "#usda 1.0\n(\n    doc = \"What the frames of " + words.noun +
           " by libocean have\"\n    defaultPrim = \"" + words.prim + "\"\n)\nover \"" +
           words.prim + "\"\n{\n" + frame_attributes(sequence) + "}\n";
}

void write_usd_frame(const Mesh& mesh, std::span<const HeaderString> strings, double time_code,
                     const std::string& path) {
    OutputFile file(path);
    UsdCrate crate(file, subject_words(strings).prim, "Mesh");
    const auto add = [&](const UsdName& usd, UsdCrate::Value value) {
        crate.add_sample(usd.name, usd.type, time_code, value);
    };
    add({"points", "point3f[]"}, crate.floats(mesh.positions, 3));
    const UsdCrate::Value box = crate.floats(bounds(mesh.positions), 3);
    for (const std::string_view name : {kExtent, kHint}) {
        add({std::string(name), std::string(kExtentType)}, box);
    }
    if (!mesh.triangles.empty()) {
        const std::vector<int> counts(mesh.triangles.size() / 3, 3);
        add({std::string(kCounts), std::string(kFacesType)}, crate.integers(counts));
        add({std::string(kIndices), std::string(kFacesType)}, crate.integers(mesh.triangles));
    }
    if (!mesh.normals.empty()) add(usd_name(normal_attribute()), crate.floats(mesh.normals, 3));
    for (const Attribute& attribute : mesh.attributes) {
        add(usd_name(attribute), crate.floats(attribute.values, attribute.components));
    }
    crate.add_default(kLabel, "string", crate.string(comment_lines(strings, kLine)));
    crate.finish();
    file.commit();
}

void write_usd_topology(const Domain& domain, const SubjectWords& words, const std::string& path) {
    constexpr int kCorners = 4;
    const auto [width, rows] = patch_vertices(domain);
    const auto faces = static_cast<std::size_t>(width - 1) * static_cast<std::size_t>(rows - 1);
    std::vector<int> indices;
    indices.reserve(kCorners * faces);
    for (int j = 0; j + 1 < rows; ++j) {
        for (int i = 0; i + 1 < width; ++i) {
            const int a = j * width + i;
            for (const int corner : {a, a + 1, a + width + 1, a + width}) indices.push_back(corner);
        }
    }
    const Attribute uv{std::string(kUv), 2, patch_uv(domain)};
    write_topology({indices, kCorners, &uv}, domain.samples[0], words, path);
}

void write_usd_topology(const Mesh& mesh, const SubjectWords& words, const std::string& path) {
    constexpr int kCorners = 3;
    const auto vertices = static_cast<int>(mesh.vertices());
    write_topology({mesh.triangles, kCorners, mesh.find(kUv)}, vertices, words, path);
}

std::vector<HeaderString> read_usd_header(const std::string& path) {
    std::vector<HeaderString> strings = parse_comment_lines(read_usd_string(path), kLine);
    if (!strings.empty() && strings.front().name.starts_with("ocean:")) return strings;
    throw Error(ErrorKind::bad_file,
                path + ": has no subject; only files that `ocean bake` wrote have one");
}

}  // namespace ocean::io
