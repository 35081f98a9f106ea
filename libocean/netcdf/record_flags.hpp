// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Applies the quality flags beside a spectrum to one record: frequencies, or the whole record, are
// left out, with a warning.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "netcdf_content.hpp"
#include "netcdf_layout.hpp"
#include "ocean/parameters.hpp"

namespace ocean::netcdf {

/// The quality that a flag gives a value.
enum class Quality { good, doubtful, bad };

/// The meaning of a variable's flags by its flag_values and flag_meanings. Without them by the
/// oceanographic scale: 3 is doubtful, 4 bad, 9 missing.
class QualityFlags {
  public:
    explicit QualityFlags(const Variable& flags);
    Quality quality(double flag) const;

  private:
    std::vector<std::pair<double, Quality>> known_;
};

/// The verdict of one variable's flags on one record.
struct Verdict {
    std::string record_fault;  // set if the whole record is bad
    std::vector<bool> bad;     // by frequency of the file; empty if none is bad
};

/// Returns "record 2020-06-08T03:50 41010: ", which begins messages about the record.
std::string label(const SpectrumRecord& record);

class RecordFlags {
  public:
    /// `content` and `layout` must outlive this object.
    RecordFlags(const Content& content, const Layout& layout);

    /// Returns the verdict of the flags of `judged` at a point in all dimensions of the content.
    /// Adds warnings to `record` for flags of the spectrum.
    Verdict judge(SpectrumRecord& record, const Variable& judged,
                  std::vector<std::size_t> at) const;

  private:
    /// A variable of flags, the variable that it judges, and the meaning of the flags.
    struct Flags {
        const Variable* flags;
        const Variable* judged;
        QualityFlags meaning;
    };

    const Content& content_;
    const Layout& layout_;
    std::vector<Flags> flags_;
};

}  // namespace ocean::netcdf
