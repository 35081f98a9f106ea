// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The numbers of types, fields and sections are from Pixar's crate format, as usd-core reads it.
#include "usd_crate.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <fstream>
#include <iterator>

#include "ocean/error.hpp"
#include "ocean/internal/platform.hpp"

namespace ocean::io {
namespace {

static_assert(std::endian::native == std::endian::little);

// Bits of a value's reference: its type, then its offset or the value itself.
constexpr std::uint64_t kIsArray = std::uint64_t{1} << 63;
constexpr std::uint64_t kIsInline = std::uint64_t{1} << 62;
enum Type : unsigned {
    kInt = 3,
    kFloat = 8,
    kString = 10,
    kToken = 11,
    kVec2f = 20,
    kVec3f = 24,
    kVec4f = 28,
    kTokenVector = 41,
    kSpecifier = 42,
    kVariability = 44,
    kTimeSamples = 46,
    kDoubleVector = 48,
};
constexpr std::uint64_t kUniform = 1;
// The kind of object that a path leads to.
constexpr std::uint32_t kAttribute = 1, kPrim = 6, kPseudoRoot = 7;

constexpr std::array<char, 16> kIdent = {'P', 'X', 'R', '-', 'U', 'S', 'D', 'C', 0, 8, 0};
constexpr std::size_t kHeaderBytes = 88;
constexpr std::size_t kSectionName = 16;

UsdCrate::Value value_of(unsigned type, std::uint64_t payload, std::uint64_t flags = 0) {
    return flags | std::uint64_t{type} << 48 | payload;
}

template <typename Number>
void append(std::string& bytes, Number number) {
    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

/// Returns one chunk with an LZ4 block that is a single run of literals.
std::string lz4(const std::string& bytes) {
    constexpr std::size_t kShort = 15, kMore = 255;
    std::string block(1, '\0');
    if (bytes.size() < kShort) {
        block += static_cast<char>(bytes.size() << 4);
    } else {
        const std::size_t rest = bytes.size() - kShort;
        block += '\xf0';
        block.append(rest / kMore, '\xff');
        block += static_cast<char>(rest % kMore);
    }
    return block + bytes;
}

std::string packed(const std::string& bytes) {
    const std::string block = lz4(bytes);
    std::string section;
    append(section, static_cast<std::uint64_t>(block.size()));
    return section + block;
}

/// Returns the 32-bit differences of integers: the common one (0), two bits for the width of each,
/// then the differences.
std::string integers_packed(std::span<const std::uint32_t> values) {
    std::string bytes;
    append(bytes, std::int32_t{0});
    bytes.append(values.size() / 4, '\xff');
    if (const std::size_t rest = values.size() % 4; rest > 0) {
        bytes += static_cast<char>((1U << 2 * rest) - 1);
    }
    std::uint32_t before = 0;
    for (const std::uint32_t value : values) append(bytes, value - std::exchange(before, value));
    return packed(bytes);
}

}  // namespace

UsdCrate::UsdCrate(OutputFile& file, std::string name, std::string type)
    : file_(file), name_(std::move(name)), type_(std::move(type)) {
    const std::array<char, kHeaderBytes> later{};
    put(later.data(), later.size());
    token_number("");
}

void UsdCrate::put(const void* bytes, std::size_t count) {
    file_.write({static_cast<const char*>(bytes), count});
    position_ += count;
}

std::uint64_t UsdCrate::align() {
    constexpr std::array<char, 8> kZeros{};
    put(kZeros.data(), (kZeros.size() - position_ % kZeros.size()) % kZeros.size());
    return position_;
}

std::uint32_t UsdCrate::token_number(const std::string& text) {
    const auto [found, is_new] =
        token_numbers_.try_emplace(text, static_cast<std::uint32_t>(tokens_.size()));
    if (is_new) tokens_.push_back(text);
    return found->second;
}

UsdCrate::Value UsdCrate::token(const std::string& text) {
    return value_of(kToken, token_number(text), kIsInline);
}

UsdCrate::Value UsdCrate::string(const std::string& text) {
    strings_.push_back(token_number(text));
    return value_of(kString, strings_.size() - 1, kIsInline);
}

UsdCrate::Value UsdCrate::array(const void* values, std::size_t elements, std::size_t bytes,
                                unsigned type) {
    const std::uint64_t at = align();
    put_number(static_cast<std::uint64_t>(elements));
    put(values, bytes);
    return value_of(type, at, kIsArray);
}

UsdCrate::Value UsdCrate::floats(std::span<const float> values, int components) {
    constexpr std::array kTypes = {kFloat, kVec2f, kVec3f, kVec4f};
    const auto count = static_cast<std::size_t>(components);
    return array(values.data(), values.size() / count, values.size_bytes(), kTypes[count - 1]);
}

UsdCrate::Value UsdCrate::integers(std::span<const int> values) {
    return array(values.data(), values.size(), values.size_bytes(), kInt);
}

UsdCrate::Value UsdCrate::token_list(std::span<const std::string> tokens) {
    const std::uint64_t at = align();
    put_number(static_cast<std::uint64_t>(tokens.size()));
    for (const std::string& text : tokens) put_number(token_number(text));
    return value_of(kTokenVector, at);
}

void UsdCrate::add_default(const std::string& name, const std::string& type, Value value) {
    token_number(name);
    attributes_.push_back({name, kAttribute, {{"typeName", token(type)}, {"default", value}}});
}

void UsdCrate::add_uniform(const std::string& name, const std::string& type, Value value) {
    add_default(name, type, value);
    attributes_.back().fields.emplace_back("variability",
                                           value_of(kVariability, kUniform, kIsInline));
}

void UsdCrate::add_sample(const std::string& name, const std::string& type, double time_code,
                          Value value) {
    constexpr std::int64_t kNext = 8;  // the value follows its reference
    const std::uint64_t times = align();
    put_number(std::uint64_t{1});
    put_number(time_code);
    const std::uint64_t samples = align();
    put_number(kNext);
    put_number(value_of(kDoubleVector, times));
    put_number(kNext);
    put_number(std::uint64_t{1});
    put_number(value);
    attributes_.push_back(
        {name,
         kAttribute,
         {{"typeName", token(type)}, {"timeSamples", value_of(kTimeSamples, samples)}}});
}

void UsdCrate::section(std::string_view name, const std::string& bytes) {
    sections_.push_back({std::string(name), align(), bytes.size()});
    put(bytes.data(), bytes.size());
}

void UsdCrate::finish() {
    std::vector<std::string> names;
    for (const Spec& attribute : attributes_) names.push_back(attribute.name);
    const std::string prim[] = {name_};
    std::vector<Spec> specs = {
        {"", kPseudoRoot, {{"defaultPrim", token(name_)}, {"primChildren", token_list(prim)}}},
        {name_,
         kPrim,
         {{"specifier", value_of(kSpecifier, 0, kIsInline)},
          {"typeName", token(type_)},
          {"properties", token_list(names)}}}};
    std::ranges::move(attributes_, std::back_inserter(specs));

    // The paths are the root, the prim below it, and the attributes as siblings below the prim.
    constexpr std::uint32_t kOnlyChild = static_cast<std::uint32_t>(-1), kSibling = 0,
                            kLeafAndLast = static_cast<std::uint32_t>(-2), kEndOfSet = ~0U;
    std::vector<std::uint32_t> field_tokens, field_sets, path_numbers, elements, jumps, set_starts,
        kinds;
    std::string field_values;
    for (const Spec& spec : specs) {
        const auto number = static_cast<std::uint32_t>(path_numbers.size());
        path_numbers.push_back(number);
        set_starts.push_back(static_cast<std::uint32_t>(field_sets.size()));
        kinds.push_back(spec.kind);
        for (const auto& [name, value] : spec.fields) {
            field_sets.push_back(static_cast<std::uint32_t>(field_tokens.size()));
            field_tokens.push_back(token_number(name));
            append(field_values, value);
        }
        field_sets.push_back(kEndOfSet);
        const std::uint32_t element = token_number(spec.name);
        // Indices of property names are negative.
        elements.push_back(spec.kind == kAttribute ? 0U - element : element);
        const bool last = number + 1 == specs.size();
        jumps.push_back(last ? kLeafAndLast : spec.kind == kAttribute ? kSibling : kOnlyChild);
    }

    const auto count_of = [](std::size_t count) {
        std::string bytes;
        append(bytes, static_cast<std::uint64_t>(count));
        return bytes;
    };
    std::string texts;
    for (const std::string& text : tokens_) texts += text + '\0';
    section("TOKENS", count_of(tokens_.size()) + count_of(texts.size()) + packed(texts));
    std::string strings = count_of(strings_.size());
    for (const std::uint32_t token : strings_) append(strings, token);
    section("STRINGS", strings);
    section("FIELDS",
            count_of(field_tokens.size()) + integers_packed(field_tokens) + packed(field_values));
    section("FIELDSETS", count_of(field_sets.size()) + integers_packed(field_sets));
    section("PATHS", count_of(specs.size()) + count_of(specs.size()) +
                         integers_packed(path_numbers) + integers_packed(elements) +
                         integers_packed(jumps));
    section("SPECS", count_of(specs.size()) + integers_packed(path_numbers) +
                         integers_packed(set_starts) + integers_packed(kinds));

    const std::uint64_t table = align();
    put_number(static_cast<std::uint64_t>(sections_.size()));
    for (const Section& part : sections_) {
        std::array<char, kSectionName> name{};
        std::ranges::copy(part.name, name.begin());
        put(name.data(), name.size());
        put_number(part.start);
        put_number(part.size);
    }
    file_.seek(0);
    put(kIdent.data(), kIdent.size());
    put_number(table);
}

// ---- reading back

namespace {

/// Reads bytes of a file at an offset.
class Reader {
  public:
    explicit Reader(const std::string& path)
        : path_(path), file_(utf8_path(path), std::ios::binary) {}

