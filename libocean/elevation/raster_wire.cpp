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
constexpr std::uint64_t kNone = 99;  // of an optional enumerator or flag

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
        count(facts.height_unit ? static_cast<std::uint64_t>(*facts.height_unit) : kNone);
        number(facts.full_scale);
        text(facts.crs);
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
    std::string text() {
        std::string result(count(kMaxTextBytes), '\0');
        bytes(result.data(), result.size());
        return result;
    }
    RasterFacts facts() {
        constexpr std::uint64_t kMaxSide = static_cast<std::uint64_t>(kMaxElevationSide);
        RasterFacts facts;
        facts.columns = static_cast<std::int64_t>(count(kMaxSide));
        facts.rows = static_cast<std::int64_t>(count(kMaxSide));
        facts.has_place = count(1) == 1;
        for (double& value : facts.south_west_centre) value = number();
        for (double& value : facts.cell) value = number();
        if (const std::uint64_t flag = count(kNone); flag <= 1) facts.is_geographic = flag == 1;
        facts.metres_per_unit = number();
        if (const std::uint64_t unit = count(kNone); unit < kHeightUnitWords.size()) {
            facts.height_unit = static_cast<HeightUnit>(unit);
        }
        facts.full_scale = number();
        facts.crs = text();
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

void decode(const sandbox::Source& source, const RasterReceiver& receiver) {
    Reader reader(source);
    std::vector<float> row;
    const auto next_is = [&](Kind kind) {
        const auto got = static_cast<Kind>(reader.count(UINT64_MAX));
        if (got == Kind::fault) {
            const std::string words = text::printable(reader.text(), kMaxTextBytes);
            throw RasterFault(words.empty() ? "cannot be read" : words);
        }
        return got == kind;
    };
    if (!next_is(Kind::facts)) throw sandbox::WireError();
    const RasterFacts facts = reader.facts();
    receiver.begin(facts);
    row.resize(static_cast<std::size_t>(facts.columns));
    for (std::int64_t i = 0; i < facts.rows; ++i) {
        if (!next_is(Kind::row)) throw sandbox::WireError();
        reader.bytes(row.data(), row.size() * sizeof(float));
        receiver.row(row);
    }
}

}  // namespace ocean::elevation
