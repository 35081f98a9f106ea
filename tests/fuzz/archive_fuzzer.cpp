// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as a tar: files that lie within it, with printable names, or one Error whose message is
// safe to print; and as an archive of spectra, what every reader promises.
#include "archive.hpp"

#include "reader_fuzzer.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ocean;
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    try {
        std::string cut_off;
        for (const ArchiveMember& member : tar_members(bytes, "fuzz.tar", cut_off)) {
            fuzz::require(member.content.empty() ||
                          (member.content.data() >= bytes.data() &&
                           member.content.data() + member.content.size() <= bytes.data() + size));
            if (!member.name.empty()) fuzz::check_message(member.name + " ");
        }
        if (is_tar(bytes)) fuzz::check_all(read_spectra_from({bytes, "fuzz.tar", {}}));
    } catch (const Error& error) {
        fuzz::check_message(error.what());
    }
    return 0;
}
