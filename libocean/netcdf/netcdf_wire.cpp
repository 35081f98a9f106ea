// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A content as bytes: see netcdf_wire.hpp. Numbers have the byte order of the machine; a count has
// 64 bits and precedes its elements.
#include "netcdf_wire.hpp"

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <utility>

namespace ocean::netcdf {
namespace {

enum class Kind : std::uint64_t { content = 0x6f6365616e01, fault = 0x6f6365616e02 };

class Writer {
  public:
    explicit Writer(const Sink& sink) : sink_(sink) {}
    void count(std::uint64_t value) { sink_(&value, sizeof(value)); }
    void text(std::string_view text) {
        const std::string_view part = text.substr(0, kMaxTextBytes);
        count(part.size());
        sink_(part.data(), part.size());
    }
    void attributes(const std::map<std::string, std::string>& all) {
        count(all.size());
        for (const auto& [key, value] : all) {
            text(key);
            text(value);
        }
    }
    void variable(const Variable& v) {
        text(v.name);
        count(v.dimensions.size());
        for (const std::size_t d : v.dimensions) count(d);
        attributes(v.attributes);
        count(v.is_text ? 1 : 0);
        count(v.is_text ? v.texts.size() : v.values.size());
        for (const std::string& t : v.texts) text(t);
        sink_(v.values.data(), v.values.size() * sizeof(double));
    }

  private:
    const Sink& sink_;
};

class Reader {
  public:
    explicit Reader(const Source& source) : source_(source) {}

    std::uint64_t count(std::uint64_t max) {
        std::uint64_t value = 0;
        bytes(&value, sizeof(value));
        if (value > max) throw WireError();
        return value;
    }
    std::string text() {
        std::string result(count(kMaxTextBytes), '\0');
        bytes(result.data(), result.size());
        return result;
    }
    std::map<std::string, std::string> attributes() {
        std::map<std::string, std::string> all;
        for (std::uint64_t left = count(kMaxAttributes); left > 0; --left) {
            std::string key = text();
            all[std::move(key)] = text();
        }
        return all;
    }
    Variable variable(const std::vector<Dimension>& dimensions) {
        Variable v;
        v.name = text();
        v.dimensions.resize(count(kMaxVariableDimensions));
        std::size_t size = 1;
        for (std::size_t& d : v.dimensions) {
            d = count(dimensions.size());
            if (d == dimensions.size()) throw WireError();
            const std::size_t factor = dimensions[d].size;
            if (size != 0 && factor > kMaxValues / size) throw WireError();
            size *= factor;
        }
        v.attributes = attributes();
        v.is_text = count(1) == 1;
        if (size > values_left_ || count(size) != size) throw WireError();
        values_left_ -= size;
        if (v.is_text) {
            for (std::size_t i = 0; i < size; ++i) v.texts.push_back(text());
        } else {
            values(v.values, size);
        }
        return v;
    }

  private:
    void bytes(void* to, std::size_t size) {
        if (!source_(to, size)) throw WireError();
    }
    /// Reads in steps, so that memory grows with the bytes received, not with the count announced.
    void values(std::vector<double>& to, std::size_t size) {
        while (to.size() < size) {
            const std::size_t begin = to.size();
            const std::size_t step = std::min(size - begin, std::max<std::size_t>(4096, begin));
            to.resize(begin + step);
            bytes(to.data() + begin, step * sizeof(double));
        }
    }

    const Source& source_;
    std::size_t values_left_ = kMaxValues;
};

}  // namespace

void encode(const Content& content, const Sink& sink) {
    Writer writer(sink);
    writer.count(static_cast<std::uint64_t>(Kind::content));
    writer.attributes(content.attributes);
    writer.count(content.dimensions.size());
    for (const Dimension& dimension : content.dimensions) {
        writer.text(dimension.name);
        writer.count(dimension.size);
    }
    writer.count(content.variables.size());
    for (const Variable& variable : content.variables) writer.variable(variable);
}

void encode(const Fault& fault, const Sink& sink) {
    Writer writer(sink);
    writer.count(static_cast<std::uint64_t>(Kind::fault));
    writer.text(fault.what());
}

Content decode(const Source& source) {
    Reader reader(source);
    const std::uint64_t kind = reader.count(UINT64_MAX);
    if (kind == static_cast<std::uint64_t>(Kind::fault)) throw Fault(reader.text());
    if (kind != static_cast<std::uint64_t>(Kind::content)) throw WireError();
    Content content;
    content.attributes = reader.attributes();
    for (std::uint64_t left = reader.count(kMaxDimensions); left > 0; --left) {
        std::string name = reader.text();
        content.dimensions.push_back({std::move(name), reader.count(UINT64_MAX)});
    }
    for (std::uint64_t left = reader.count(kMaxVariables); left > 0; --left) {
        content.variables.push_back(reader.variable(content.dimensions));
    }
    return content;
}

}  // namespace ocean::netcdf
