// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads the texts in the header of a VDB file without OpenVDB, which trusts the sizes in a file.
#include <cstring>

#include "ocean/error.hpp"
#include "ocean/internal/io/provenance.hpp"
#include "ocean/io/vdb.hpp"

namespace ocean::io {
namespace {

constexpr std::uint64_t kMagic = 0x56444220;   // "VDB "
constexpr std::uint32_t kOldestVersion = 222;  // OpenVDB 3; written by 10: 224
constexpr std::size_t kIdLength = 36;

/// Reads consecutive little-endian values; a caller checks once at the end that none was missing.
class Bytes {
  public:
    explicit Bytes(std::string_view bytes) : rest_(bytes) {}

    template <typename Number>
    Number number() {
        Number value{};
        const std::string_view bytes = read(sizeof value);
        if (bytes.size() == sizeof value) std::memcpy(&value, bytes.data(), sizeof value);
        return value;
    }
    std::string_view read(std::size_t count) {
        if (count > rest_.size()) {
            ends_early_ = true;
            rest_ = {};
            return {};
        }
        const std::string_view bytes = rest_.substr(0, count);
        rest_.remove_prefix(count);
        return bytes;
    }
    std::string_view counted() { return read(number<std::uint32_t>()); }
    bool ends_early() const { return ends_early_; }

  private:
    std::string_view rest_;
    bool ends_early_ = false;
};

}  // namespace

std::vector<HeaderString> read_vdb_header(const std::string& path) {
    const std::string head = read_head(path);
    Bytes bytes(head);
    if (bytes.number<std::uint64_t>() != kMagic) {
        throw Error(ErrorKind::bad_file, path + ": is not an OpenVDB file");
    }
    const auto version = bytes.number<std::uint32_t>();
    bytes.read(2 * sizeof(std::uint32_t));  // version of the library
    bytes.read(1);                          // true if grids have offsets
    bytes.read(kIdLength);
    if (version < kOldestVersion) {
        throw Error(ErrorKind::bad_file, path + ": is of an older version of OpenVDB's files");
    }
    std::vector<HeaderString> strings;
    for (auto count = bytes.number<std::uint32_t>(); count > 0 && !bytes.ends_early(); --count) {
        const std::string_view name = bytes.counted();
        const std::string_view type = bytes.counted();
        const std::string_view value = bytes.counted();
        if (bytes.ends_early() || type != "string") continue;
        strings.push_back({std::string(name), std::string(value)});
    }
    if (bytes.ends_early()) {
        throw Error(ErrorKind::bad_file, path + ": its header ends early");
    }
    if (!find_provenance(strings, path)) {
        throw Error(
            ErrorKind::bad_file,
            path + ": its metadata have no sea; only files that `ocean bake` wrote have one");
    }
    return strings;
}

}  // namespace ocean::io
