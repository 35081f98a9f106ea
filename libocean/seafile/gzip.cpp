// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Packed text files: see gzip.hpp. zlib is linked statically, so that libocean.so needs no library.
#include "gzip.hpp"

#include "ocean/internal/checked_text.hpp"

#ifdef OCEAN_HAVE_ZLIB
#include <zlib.h>

#include <algorithm>
#include <vector>
#endif

namespace ocean {

bool is_gzip(std::string_view content) {
    return content.starts_with("\x1f\x8b");
}

#ifdef OCEAN_HAVE_ZLIB

namespace {

class Inflater {
  public:
    Inflater() { good_ = inflateInit2(&stream_, 15 + 16) == Z_OK; }  // 16: gzip, not zlib
    ~Inflater() { inflateEnd(&stream_); }
    Inflater(const Inflater&) = delete;
    Inflater& operator=(const Inflater&) = delete;

    bool good() const { return good_; }
    z_stream& stream() { return stream_; }

  private:
    z_stream stream_{};
    bool good_ = false;
};

/// Unpacks all members, block by block.
template <typename Visit>
void inflate_all(std::string_view packed, const std::string& name, const Visit& visit) {
    const auto fail = [&](const std::string& why) {
        return text::error_at(ErrorKind::bad_file, name, 0, "gzip: " + why);
    };
    std::vector<char> block(std::size_t{1} << 16);
    while (!packed.empty()) {
        Inflater inflater;  // a file may consist of several members
        if (!inflater.good()) throw Error(ErrorKind::out_of_memory, "zlib has not enough memory");
        z_stream& stream = inflater.stream();
        // zlib only reads from next_in, in spite of its type; sizes are below the reader's limit.
        stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
        stream.avail_in = static_cast<uInt>(packed.size());
        int state = Z_OK;
        while (state == Z_OK) {
            stream.next_out = reinterpret_cast<Bytef*>(block.data());
            stream.avail_out = static_cast<uInt>(block.size());
            state = inflate(&stream, Z_NO_FLUSH);
            visit(std::string_view(block.data(), block.size() - stream.avail_out));
        }
        if (state == Z_BUF_ERROR) throw fail("the file is cut off");
        if (state != Z_STREAM_END) throw fail("the file is damaged");
        packed.remove_prefix(packed.size() - stream.avail_in);
        // Zeros that pad a block of a tape or a download are not a member.
        packed.remove_prefix(std::min(packed.find_first_not_of('\0'), packed.size()));
    }
}

}  // namespace

std::string gunzip(std::string_view packed, const std::string& name, std::size_t limit) {
    // The size is measured before anything is stored, so that a refused file needs no memory.
    std::size_t size = 0;
    inflate_all(packed, name, [&](std::string_view block) {
        size += block.size();
        if (size <= limit) return;
        throw text::error_at(
            ErrorKind::bad_file, name, 0,
            "gzip: unpacks to more than the " + std::to_string(limit >> 20) + " MiB allowed");
    });
    std::string out;
    out.reserve(size);
    inflate_all(packed, name, [&](std::string_view block) { out += block; });
    return out;
}

#else

std::string gunzip(std::string_view, const std::string& name, std::size_t) {
    throw text::error_at(ErrorKind::unsupported, name, 0,
                         "is packed, and this libocean was built without zlib; unpack it first");
}

#endif

}  // namespace ocean
