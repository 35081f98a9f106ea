// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// --from: a baked file says how it was made.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "ocean/bake/plan.hpp"
#include "ocean/io/exr.hpp"

namespace ocean {

/// Throws Error bad_file: "--from PATH: reason".
[[noreturn]] void refuse_source(const std::string& path, const std::string& reason);

/// What a baked file says of itself.
class BakedHeader {
  public:
    /// Throws Error bad_file.
    BakedHeader(const std::string& path, const Catalogue& catalogue);

    /// Of ocean:NAME. Throws Error bad_file where it is missing, or no number.
    const std::string& text(const std::string& name) const;
    double number(const std::string& name) const;
    int whole_number(const std::string& name) const;
    bool has(const std::string& name) const { return strings_.contains("ocean:" + name); }
    /// Samples along a side of the sea's map.
    int resolution() const;
    /// Of an EXR file.
    const io::ExrLayout& layout() const { return *layout_; }

  private:
    template <typename Number>
    Number read(const std::string& name) const;

    const std::string& path_;
    std::map<std::string, std::string> strings_;
    std::optional<io::ExrLayout> layout_;
};

/// The options with SEA or --from settled. With --from those that are not given are taken from the
/// file's header, so that the same bytes come out again. Throws Error invalid_value unless exactly
/// one of the two is given, and bad_file or unsupported for a file that does not say enough.
/// `format`: of the output; null if it is unknown.
BakeOptions with_source(BakeOptions options, const Catalogue& catalogue, const BakeFormat* format);

}  // namespace ocean
