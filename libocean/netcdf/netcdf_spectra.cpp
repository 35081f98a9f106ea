// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Spectra from NetCDF: see netcdf_spectra.hpp.
#include "ocean/internal/netcdf_spectra.hpp"

#include <filesystem>
#include <fstream>
#include <system_error>

#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/internal/record_rules.hpp"
#ifdef OCEAN_HAVE_NETCDF
#include "netcdf_file.hpp"
#include "netcdf_records.hpp"
#include "netcdf_wire.hpp"
#include "ocean/internal/child_process.hpp"
#endif

namespace ocean {
namespace {

using namespace std::string_view_literals;

Error bad_file(const std::string& path, std::string_view message) {
    return text::error_at(ErrorKind::bad_file, path, 0, message);
}

/// Throws for other files: libnetcdf would also open folders, URLs and formats without spectra.
void require_netcdf(const std::string& path) {
    const std::filesystem::path file = utf8_path(path);
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) throw bad_file(path, "no such file");
    if (!std::filesystem::is_regular_file(file, ignored)) throw bad_file(path, "is not a file");
    std::string first(8, '\0');
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw bad_file(path, "cannot be read: no permission");
    stream.read(first.data(), static_cast<std::streamsize>(first.size()));
    if (!is_netcdf(first)) throw bad_file(path, "is not a NetCDF file");
}

#ifdef OCEAN_HAVE_NETCDF
/// Returns an absolute path, which libnetcdf cannot mistake for a URL.
netcdf::Content read_content(const std::string& path) {
    const std::string absolute = text::to_utf8(std::filesystem::absolute(utf8_path(path)));
    const auto produce = [&](const netcdf::Sink& sink) {
        try {
            netcdf::encode(netcdf::read_file(absolute), sink);
        } catch (const netcdf::Fault& fault) {
            netcdf::encode(fault, sink);
        }
    };
    netcdf::Content content;
    sandbox::run_in_child({}, produce,
                          [&](const netcdf::Source& source) { content = netcdf::decode(source); });
    return content;
}
#endif

}  // namespace

bool is_netcdf(std::string_view first_bytes) {
    for (const std::string_view signature :
         {"CDF\1"sv, "CDF\2"sv, "CDF\5"sv, "\x89HDF\r\n\x1a\n"sv}) {
        if (first_bytes.starts_with(signature)) return true;
    }
    return false;
}

std::vector<SpectrumRecord> read_netcdf_spectra(const std::string& path) {
    require_netcdf(path);
#ifdef OCEAN_HAVE_NETCDF
    try {
        std::vector<SpectrumRecord> records = netcdf::records_from(read_content(path));
        for (SpectrumRecord& record : records) {
            if (!record.fault.empty()) record.fault = bad_file(path, record.fault).what();
        }
        require_readable(records);
        return records;
    } catch (const netcdf::Fault& fault) {
        throw bad_file(path, fault.what());
    } catch (const sandbox::ChildFailure& failure) {
        throw bad_file(path,
                       "the NetCDF library failed on this file: " + std::string(failure.what()));
    }
#else
    throw Error(ErrorKind::unsupported,
                path + ": is a NetCDF file, and this program was built without NetCDF");
#endif
}

}  // namespace ocean