    [[noreturn]] void fail() const {
        throw Error(ErrorKind::bad_file,
                    path_ + ": is not a complete USD file that `ocean bake` wrote");
    }
    std::string bytes(std::uint64_t start, std::uint64_t count) {
        constexpr std::uint64_t kMaxReadBytes = std::uint64_t{64} << 20;
        if (count > kMaxReadBytes) fail();
        std::string bytes(count, '\0');
        file_.clear();
        file_.seekg(static_cast<std::streamoff>(start));
        file_.read(bytes.data(), static_cast<std::streamsize>(count));
        if (!file_) fail();
        return bytes;
    }
    std::uint64_t number(std::uint64_t start) {
        std::uint64_t number = 0;
        std::memcpy(&number, bytes(start, sizeof number).data(), sizeof number);
        return number;
    }

  private:
    const std::string& path_;
    std::ifstream file_;
};

struct Place {
    std::uint64_t start = 0;
    std::uint64_t size = 0;
};

Place find_section(Reader& file, std::string_view wanted) {
    constexpr std::uint64_t kEntry = kSectionName + 16, kMaxSections = 64;
    if (file.bytes(0, 8) != std::string_view(kIdent.data(), 8)) file.fail();
    const std::uint64_t table = file.number(kIdent.size());
    const std::uint64_t count = file.number(table);
    if (count > kMaxSections) file.fail();
    file.bytes(table + 8,
               count * kEntry);  // reads the end of the file, which proves that it is complete
    for (std::uint64_t i = 0; i < count; ++i) {
        const std::uint64_t entry = table + 8 + i * kEntry;
        const std::string name = file.bytes(entry, kSectionName);
        if (std::string_view(name.c_str()) != wanted) continue;
        return {file.number(entry + kSectionName), file.number(entry + kSectionName + 8)};
    }
    file.fail();
}

/// Returns all tokens of a block of literals that lz4() made.
std::vector<std::string> read_tokens(Reader& file) {
    const Place place = find_section(file, "TOKENS");
    constexpr std::uint64_t kNumbers = 24;
    if (place.size < kNumbers) file.fail();
    const std::uint64_t count = file.number(place.start);
    const std::uint64_t size = file.number(place.start + 8);
    const std::uint64_t packed_size = file.number(place.start + 16);
    if (packed_size < size || packed_size > place.size - kNumbers) file.fail();
    const std::string texts = file.bytes(place.start + kNumbers + (packed_size - size), size);
    std::vector<std::string> tokens;
    for (std::size_t at = 0; at < texts.size();) {
        const std::size_t end = texts.find('\0', at);
        if (end == std::string::npos) file.fail();
        tokens.push_back(texts.substr(at, end - at));
        at = end + 1;
    }
    if (tokens.size() != count) file.fail();
    return tokens;
}

}  // namespace

std::string read_usd_string(const std::string& path) {
    Reader file(path);
    const std::vector<std::string> tokens = read_tokens(file);
    const Place place = find_section(file, "STRINGS");
    constexpr std::uint64_t kOne = 8 + sizeof(std::uint32_t);
    if (place.size < kOne || file.number(place.start) == 0) file.fail();
    std::uint32_t token = 0;
    std::memcpy(&token, file.bytes(place.start + 8, sizeof token).data(), sizeof token);
    if (token >= tokens.size()) file.fail();
    return tokens[token];
}

}  // namespace ocean::io
