// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The outputs of a request of libocean.h as those of core, checked, for seas and terrains.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "guard.hpp"
#include "libocean.h"
#include "ocean/domain.hpp"
#include "ocean/surface.hpp"

namespace ocean::capi {

/// The outputs of a request, whose struct may be that of an older header.
class OutputArray {
  public:
    OutputArray(const ocean_request& request, std::size_t caller_struct_size)
        : OutputArray(request.outputs, request.output_count,
                      request.output_size > 0 ? request.output_size
                      : caller_struct_size < offsetof(ocean_request, cascade)
                          ? kFirstOutput
                          : sizeof(ocean_output)) {}
    OutputArray(const ocean_output* outputs, std::size_t count, std::size_t output_size)
        : bytes_(reinterpret_cast<const unsigned char*>(outputs)), size_(output_size) {
        require_struct_size(size_, kFirstOutput, "output_size", "ocean_output",
                            sizeof(ocean_output));
        if (count > 0) require(outputs, "outputs");
    }
    ocean_output operator[](std::size_t i) const {
        return read_bytes<ocean_output>(bytes_ + i * size_, size_, "ocean_output");
    }

  private:
    static constexpr std::size_t kFirstOutput = offsetof(ocean_output, row_pitch);

    const unsigned char* bytes_;
    std::size_t size_;
};

/// Returns the output as a map of `resolution` samples a side. `name` is that of the output in
/// messages. Throws CallError for what libocean.h does not allow.
MapOutput map_output(const ocean_output& output, const std::string& name, int resolution);
/// Returns the output as a map of columns x rows samples. Throws as the other.
MapOutput map_output(const ocean_output& output, const std::string& name, int columns, int rows);
/// Writes all outputs of a request as maps of `resolution` samples to `maps`. Throws CallError as
/// map_output, and for outputs without any channel.
void read_outputs(const ocean_request& asked, std::size_t caller_struct_size, int resolution,
                  std::vector<MapOutput>& maps);
/// Writes `count` outputs as maps of columns x rows samples to `maps`. Throws as the other.
void read_outputs(const OutputArray& outputs, std::size_t count, int columns, int rows,
                  std::vector<MapOutput>& maps);
/// Returns the domain of a region and writes its outputs to `maps`. Throws CallError for sides and
/// numbers out of range, and as read_outputs.
Domain read_region(const ocean_region_request* request, std::vector<MapOutput>& maps);
/// Writes a domain of equal steps both ways. Throws CallError for a struct of another size.
void write_domain(const Domain& own, ocean_domain* domain);
/// The farthest place and the longest side of a region [m].
inline constexpr double kFarthest = 1e8;
/// Throws CallError for a value of the argument or member of that name below `lowest` or beyond
/// kFarthest [m].
void require_metres(const char* name, double value, double lowest);
/// Returns the samples of a region from (x, y) on. Throws CallError for numbers out of range.
Domain region_domain(double x, double y, double cell, std::int32_t columns, std::int32_t rows);
/// Returns the word of OCEAN_ZUP, OCEAN_YUP or OCEAN_TNB. Throws CallError for another number.
std::string_view axes_name(std::int32_t axes);
/// Returns the resolution that a request asks for, 0 standing for `shown`. Throws CallError.
int map_resolution(int asked, int shown);

}  // namespace ocean::capi
