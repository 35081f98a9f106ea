// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A raster as bytes: see raster_wire.hpp. Numbers have the byte order of the machine; a message
// begins with its kind, a text with its size.
#include "raster_wire.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

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
constexpr std::uint64_t kNone = 99;  // of an optional flag

class Writer {
  public:
    explicit Writer(const sandbox::Sink& sink) : sink_(sink) {}
    void count(std::uint64_t value) { sink_(&value, sizeof(value)); }
    void number(double value) { sink_(&value, sizeof(value)); }
    void kind(Kind value) { count(static_cast<std::uint64_t>(value)); }
    void text(std::string_view text) {
        const std::string_view part = text.substr(0, kMaxTextBytes);
        count(part.size());
        sink_(part.data(), part.size());
    }
    void facts(const RasterFacts& facts) {
        kind(Kind::facts);
        count(static_cast<std::uint64_t>(facts.columns));
        count(static_cast<std::uint64_t>(facts.rows));
        count(facts.has_place ? 1 : 0);
        for (const double value : facts.south_west_centre) number(value);
        for (const double value : facts.cell) number(value);
        count(facts.is_geographic ? (*facts.is_geographic ? 1 : 0) : kNone);
        number(facts.metres_per_unit);
        for (const double value : facts.ground_scale) number(value);
        number(facts.height_unit.value_or(0.0));
        count(facts.rows_from_south ? 1 : 0);
        number(facts.full_scale);
        text(facts.crs);
        text(facts.definition);
        const std::size_t notes = std::min<std::size_t>(facts.notes.size(), kMaxNotes);
        count(notes);
        for (std::size_t i = 0; i < notes; ++i) text(facts.notes[i]);
    }
    void row(std::span<const float> row) {
        kind(Kind::row);
        sink_(row.data(), row.size_bytes());
    }

  private:
    const sandbox::Sink& sink_;
};

class Reader {
  public:
    explicit Reader(const sandbox::Source& source) : source_(source) {}

    void bytes(void* to, std::size_t size) {
        if (!source_(to, size)) throw sandbox::WireError();
    }
    std::uint64_t count(std::uint64_t max) {
        std::uint64_t value = 0;
        bytes(&value, sizeof(value));
        if (value > max) throw sandbox::WireError();
        return value;
    }
    double number() {
        double value = 0.0;
        bytes(&value, sizeof(value));
        if (!std::isfinite(value)) throw sandbox::WireError();
        return value;
    }
    static double require_factor(double value) {
        if (!(value >= 1e-6 && value <= 1e6)) throw sandbox::WireError();
        return value;
    }
    double factor() { return require_factor(number()); }
    std::string text() {
        std::string result(count(kMaxTextBytes), '\0');
        bytes(result.data(), result.size());
        return result;
    }
    RasterFacts facts() {
        constexpr std::uint64_t kMaxSide = INT32_MAX;  // a part of a larger raster may be read
        RasterFacts facts;
        facts.columns = static_cast<std::int64_t>(count(kMaxSide));
        facts.rows = static_cast<std::int64_t>(count(kMaxSide));
        facts.has_place = count(1) == 1;
        for (double& value : facts.south_west_centre) value = number();
        for (double& value : facts.cell) value = number();
        if (const std::uint64_t flag = count(kNone); flag <= 1) facts.is_geographic = flag == 1;
        facts.metres_per_unit = factor();
        for (double& value : facts.ground_scale) value = factor();
        if (const double unit = number(); unit != 0.0) facts.height_unit = require_factor(unit);
        facts.rows_from_south = count(1) == 1;
        facts.full_scale = number();
        facts.crs = text();
        facts.definition = text();
        for (std::uint64_t left = count(kMaxNotes); left > 0; --left) facts.notes.push_back(text());
        return facts;
    }

  private:
    const sandbox::Source& source_;
};

}  // namespace

void encode(const std::function<void(const RasterReceiver&)>& read, const sandbox::Sink& sink) {
    Writer writer(sink);
    try {
        read({.begin = [&](const RasterFacts& facts) { writer.facts(facts); },
              .row = [&](std::span<const float> row) { writer.row(row); }});
    } catch (const RasterFault& fault) {
        writer.kind(Kind::fault);
        writer.text(fault.what());
    }
}

namespace {

/// Reads the kind of the next message. Throws a fault that was sent in its place.
void require_next(Reader& reader, Kind kind) {
    const auto got = static_cast<Kind>(reader.count(UINT64_MAX));
    if (got == Kind::fault) {
        const std::string words = text::printable(reader.text(), kMaxTextBytes);
        throw RasterFault(words.empty() ? "cannot be read" : words);
    }
    if (got != kind) throw sandbox::WireError();
}

}  // namespace

RasterFacts decode_facts(const sandbox::Source& source) {
    Reader reader(source);
    require_next(reader, Kind::facts);
    return reader.facts();
}

void decode(const sandbox::Source& source, const RasterReceiver& receiver) {
    const RasterFacts facts = decode_facts(source);
    receiver.begin(facts);
    Reader reader(source);
    std::vector<float> row(static_cast<std::size_t>(facts.columns));
    for (std::int64_t i = 0; i < facts.rows; ++i) {
        require_next(reader, Kind::row);
        reader.bytes(row.data(), row.size() * sizeof(float));
        receiver.row(row);
    }
}

}  // namespace ocean::elevation
