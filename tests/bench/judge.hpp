// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Whether a subject computes what it should: its last frame against transforms in double, so that
// nobody is fast by being wrong.
#pragma once

#include "subject.hpp"

namespace ocean::bench {

/// The fields of one sea at one time, in double, by FFTW.
class Judge {
  public:
    Judge(const Sea& sea, double time);

    double time() const { return time_; }
    /// rms of the error over rms of the field, of the worst field of the subject's last frame.
    double error(const Subject& subject, FrameKind kind) const;

  private:
    double field_error(const FieldView& view, Linear field) const;
    double normal_error(const Subject& subject) const;

    double time_;
    std::size_t n_;
    std::vector<std::vector<double>> planes_;  // as fields_of(planar)
};

}  // namespace ocean::bench
