// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The extent of a classic NetCDF file: see classic_extent.hpp.
#include "classic_extent.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace ocean::netcdf {
namespace {

struct Stored {
    std::uint64_t begin = 0;
    std::uint64_t bytes = 0;  // of one record, for a variable with records
    bool records = false;
};

class ClassicHeader {
  public:
    explicit ClassicHeader(std::istream& file) : file_(file) {
        std::array<char, 4> magic{};
        file_.read(magic.data(), magic.size());
        wide_counts_ = magic[3] == 5;
        wide_offsets_ = magic[3] != 1;
        records_ = count();
    }

    std::uint64_t extent() {
        std::vector<std::uint64_t> sizes;
        for (std::uint64_t left = list(); left > 0 && file_; --left) {
            skip(count(), 1);
            sizes.push_back(count());
        }
        attributes();
        std::vector<Stored> variables;
        for (std::uint64_t left = list(); left > 0 && file_; --left) {
            variables.push_back(variable(sizes));
        }
        if (!file_) return 0;
        const auto with_records = [](const Stored& v) { return v.records; };
        const bool alone = std::count_if(variables.begin(), variables.end(), with_records) == 1;
        std::uint64_t record = 0;
        for (const Stored& v : variables) {
            if (v.records) record += alone ? v.bytes : (v.bytes + 3) / 4 * 4;
        }
        std::uint64_t end = 0;
        for (const Stored& v : variables) {
            if (v.records && records_ == 0) continue;
            const std::uint64_t before = v.records ? (records_ - 1) * record : 0;
            end = std::max(end, v.begin + before + v.bytes);
        }
        return end;
    }

  private:
    std::uint64_t number(int bytes) {
        std::uint64_t value = 0;
        for (; bytes > 0; --bytes) value = value << 8 | static_cast<std::uint8_t>(file_.get());
        return value;
    }
    std::uint64_t count() { return number(wide_counts_ ? 8 : 4); }
    std::uint64_t list() {
        number(4);  // the list's tag
        return count();
    }
    void skip(std::uint64_t elements, std::uint64_t size) {
        file_.ignore(static_cast<std::streamsize>((elements * size + 3) / 4 * 4));
    }
    static std::uint64_t size_of(std::uint64_t type) {
        constexpr std::array kSizes = {0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
        return type < kSizes.size() ? static_cast<std::uint64_t>(kSizes[type]) : 0;
    }
    void attributes() {
        for (std::uint64_t left = list(); left > 0 && file_; --left) {
            skip(count(), 1);
            const std::uint64_t type = number(4);
            skip(count(), size_of(type));
        }
    }
    Stored variable(const std::vector<std::uint64_t>& sizes) {
        skip(count(), 1);
        Stored result;
        std::uint64_t elements = 1;
        for (std::uint64_t left = count(); left > 0 && file_; --left) {
            const std::uint64_t dimension = count();
            const std::uint64_t size = dimension < sizes.size() ? sizes[dimension] : 1;
            if (size == 0) {
                result.records = true;  // the unlimited dimension
            } else {
                elements *= size;
            }
        }
        attributes();
        result.bytes = elements * size_of(number(4));
        count();  // the variable's size, which is wrong for large variables
        result.begin = number(wide_offsets_ ? 8 : 4);
        return result;
    }

    std::istream& file_;
    bool wide_counts_ = false;
    bool wide_offsets_ = false;
    std::uint64_t records_ = 0;
};

}  // namespace

std::uint64_t classic_extent(std::istream& file) {
    return ClassicHeader(file).extent();
}

}  // namespace ocean::netcdf
