// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What a child that reads NetCDF may send, whatever file has overrun it: decode and records_from
// give records, each good or with a fault, or one exception with a message that is safe to print.
#include "child_bytes.hpp"
#include "netcdf_records.hpp"
#include "netcdf_wire.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/record_rules.hpp"
#include "reader_fuzzer.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ocean;
    const sandbox::Source source = fuzz::child_bytes(data, size);
    try {
        std::vector<SpectrumRecord> records = netcdf::records_from(netcdf::decode(source));
        for (SpectrumRecord& record : records) {
            if (record.fault.empty()) continue;
            record.fault = text::error_at(ErrorKind::bad_file, "fuzz", 0, record.fault).what();
        }
        require_readable(records);
        fuzz::check_all(records);
    } catch (const netcdf::WireError&) {
    } catch (const Error& error) {
        fuzz::check_message(error.what());
    } catch (const netcdf::Fault& fault) {
        fuzz::check_message(text::error_at(ErrorKind::bad_file, "fuzz", 0, fault.what()).what());
    }
    return 0;
}
