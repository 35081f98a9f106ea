// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Writes grids into a file. OpenVDB writes into our own stream, because its own does not report a
// full disk. The stream can seek, so that readers can skip from grid to grid.
#include <openvdb/MetaMap.h>
#include <openvdb/io/Archive.h>

#include <ostream>
#include <streambuf>

#include "ocean/error.hpp"
#include "ocean/internal/io/output_file.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/version.hpp"
#include "vdb_grids.hpp"

namespace ocean::io {
namespace {

class FileBuffer : public std::streambuf {
  public:
    explicit FileBuffer(OutputFile& file) : file_(file) {}

  protected:
    std::streamsize xsputn(const char* bytes, std::streamsize count) override {
        file_.write({bytes, static_cast<std::size_t>(count)});
        return count;
    }
    int_type overflow(int_type byte) override {
        if (traits_type::eq_int_type(byte, traits_type::eof())) return traits_type::not_eof(byte);
        const char value = traits_type::to_char_type(byte);
        file_.write({&value, 1});
        return byte;
    }
    pos_type seekoff(off_type offset, std::ios::seekdir from, std::ios::openmode) override {
        if (from == std::ios::end) return {off_type{-1}};
        return seekpos(from == std::ios::beg ? offset : tell() + offset, std::ios::out);
    }
    pos_type seekpos(pos_type position, std::ios::openmode) override {
        if (off_type(position) != tell()) file_.seek(static_cast<std::uint64_t>(position));
        return position;
    }

  private:
    off_type tell() { return static_cast<off_type>(file_.tell()); }

    OutputFile& file_;
};

/// Access to the writer of OpenVDB, which exposes neither its stream nor its positions.
class GridArchive : public openvdb::io::Archive {
  public:
    using Archive::write;
};

/// Returns the id by which readers distinguish files: a hash of grids, strings and settings.
std::string file_id(std::span<const VdbGrid> grids, std::span<const HeaderString> strings,
                    bool half_floats) {
    std::string text = half_floats ? "half" : "float";
    for (const VdbGrid& grid : grids) text += '\n' + grid.grid().grid->getName();
    for (const HeaderString& string : strings) text += '\n' + string.name + '=' + string.text;
    // FNV-1a with two offset bases.
    std::uint64_t half[2] = {0xcbf29ce484222325u, 0x84222325cbf29ce4u};
    for (const char byte : text) {
        for (std::uint64_t& hash : half) {
            hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3u;
        }
    }
    // A UUID of version 8, whose other bits are free [RFC 9562] section 5.8.
    return format_text("%08x-%04x-8%03x-%04x-%012llx", static_cast<unsigned>(half[0] >> 32),
                       static_cast<unsigned>(half[0] >> 16 & 0xffffu),
                       static_cast<unsigned>(half[0] & 0xfffu),
                       static_cast<unsigned>((half[1] >> 48 & 0x3fffu) | 0x8000u),
                       static_cast<unsigned long long>(half[1] & 0xffffffffffffu));
}

}  // namespace

void vdb::write_vdb(std::span<const VdbGrid> grids, std::span<const HeaderString> strings,
                    bool half_floats, const std::string& path) {
    constexpr std::uint64_t kIdPosition = 21;  // after the magic, three versions and a flag

    openvdb::MetaMap header;
    header.insertMeta("creator", openvdb::StringMetadata("libocean " OCEAN_VERSION));
    for (const HeaderString& string : strings) {
        header.insertMeta(string.name, openvdb::StringMetadata(string.text));
    }
    openvdb::GridCPtrVec written;
    for (const VdbGrid& grid : grids) {
        openvdb::GridBase::Ptr copy = openvdb::ConstPtrCast<openvdb::GridBase>(grid.grid().grid)
                                          ->copyGrid();  // shares the tree
        copy->setSaveFloatAsHalf(half_floats);
        written.push_back(copy);
    }
    OutputFile file(path);
    try {
        FileBuffer buffer(file);
        std::ostream stream(&buffer);
        stream.exceptions(std::ios::badbit | std::ios::failbit);
        GridArchive archive;
        archive.setCompression(openvdb::io::COMPRESS_ACTIVE_MASK |
                               (GridArchive::hasBloscCompression() ? openvdb::io::COMPRESS_BLOSC
                                                                   : openvdb::io::COMPRESS_ZIP));
        archive.write(stream, written, /*seekable=*/true, header);
    } catch (const Error&) {
        throw;
    } catch (const std::exception& error) {
        throw Error(ErrorKind::output, "cannot write '" + path + "': " + error.what());
    }
    // OpenVDB's own id is a random number.
    file.seek(kIdPosition);
    file.write(file_id(grids, strings, half_floats));
    file.commit();
}

}  // namespace ocean::io
