// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What the flags of quality beside a spectrum say of one record: which frequencies, or all of it,
// are left out, and what its reader is told.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "netcdf_content.hpp"
#include "netcdf_layout.hpp"
#include "ocean/spectrum_record.hpp"
#include "quality_flags.hpp"

namespace ocean::netcdf {

/// What the flags of one variable say in one record.
struct Verdict {
    std::string record_fault;  // if the whole record is bad
    std::vector<bool> bad;     // by frequency of the file; empty where none is
};

/// "record 2020-06-08T03:50 41010: ", before a fault of it.
std::string label(const SpectrumRecord& record);

class RecordFlags {
  public:
    /// Both outlive it.
    RecordFlags(const Content& content, const Layout& layout);

    /// What the flags of a variable say at a point among all dimensions of the content; of those of
    /// the spectrum, `record` gets the warnings.
    Verdict judge(SpectrumRecord& record, const Variable& judged,
                  std::vector<std::size_t> at) const;

  private:
    /// A variable of flags, the one that it judges, and what its flags mean.
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
