// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See source.hpp. Values of the header become the texts of options that were not given, and are
// checked as if they had been typed.
#include "source.hpp"

#include <algorithm>
#include <charconv>
#include <string_view>

#include "formats/formats.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/subject.hpp"
#include "refuse.hpp"

namespace ocean {
namespace {

void set_default(std::string& option, std::string_view value) {
    if (option.empty()) option = value;
}

/// Refuses a file whose time differs from its frame's: it was not baked, and could not be baked
/// again.
void check_time(const Subject& subject, const BakedHeader& header, const std::string& path) {
    if (subject.timeline().time_of(header.whole_number("frame")) == header.number("time")) return;
    refuse_source(path, "its ocean:time is not that of its ocean:frame");
}

}  // namespace

void refuse_source(const std::string& path, const std::string& reason) {
    throw Error(ErrorKind::bad_file, "--from " + path + ": " + reason);
}

BakedHeader::BakedHeader(const std::string& path, const Catalogue& catalogue) : path_(path) {
    const BakeFormat* format = catalogue.find_format_of_frame(OutputPattern(path).extension());
    if (format == nullptr) format = &kExrFormat;  // its reader explains the fault
    if (format->read_header == nullptr) {
        refuse_source(path, "a file of type " + std::string(format->extension) +
                                " does not name its subject");
    }
    for (io::HeaderString& string : format->read_header(path)) {
        strings_[string.name] = std::move(string.text);
    }
    if (format == &kExrFormat) layout_ = io::read_exr_layout(path);
}

std::unique_ptr<Subject> BakedHeader::subject(const Catalogue& catalogue) const {
    const auto shown = std::ranges::find_if(catalogue.subjects, [&](const SubjectReader& reader) {
        return has(std::string(reader.kind));
    });
    const SubjectReader& reader =
        shown == catalogue.subjects.end() ? catalogue.subjects.front() : *shown;
    return reader.parse(text(std::string(reader.kind)), path_);
}

int BakedHeader::resolution() const {
    // The map beside a slope tile has its own resolution.
    if (has("map_resolution")) return whole_number("map_resolution");
    // An image of several tiles has more samples than its resolution, which counts one tile.
    if (!layout_ || has("resolution")) return whole_number("resolution");
    const auto [width, height] = layout_->samples;
    if (width == height && width <= kMaxResolution) return width;
    refuse_source(path_, "its image is not a square of at most 8192 samples along a side");
}

const std::string& BakedHeader::text(const std::string& name) const {
    const auto found = strings_.find("ocean:" + name);
    if (found == strings_.end()) refuse_source(path_, "its header has no ocean:" + name);
    return found->second;
}

template <typename Number>
Number BakedHeader::read(const std::string& name) const {
    const std::string& digits = text(name);
    Number value{};
    const char* end = digits.data() + digits.size();
    const auto [stop, code] = std::from_chars(digits.data(), end, value);
    if (code != std::errc() || stop != end) {
        refuse_source(path_, "its ocean:" + name + " is not a number");
    }
    return value;
}

double BakedHeader::number(const std::string& name) const {
    return read<double>(name);
}

int BakedHeader::whole_number(const std::string& name) const {
    return read<int>(name);
}

BakeOptions with_source(BakeOptions options, const Catalogue& catalogue, const BakeFormat* format) {
    if (options.from.empty() == options.source.empty()) {
        refuse("bake: give SEA or --from FRAME.exr, one of them");
    }
    if (options.from.empty()) return options;
    options.source = options.from;
    const BakedHeader header(options.from, catalogue);
    const auto subject = header.subject(catalogue);
    check_time(*subject, header, options.from);
    set_default(options.frames, std::to_string(header.whole_number("frame")));
    // The subject's own resolution stays a default, which a changed subject may change. A region's
    // resolution follows from its domain, and may be any number.
    const int resolution = header.resolution();
    if (resolution != subject->default_resolution() && is_resolution(resolution)) {
        set_default(options.resolution, std::to_string(resolution));
    }
    if (header.has("backend")) set_default(options.backend, header.text("backend"));
    if (format != nullptr) format->adopt(header, catalogue, options);
    return options;
}

}  // namespace ocean
