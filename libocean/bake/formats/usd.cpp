// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A USD stage of text, sea.usda. Beside it lie a crate file for each frame, sea.0001.usdc, a crate
// file with the faces, sea.topology.usdc, and the manifest of the frames' attributes,
// sea.clips.usda.
#include "ocean/internal/io/usd.hpp"

#include <algorithm>
#include <array>

#include "formats/formats.hpp"
#include "formats/plain_mesh.hpp"
#include "ocean/bake/typed_format.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/io/output_file.hpp"
#include "ocean/internal/text.hpp"
#include "refuse.hpp"

namespace ocean {
namespace {

constexpr std::string_view kUsdProducts = "normal,foam,velocity";
constexpr bool kUsdAll = true;
constexpr std::string_view kStageEnding = ".usda";
constexpr std::string_view kFrameEnding = ".usdc";

enum Shared : std::size_t { kStage, kClips, kTopology };

std::vector<FormatOption> list_options(const Catalogue&) {
    return plain_mesh_options(kUsdProducts, kUsdAll);
}

std::optional<ProductChoice> product_choice(const Catalogue& catalogue) {
    return plain_mesh_products(catalogue, kUsdProducts, kUsdAll);
}

PlainMesh read_options(const BakeOptions& options, const Catalogue& catalogue) {
    return read_plain_mesh(options, choose_products(options, *product_choice(catalogue)));
}

/// Throws Error invalid_value unless the frames are FIRST-LASTxSTEP.
void require_even_steps(const std::vector<int>& frames) {
    if (io::even_step(frames)) return;
    refuse(
        "a USD stage has frames at even steps: allowed is --frames FIRST-LAST or "
        "FIRST-LASTxSTEP");
}

std::string file_name(const std::string& path) {
    return path.substr(path.rfind('/') + 1);
}

/// Returns "out/sea" for "out/sea.####.usda".
std::string stem_of(const BakePlan& plan) {
    const std::string path = plan.pattern.manifest(), name = plan.pattern.stem();
    return path.substr(0, path.rfind('/') + 1) + (name.empty() ? "sea" : name);
}

FormatPlan<PlainMesh> resolve(const BakePlan& draft, const PlainMesh& requested) {
    require_even_steps(draft.all_frames);
    if (draft.all_frames.front() < 0) {
        refuse(
            "a USD stage names its frames by ####, which has no sign: allowed are frames "
            "from 0 on");
    }
    if (file_name(stem_of(draft)).find('\\') != std::string::npos) {
        refuse("a USD stage reads '\\' in a name as a folder: allowed are names without it");
    }
    if (file_name(stem_of(draft)).find("@@@") != std::string::npos) {
        refuse("a USD stage ends a name at '@@@': allowed are names without it");
    }
    return resolve_plain_mesh(draft, requested);
}

std::string with_ending(const std::string& path, std::string_view ending) {
    return path.substr(0, path.rfind('.')) + std::string(ending);
}

std::string frame_path(const BakePlan& plan, int frame) {
    return with_ending(plan.pattern.with_token().file(frame), kFrameEnding);
}

std::vector<BakeFile> list_files(const BakePlan& plan, const PlainMesh&, int frame) {
    return {{frame_path(plan, frame), frame, 0, "mesh"}};
}

std::vector<BakeFile> list_shared(const BakePlan& plan, const PlainMesh&) {
    const int first = plan.all_frames.front();
    const std::string stem = stem_of(plan);
    return {{stem + std::string(kStageEnding), first, kStage, "stage"},
            {stem + ".clips" + std::string(kStageEnding), first, kClips, "clips"},
            {stem + ".topology" + std::string(kFrameEnding), first, kTopology, "topology"}};
}

bool is_shared(const BakeFile& file) {
    return file.product != "mesh";
}

/// Returns the name of a frame with # in place of its digits.
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

io::UsdSequence sequence_of(const BakePlan& plan, const PlainMesh& mesh) {
    std::vector<io::Attribute> attributes;
    for (const Product* product : mesh.products) {
        attributes.push_back({std::string(product->name), product->count, {}, product->vector});
    }
    const std::vector<BakeFile> shared = list_shared(plan, mesh);
    return {.topology = file_name(shared[kTopology].path),
            .manifest = file_name(shared[kClips].path),
            .frames = frame_template(plan),
            .numbers = plan.all_frames,
            .rate = plan.subject->timeline().frame_rate,
            .y_up = mesh.axes == io::Axes::yup,
            .attributes = attributes,
            .own_faces = mesh.cut,
            .words = words_of(plan)};
}

std::string shared_text(const BakePlan& plan, const PlainMesh& mesh, const BakeFile& file) {
    const io::UsdSequence sequence = sequence_of(plan, mesh);
    if (file.part == kClips) return io::usd_clip_manifest(sequence);
    return io::usd_stage(sequence, plain_mesh_strings(plan, mesh, plan.all_frames.front()));
}

void write_shared(const BakePlan& plan, const PlainMesh& mesh, const BakeFile& file) {
    if (file.part == kTopology && mesh.lod) {
        const auto maps = plan.subject->open(plan.maps_options());
        return io::write_usd_topology(
            make_land_lod_mesh(*maps, *mesh.lod, {}, io::Faces::triangles), words_of(plan),
            file.path);
    }
    if (file.part == kTopology) {
        return io::write_usd_topology(plan.domain(), words_of(plan), file.path);
    }
    io::write_file_atomically(file.path, shared_text(plan, mesh, file));
}

std::string recipe(const BakePlan& plan, const PlainMesh& mesh, const BakeFile& file) {
    if (!is_shared(file)) return plain_mesh_recipe(plan, mesh, file);
    const std::string text =
        file.part == kTopology && !mesh.lod ? "st\n" : shared_text(plan, mesh, file);
    return bake_recipe(plan, file.frame, file.product + "\n" + text);
}

/// Compares the subject, its samples, the axes and the products, but not the time, the backend or
/// the version.
bool matches_plan(const BakePlan& plan, const PlainMesh& mesh, const BakeFile& file) {
    const auto found = header_or_none(io::read_usd_header, file.path);
    const auto text_of = [](const std::vector<io::HeaderString>& strings, std::string_view name) {
        const auto string = std::ranges::find(strings, name, &io::HeaderString::name);
        return string == strings.end() ? std::string() : string->text;
    };
    // A file holds its strings as comment lines.
    const std::vector<io::HeaderString> wanted = io::parse_comment_lines(
        io::comment_lines(plain_mesh_strings(plan, mesh, file.frame), "-"), "-");
    return std::ranges::all_of(
        std::array{"ocean:" + std::string(plan.subject->kind()), std::string("ocean:frame"),
                   std::string("ocean:resolution"), std::string("ocean:axes"),
                   std::string("ocean:field"), std::string("ocean:cut_hulls")},
        [&](std::string_view name) { return text_of(found, name) == text_of(wanted, name); });
}

bool is_baked(const BakeFile& file) {
    if (!is_shared(file) || file.part == kTopology) {
        return !header_or_none(io::read_usd_header, file.path).empty();
    }
    const std::string head = text::first_bytes(file.path, 400);
    const char* mark = file.part == kStage ? "string \"ocean:" : "by libocean";
    return head.starts_with("#usda") && head.find(mark) != std::string::npos;
}

/// Returns an upper bound of the bytes of the counts and corners of a frame's own faces.
std::uint64_t own_faces_bytes(const BakePlan& plan, const PlainMesh& mesh) {
    return mesh.cut ? plain_mesh_triangles(plan, mesh) * 4 * sizeof(int) : 0;
}

std::uint64_t frame_bytes(const BakePlan& plan, const PlainMesh& mesh) {
    return plain_mesh_vertex_bytes(plan, mesh) + own_faces_bytes(plan, mesh) +
           (mesh.lod ? mesh.lod->work_bytes : 0);
}

std::uint64_t max_bytes(const BakePlan& plan, const PlainMesh& mesh, const BakeFile& file) {
    const std::uint64_t comments = 2 * plan.subject_text.size() + 4096;
    const std::uint64_t faces = plain_mesh_triangles(plan, mesh) / (mesh.lod ? 1 : 2);
    if (file.part == kTopology && is_shared(file)) {
        return comments + faces * 5 * sizeof(int) + plain_mesh_uv_bytes(plan, mesh);
    }
    // The stage may hold a name and two pairs of numbers for each frame.
    if (is_shared(file)) return comments + plan.all_frames.size() * (2 * file.path.size() + 64);
    return comments + plain_mesh_vertex_bytes(plan, mesh) + own_faces_bytes(plan, mesh);
}

void write(const FrameWork& work, const PlainMesh& settings, std::span<const BakeFile> files) {
    const io::Mesh mesh = make_plain_mesh(work, settings, io::Faces::none);
    const auto strings = plain_mesh_strings(work.plan, settings, work.frame);
    work.write_and_verify(
        files.front(), [&] { io::write_usd_frame(mesh, strings, work.frame, files.front().path); });
}

constexpr BakeFormatOf<PlainMesh> kOf = {
    .name = "usda",
    .extension = kStageEnding,
    .frame_extension = kFrameEnding,
    .label = "USD",
    .family = "USD stages",
    .summary = "USD stages: an animated mesh of a period",
    .example = "--products normal,foam",
    .options = list_options,
    .product_choice = product_choice,
    .read_options = read_options,
    .resolve = resolve,
    .files = list_files,
    .shared =
        SharedFilesOf<PlainMesh>{
            .list = list_shared,
            .write = write_shared,
            .frame_lists =
                FrameListsOf<PlainMesh>{
                    .count = 1, .matches_plan = matches_plan, .interpolates_missing_frames = true}},
    .recipe = recipe,
    .is_baked = is_baked,
    .frame_bytes = frame_bytes,
    .max_bytes = max_bytes,
    .write = write,
    .read_header = io::read_usd_header,
    .adopt = adopt_plain_mesh,
};

}  // namespace

const BakeFormat kUsdFormat = bake_format<kOf>();

}  // namespace ocean
