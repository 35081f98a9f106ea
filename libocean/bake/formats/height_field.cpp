// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// POV-Ray's height_field: a 16-bit PNG of heights at fixed places, with the meaning of its codes
// beside it, for people (.txt) and for scenes (.inc).
#include "ocean/internal/io/height_field.hpp"
#include "formats/formats.hpp"
#include "ocean/bake/typed_format.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/io/output_file.hpp"
#include "ocean/internal/io/png.hpp"
#include "ocean/internal/io/povray_declarations.hpp"

namespace ocean {
namespace {

enum Part : std::size_t { kImage, kDescription, kDeclarations };

NoSettings read_options(const BakeOptions&, const Catalogue&) {
    return {};
}

FormatPlan<NoSettings> resolve(const BakePlan& draft, const NoSettings&) {
    return {{{Channel::height}, {draft.resolution}, is_displaced(*draft.subject)}, {}};
}

std::vector<BakeFile> list_files(const BakePlan& plan, const NoSettings&, int frame) {
    const std::string path = plan.pattern.file(frame);
    return {{path, frame, kImage, "height"},
            {path + ".txt", frame, kDescription, "height"},
            {path + ".inc", frame, kDeclarations, "height"}};
}

std::string recipe(const BakePlan& plan, const NoSettings&, const BakeFile& file) {
    return bake_recipe(plan, file.frame);
}

constexpr std::string_view kDescriptionOpening = "# height = base + scale";

bool opens_with(const std::string& path, std::string_view opening) {
    return text::first_bytes(path, opening.size()) == opening;
}

bool names_its_subject(const std::string& path) {
    return !header_or_none(io::read_png_header, path).empty();
}

/// Recognises texts with our opening, and a grey PNG of 16 bits that repeats its first row and
/// column, names its subject or has our text beside it.
bool is_baked(const BakeFile& file) {
    constexpr std::size_t kHead = 26;  // signature, length and name of IHDR, its first five values
    const std::string head = text::first_bytes(file.path, kHead);
    if (file.part == kDescription) return opens_with(file.path, kDescriptionOpening);
    if (file.part == kDeclarations) {
        const std::string line = text::first_bytes(file.path, 200);
        return line.starts_with("// height = ") && line.find("_Base + ") < line.find('\n');
    }
    if (head.size() < kHead || !head.starts_with("\x89PNG")) return false;
    const auto side_at = [&head](std::size_t i) {  // up to 65535
        return static_cast<unsigned char>(head[i + 2]) << 8 |
               static_cast<unsigned char>(head[i + 3]);
    };
    const bool grey_of_16_bits = head[24] == 16 && head[25] == 0;
    if (!grey_of_16_bits) return false;
    const bool is_square_with_seam = side_at(16) == side_at(20) && is_resolution(side_at(16) - 1);
    return is_square_with_seam || opens_with(file.path + ".txt", kDescriptionOpening) ||
           names_its_subject(file.path);
}

std::uint64_t frame_bytes(const BakePlan& plan, const NoSettings&) {
    return is_displaced(*plan.subject) ? plan.subject->costs().eulerian_heights(plan.resolution)
                                       : 0;
}

std::uint64_t max_bytes(const BakePlan& plan, const NoSettings&, const BakeFile& file) {
    constexpr std::uint64_t kSmallFile = 4096;
    if (file.part != kImage) return kSmallFile;
    const std::uint64_t pixels = io::max_height_field_bytes(plan.domain());
    if (plan.subject->kind() == kSeaKind) return pixels;
    return pixels + plan.subject_text.size() + kSmallFile;
}

void write(const FrameWork& work, const NoSettings&, std::span<const BakeFile> files) {
    const io::Image image = height_image(work);
    work.write_and_verify(files[kImage],
                          [&] { io::write_height_field(image, files[kImage].path); });
    work.write_and_verify(files[kDescription], [&] {
        io::write_file_atomically(files[kDescription].path, io::height_field_description(image));
    });
    work.write_and_verify(files[kDeclarations], [&] {
        io::write_file_atomically(files[kDeclarations].path,
                                  io::height_field_declarations(image) +
                                      io::povray_frame_declarations(work.provenance()));
    });
}

/// Returns the strings of a file whose subject is not a sea; files of seas have no strings.
std::vector<io::HeaderString> read_header(const std::string& path) {
    if (names_its_subject(path)) return io::read_png_header(path);
    throw Error(ErrorKind::bad_file, path + ": a height field of a sea does not name its sea");
}

bool read_pixels(const BakePlan&, const NoSettings&, const BakeFile& file, int,
                 const io::ByteSink& sink) {
    if (file.part != kImage) return false;
    io::read_height_field(file.path, sink);
    return true;
}

constexpr BakeFormatOf<NoSettings> kOf = {
    .name = "height_field",
    .extension = ".png",
    .label = "PNG",
    .family = "Height fields",
    .summary = "POV-Ray height fields: a grey PNG of 16 bits",
    .read_options = read_options,
    .resolve = resolve,
    .files = list_files,
    .recipe = recipe,
    .is_baked = is_baked,
    .frame_bytes = frame_bytes,
    .max_bytes = max_bytes,
    .write = write,
    .read_pixels = read_pixels,
    .read_header = read_header,
};

}  // namespace

std::vector<io::HeaderString> header_or_none(
    std::vector<io::HeaderString> (*read)(const std::string& path), const std::string& path) {
    try {
        return read(path);
    } catch (const Error&) {
        return {};
    }
}

io::Image height_image(const FrameWork& work) {
    const Product* const heights[] = {&find_product("height")};
    io::Image image = io::product_image(heights, {}, work.provenance(), work.maps.front());
    image.strings.push_back({"ocean:resolution", std::to_string(work.plan.resolution)});
    return image;
}

const BakeFormat kHeightFieldFormat = bake_format<kOf>();

}  // namespace ocean
