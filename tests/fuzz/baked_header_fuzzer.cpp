// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as a baked file that is asked which sea it shows, by each reader that is ours: the
// texts of its header, or one Error. (OpenEXR reads its own.)
#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "ocean/error.hpp"
#include "ocean/internal/io/geotiff.hpp"
#include "ocean/internal/io/png.hpp"
#include "ocean/internal/io/usd.hpp"
#include "ocean/io/mesh.hpp"
#include "ocean/io/vdb.hpp"
#include "require.hpp"

namespace {

using namespace ocean;
using ocean::fuzz::require;

/// Bytes as a file that is on no disk.
class File {
  public:
    File() : descriptor_(::memfd_create("fuzz", MFD_CLOEXEC)) { require(descriptor_ >= 0); }
    std::string holding(const std::uint8_t* data, std::size_t size) const {
        require(::ftruncate(descriptor_, 0) == 0);
        require(::pwrite(descriptor_, data, size, 0) == static_cast<ssize_t>(size));
        return "/proc/self/fd/" + std::to_string(descriptor_);
    }

  private:
    int descriptor_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const File file;
    const std::string path = file.holding(data, size);
    for (const auto read : {io::read_ply_header, io::read_obj_header, io::read_usd_header,
                            io::read_vdb_header, io::read_png_header, io::read_geotiff_header}) {
        try {
            const std::vector<io::HeaderString> strings = read(path);
            require(!strings.empty());
            std::size_t bytes = 0;
            for (const io::HeaderString& string : strings) {
                bytes += string.name.size() + string.text.size();
            }
            // A crate packs its texts: at most 255 to 1.
            require(bytes <= 256 * size);
        } catch (const Error& error) {
            require(error.kind() == ErrorKind::bad_file);
        }
    }
    return 0;
}
