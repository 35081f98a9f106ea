// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// --from: the options of a bake from the header of a baked file.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "ocean/bake/plan.hpp"
#include "ocean/io/exr.hpp"

namespace ocean {

/// Throws Error bad_file, "--from PATH: reason".
[[noreturn]] void refuse_source(const std::string& path, const std::string& reason);

/// The header of a baked file.
class BakedHeader {
  public:
    /// Throws Error bad_file.
    BakedHeader(const std::string& path, const Catalogue& catalogue);

    /// Return the value of ocean:NAME. Throw Error bad_file if it is missing or not a number.
    const std::string& text(const std::string& name) const;
    double number(const std::string& name) const;
    int whole_number(const std::string& name) const;
    bool has(const std::string& name) const { return strings_.contains("ocean:" + name); }
    /// Returns the samples along a side of the subject's map.
    int resolution() const;
    /// Returns the subject that the header describes. Throws Error as its reader.
    std::unique_ptr<Subject> subject(const Catalogue& catalogue) const;
    /// Returns true for an EXR file.
    bool has_layout() const { return layout_.has_value(); }
    /// Returns the layout of an EXR file.
    const io::ExrLayout& layout() const { return *layout_; }

  private:
    template <typename Number>
    Number read(const std::string& name) const;

    const std::string& path_;
    std::map<std::string, std::string> strings_;
    std::optional<io::ExrLayout> layout_;
};

/// Returns the options with a source. With --from, options that were not given get the values of
/// the file's header, so that the same bytes are baked again. `format` is the output's format, null
/// if it is unknown. Throws Error invalid_value unless exactly one of SEA and --from is given, and
/// bad_file or unsupported for a file with an incomplete header.
BakeOptions with_source(BakeOptions options, const Catalogue& catalogue, const BakeFormat* format);

}  // namespace ocean
