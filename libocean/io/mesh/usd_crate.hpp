// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A USD crate file (.usdc) of one prim with attributes, in version 0.8.0 of the format, which all
// current readers accept. Its arrays are raw; its sections are LZ4 blocks of literals, which is
// valid LZ4 and needs no library.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ocean/internal/io/output_file.hpp"

namespace ocean::io {

class UsdCrate {
  public:
    /// Starts the file of a prim `name` of `type`. Adding a value writes it; finish() writes the
    /// rest.
    UsdCrate(OutputFile& file, std::string name, std::string type);

    /// A reference to a value in the file, or the value itself.
    using Value = std::uint64_t;
    Value token(const std::string& text);
    Value string(const std::string& text);
    /// Writes an array with 1 .. 4 floats for each element.
    Value floats(std::span<const float> values, int components);
    Value integers(std::span<const int> values);

    void add_default(const std::string& name, const std::string& type, Value value);
    void add_uniform(const std::string& name, const std::string& type, Value value);
    /// Writes a time sample at one time code.
    void add_sample(const std::string& name, const std::string& type, double time_code,
                    Value value);
    /// Writes all remaining sections; does not commit the file.
    void finish();

  private:
    struct Spec {
        std::string name;
        std::uint32_t kind;
        std::vector<std::pair<std::string, Value>> fields;
    };

    std::uint64_t align();
    void put(const void* bytes, std::size_t count);
    template <typename Number>
    void put_number(Number number) {
        put(&number, sizeof number);
    }
    std::uint32_t token_number(const std::string& text);
    Value array(const void* values, std::size_t elements, std::size_t bytes, unsigned type);
    Value token_list(std::span<const std::string> tokens);
    void section(std::string_view name, const std::string& bytes);

    OutputFile& file_;
    std::string name_, type_;
    std::uint64_t position_ = 0;
    std::vector<std::string> tokens_;
    std::map<std::string, std::uint32_t> token_numbers_;
    std::vector<std::uint32_t> strings_;
    std::vector<Spec> attributes_;
    struct Section {
        std::string name;
        std::uint64_t start;
        std::uint64_t size;
    };
    std::vector<Section> sections_;
};

/// Returns the first string of a file that UsdCrate wrote. Throws Error bad_file for any other
/// file, and for one that is cut off.
std::string read_usd_string(const std::string& path);

}  // namespace ocean::io
