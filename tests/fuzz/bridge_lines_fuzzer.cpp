// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as what a client sends, and as what a server sends: the same lines in whatever pieces
// they come, and the same answers to telnet; each clean or named as a fault, each one request or
// one refusal, each answer one printable line; and what a request asks of the values is done or
// refused as a whole.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/error.hpp"
#include "ocean/internal/bridge/line_protocol.hpp"
#include "ocean/internal/bridge/value_table.hpp"
#include "require.hpp"

namespace {

using namespace ocean;
using namespace ocean::bridge;
using ocean::fuzz::require;

void require_one_line(std::string_view line) {
    require(!line.empty() && line.size() <= kMaxLineBytes + 64);
    for (const char c : line) require(static_cast<unsigned char>(c) >= 0x20);
}

std::vector<LineSplitter::Line> lines_of(std::string_view bytes, std::size_t piece,
                                         std::string& replies) {
    LineSplitter splitter;
    std::vector<LineSplitter::Line> lines;
    while (!bytes.empty()) {
        std::string_view next = bytes.substr(0, piece);
        bytes.remove_prefix(next.size());
        while (auto line = splitter.next(next, &replies)) lines.push_back(std::move(*line));
    }
    return lines;
}

void run(const std::string& line, ValueTable& values) {
    parse_server_line(line);
    const auto parsed = parse_request(line);
    if (!parsed) return;
    if (const auto* refusal = std::get_if<Refusal>(&*parsed)) {
        require_one_line(refusal_line(*refusal));
        return;
    }
    const auto& request = std::get<Request>(*parsed);
    if (request.verb != Verb::set && request.verb != Verb::get) return;
    const std::uint64_t before = values.revision();
    try {
        const std::size_t entry = values.find(request.arguments[0]);
        if (request.verb == Verb::set) values.set(entry, request.arguments[1], "fuzz");
        require_one_line(update_line(request.arguments[0], values[entry].text));
        validate(values.parameters());
    } catch (const Error& error) {
        require(values.revision() == before);
        require_one_line(refusal_line({"RANGE", error.what()}));
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    std::string replies;
    std::string again;
    const auto whole = lines_of(bytes, size + 1, replies);
    const auto pieces = lines_of(bytes, 1 + (size > 0 ? data[0] % 7u : 0u), again);
    require(whole.size() == pieces.size());
    // Two bytes ask Are You There, and its event is the longest of what telnet is answered.
    require(replies == again && replies.size() <= 5 * size);
    static const ValueTable start;
    ValueTable values = start;
    for (std::size_t i = 0; i < whole.size(); ++i) {
        require(whole[i].text == pieces[i].text && whole[i].fault == pieces[i].fault);
        require(whole[i].text.size() <= kMaxLineBytes);
        if (whole[i].fault.empty()) run(whole[i].text, values);
    }
    return 0;
}
