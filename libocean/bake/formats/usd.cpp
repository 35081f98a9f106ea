// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A USD stage of text, sea.usda; beside it a crate file a frame, sea.0001.usdc, one with the faces,
// sea.topology.usdc, and what tells readers the attributes of the frames, sea.clips.usda.
#include "ocean/io/usd.hpp"

#include <algorithm>
#include <array>

#include "formats/formats.hpp"
#include "formats/plain_mesh.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/io/output_file.hpp"
#include "ocean/text.hpp"

namespace ocean {
namespace {

constexpr std::string_view kProducts = "normal,foam,velocity";
constexpr bool kAll = true;
constexpr std::string_view kStageEnding = ".usda";
constexpr std::string_view kFrameEnding = ".usdc";

enum Shared : std::size_t { kStage, kClips, kTopology };

std::vector<FormatOption> list_options(const Catalogue&) {
    return plain_mesh_options(kProducts, kAll);
}

std::any read_options(const BakeOptions& options, const Catalogue& catalogue) {
    return read_plain_mesh(
        options, choose_products(options, plain_mesh_products(catalogue, kProducts, kAll)));
}

/// Throws unless they are FIRST-LASTxSTEP.
void require_even_steps(const std::vector<int>& frames) {
    if (io::even_step(frames)) return;
    throw Error(ErrorKind::invalid_value,
                "a USD stage has frames at even steps: allowed is --frames FIRST-LAST or "
                "FIRST-LASTxSTEP");
}

std::string file_name(const std::string& path) {
    return path.substr(path.rfind('/') + 1);
}

/// "out/sea" of "out/sea.####.usda".
std::string stem_of(const BakePlan& plan) {
    constexpr std::string_view kManifest = ".manifest.json";
    const std::string path = plan.pattern.manifest();
    if (path.ends_with(kManifest)) return path.substr(0, path.size() - kManifest.size());
    return path.substr(0, path.size() - (kManifest.size() - 1)) + "sea";
}

FormatPlan settle(const BakePlan& begun) {
    require_even_steps(begun.all_frames);
    if (begun.all_frames.front() < 0) {
        throw Error(ErrorKind::invalid_value,
                    "a USD stage names its frames by ####, which has no sign: allowed are frames "
                    "from 0 on");
    }
    if (file_name(stem_of(begun)).find('\\') != std::string::npos) {
        throw Error(ErrorKind::invalid_value,
                    "a USD stage takes '\\' in a name for a folder: allowed are other names");
    }
    return settle_plain_mesh(begun);
}

std::string with_ending(const std::string& path, std::string_view ending) {
    return path.substr(0, path.rfind('.')) + std::string(ending);
}

std::string frame_path(const BakePlan& plan, int frame) {
    return with_ending(plan.pattern.with_token().file(frame), kFrameEnding);
}

std::vector<BakeFile> list_files(const BakePlan& plan, int frame) {
    return {{frame_path(plan, frame), frame, 0, "mesh"}};
}

std::vector<BakeFile> list_shared(const BakePlan& plan) {
    const int first = plan.all_frames.front();
    const std::string stem = stem_of(plan);
    return {{stem + std::string(kStageEnding), first, kStage, "stage"},
            {stem + ".clips" + std::string(kStageEnding), first, kClips, "clips"},
            {stem + ".topology" + std::string(kFrameEnding), first, kTopology, "topology"}};
}

bool is_shared(const BakeFile& file) {
    return file.product != "mesh";
}

/// The name of a frame with # in the place of its digits.
std::string frame_template(const BakePlan& plan) {
    std::string name = file_name(frame_path(plan, 0));
    const std::size_t end = name.rfind('0', name.rfind('.'));
    std::size_t start = end;
    while (start > 0 && name[start - 1] == '0') --start;
    for (std::size_t i = start; i <= end; ++i) name[i] = '#';
    return name;
}

io::SubjectWords words_of(const BakePlan& plan) {
    return io::subject_words(plan.subject->kind());
}

io::UsdSequence sequence_of(const BakePlan& plan) {
    const PlainMesh& mesh = plain_mesh_of(plan);
    std::vector<io::Attribute> attributes;
    for (const Product* product : mesh.products) {
        attributes.push_back({std::string(product->name), product->count, {}, product->vector});
    }
    const std::vector<BakeFile> shared = list_shared(plan);
    return {.topology = file_name(shared[kTopology].path),
            .manifest = file_name(shared[kClips].path),
            .frames = frame_template(plan),
            .numbers = plan.all_frames,
            .rate = plan.subject->frame_rate(),
            .y_up = mesh.axes == io::Axes::yup,
            .attributes = attributes,
            .words = words_of(plan)};
}

std::string shared_text(const BakePlan& plan, const BakeFile& file) {
    const io::UsdSequence sequence = sequence_of(plan);
    if (file.part == kClips) return io::usd_clip_manifest(sequence);
    return io::usd_stage(sequence, plain_mesh_strings(plan, plan.all_frames.front()));
}

void write_shared(const BakePlan& plan, const BakeFile& file) {
    if (file.part == kTopology) {
        return io::write_usd_topology(plan.domain(), words_of(plan), file.path);
    }
    io::write_file_atomically(file.path, shared_text(plan, file));
}

std::string recipe(const BakePlan& plan, const BakeFile& file) {
    if (!is_shared(file)) return plain_mesh_recipe(plan, file);
    const std::string text = file.part == kTopology ? "st\n" : shared_text(plan, file);
    return bake_recipe(plan, file.frame, file.product + "\n" + text);
}

/// The subject, its samples and what the mesh holds; not the time, the backend and the version.
bool is_of_plan(const BakePlan& plan, const BakeFile& file) {
    std::vector<io::HeaderString> found;
    try {
        found = io::read_usd_header(file.path);
    } catch (const Error&) {
        return false;
    }
    const auto text_of = [](const std::vector<io::HeaderString>& strings, std::string_view name) {
        const auto string = std::ranges::find(strings, name, &io::HeaderString::name);
        return string == strings.end() ? std::string() : string->text;
    };
    // A file has them by lines.
    const std::vector<io::HeaderString> wanted =
        io::parse_comment_lines(io::comment_lines(plain_mesh_strings(plan, file.frame), "-"), "-");
    return std::ranges::all_of(
        std::array{"ocean:" + std::string(plan.subject->kind()), std::string("ocean:frame"),
                   std::string("ocean:resolution"), std::string("ocean:axes"),
                   std::string("ocean:field")},
        [&](std::string_view name) { return text_of(found, name) == text_of(wanted, name); });
}

bool is_baked(const BakeFile& file) {
    if (!is_shared(file) || file.part == kTopology) {
        try {
            return !io::read_usd_header(file.path).empty();
        } catch (const Error&) {
            return false;
        }
    }
    const std::string head = text::first_bytes(file.path, 400);
    const char* mark = file.part == kStage ? "string \"ocean:" : "by libocean";
    return head.starts_with("#usda") && head.find(mark) != std::string::npos;
}

std::uint64_t most_bytes(const BakePlan& plan, const BakeFile& file) {
    // Of each frame a stage may have a name and two pairs of numbers.
    const std::uint64_t list = plan.all_frames.size() * (2 * file.path.size() + 64);
    const std::uint64_t comments = 2 * plan.subject_text.size() + 4096 + list;
    const std::uint64_t faces = plain_mesh_triangles(plan) / 2;
    if (file.part == kTopology && is_shared(file)) {
        return comments + faces * 5 * sizeof(int) + plain_mesh_uv_bytes(plan);
    }
    if (is_shared(file)) return comments;
    return comments + plain_mesh_vertex_bytes(plan);
}

void write(const FrameWork& work, std::span<const BakeFile> files) {
    const io::Mesh mesh = make_plain_mesh(work, io::Faces::none);
    const auto strings = plain_mesh_strings(work.plan, work.frame);
    work.put(files.front(),
             [&] { io::write_usd_frame(mesh, strings, work.frame, files.front().path); });
}

}  // namespace

const BakeFormat kUsdFormat = {
    .name = "usda",
    .extension = kStageEnding,
    .frame_extension = kFrameEnding,
    .family = "USD stages",
    .options = list_options,
    .read_options = read_options,
    .settle = settle,
    .files = list_files,
    .shared_files = list_shared,
    .write_shared = write_shared,
    .frame_lists = 1,
    .is_of_plan = is_of_plan,
    .hides_gaps = true,
    .recipe = recipe,
    .is_baked = is_baked,
    .frame_bytes = plain_mesh_vertex_bytes,
    .most_bytes = most_bytes,
    .write = write,
    .read_header = io::read_usd_header,
    .adopt = adopt_plain_mesh,
};

}  // namespace ocean
