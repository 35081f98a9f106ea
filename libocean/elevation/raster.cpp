// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A raster as bytes: see raster.hpp. Numbers have the byte order of the machine; a message
// begins with its kind, a text with its size.
#include "raster.hpp"

#include <algorithm>
#include <cmath>

#include "ocean/internal/checked_text.hpp"

namespace ocean::elevation {
namespace {

enum class Kind : std::uint64_t {
    facts = 0x6f6365616e11,
    row = 0x6f6365616e12,
    fault = 0x6f6365616e13,
};
constexpr std::uint64_t kMaxTextBytes = 65536;
constexpr std::uint64_t kMaxNotes = 64;

struct Writer {
    const sandbox::Sink& sink;

    template <typename Count>
    void count(Count value, std::uint64_t) {
        const auto sent = static_cast<std::uint64_t>(value);
        sink(&sent, sizeof(sent));
    }
    void number(double value) { sink(&value, sizeof(value)); }
    void factor(double value) { number(value); }
    void text(const std::string& text) {
        const std::uint64_t size = std::min<std::uint64_t>(text.size(), kMaxTextBytes);
        count(size, kMaxTextBytes);
        sink(text.data(), size);
    }
};

/// Reads what a Writer wrote, and trusts nothing of it.
struct Reader {
    const sandbox::Source& source;

    void bytes(void* to, std::size_t size) {
        if (!source(to, size)) throw sandbox::WireError();
    }
    template <typename Count>
    void count(Count& value, std::uint64_t max) {
        std::uint64_t read = 0;
        bytes(&read, sizeof(read));
        if (read > max) throw sandbox::WireError();
        value = static_cast<Count>(read);
    }
    void number(double& value) {
        bytes(&value, sizeof(value));
        if (!std::isfinite(value)) throw sandbox::WireError();
    }
    /// A ratio of lengths.
    void factor(double& value) {
        number(value);
        if (!(value >= 1e-6 && value <= 1e6)) throw sandbox::WireError();
    }
    void text(std::string& text) {
        std::size_t size = 0;
        count(size, kMaxTextBytes);
        text.resize(size);
        bytes(text.data(), size);
    }
};

/// Writes or reads an optional value as a flag and the value.
template <typename Wire, typename Optional>
bool has(Wire& wire, Optional& value) {
    bool is_given = value.has_value();
    wire.count(is_given, 1);
    if (is_given && !value) value.emplace();
    return is_given;
}

/// Writes or reads facts.
template <typename Wire>
void transfer(Wire& wire, RasterFacts& facts) {
    constexpr std::uint64_t kMaxSide = INT32_MAX;  // a part of a larger raster may be read
    wire.count(facts.columns, kMaxSide);
    wire.count(facts.rows, kMaxSide);
    wire.count(facts.has_place, 1);
    for (auto& value : facts.south_west_centre) wire.number(value);
    for (auto& value : facts.cell) wire.number(value);
    if (has(wire, facts.is_geographic)) wire.count(*facts.is_geographic, 1);
    wire.factor(facts.metres_per_unit);
    for (auto& value : facts.ground_scale) wire.factor(value);
    if (has(wire, facts.height_unit)) wire.factor(*facts.height_unit);
    for (auto& value : facts.sample_scale) wire.number(value);
    wire.count(facts.rows_from_south, 1);
    wire.number(facts.full_scale);
    wire.text(facts.crs);
    wire.text(facts.definition);
    std::size_t notes = std::min<std::size_t>(facts.notes.size(), kMaxNotes);
    wire.count(notes, kMaxNotes);
    facts.notes.resize(notes);
    for (auto& note : facts.notes) wire.text(note);
}

/// Reads the kind of the next message. Throws a fault that was sent in its place.
void require_next(Reader& reader, Kind kind) {
    Kind got{};
    reader.count(got, UINT64_MAX);
    if (got == Kind::fault) {
        std::string words;
        reader.text(words);
        words = text::printable(words, kMaxTextBytes);
        throw RasterFault(words.empty() ? "cannot be read" : words);
    }
    if (got != kind) throw sandbox::WireError();
}

}  // namespace

void encode(const std::function<void(const RasterReceiver&)>& read, const sandbox::Sink& sink) {
    Writer writer{sink};
    const auto begin = [&](Kind kind) { writer.count(kind, 0); };
    try {
        read({.begin =
                  [&](RasterFacts facts) {
                      begin(Kind::facts);
                      transfer(writer, facts);
                  },
              .row =
                  [&](std::span<const float> row) {
                      begin(Kind::row);
                      sink(row.data(), row.size_bytes());
                  }});
    } catch (const RasterFault& fault) {
        begin(Kind::fault);
        writer.text(fault.what());
    }
}

RasterFacts decode_facts(const sandbox::Source& source) {
    Reader reader{source};
    require_next(reader, Kind::facts);
    RasterFacts facts;
    transfer(reader, facts);
    return facts;
}

void decode(const sandbox::Source& source, const RasterReceiver& receiver) {
    const RasterFacts facts = decode_facts(source);
    receiver.begin(facts);
    Reader reader{source};
    std::vector<float> row(static_cast<std::size_t>(facts.columns));
    for (std::int64_t i = 0; i < facts.rows; ++i) {
        require_next(reader, Kind::row);
        reader.bytes(row.data(), row.size() * sizeof(float));
        receiver.row(row);
    }
}

}  // namespace ocean::elevation
