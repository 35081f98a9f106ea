// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The border between C++ and C: exceptions become codes and a sentence per thread, structs of other
// versions become this version's. Every function of libocean.h that can fail runs inside guarded().
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "libocean.h"
#include "ocean/error.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/version.hpp"

namespace ocean::capi {

/// A fault of the call itself, with the code it returns.
class CallError : public std::runtime_error {
  public:
    CallError(ocean_result code, const std::string& message)
        : CallError(code, Error(ErrorKind::invalid_value, message)) {}
    /// The sentence is that of ocean::Error.
    CallError(ocean_result code, ErrorFields fields)
        : CallError(code, Error(ErrorKind::invalid_value, std::move(fields))) {}

    CallError(ocean_result code, const Error& said)
        : std::runtime_error(said.what()), code_(code), fields_(said.fields()) {}

    ocean_result code() const noexcept { return code_; }
    const ErrorFields& fields() const noexcept { return fields_; }

  private:
    ocean_result code_;
    ErrorFields fields_;
};

[[noreturn]] inline void refuse(const std::string& message) {
    throw CallError(OCEAN_INVALID_ARGUMENT, message);
}
[[noreturn]] inline void refuse(ErrorFields fields) {
    throw CallError(OCEAN_INVALID_ARGUMENT, std::move(fields));
}
inline void require(const void* argument, const char* name) {
    if (argument == nullptr) refuse(std::string(name) + " is NULL");
}
/// Throws CallError for a value other than 0 of the member of that name.
void require_reserved(std::int32_t value, const std::string& name);
/// Throws CallError for an infinite value or none of the argument or member of that name.
void require_finite(double value, const std::string& name, const char* unit);

/// The sentence of this thread's last failure; never NULL.
const char* last_error() noexcept;
/// Returns the part OCEAN_ERROR_... of it; "" where it has no such part.
const char* last_error_field(std::int32_t field) noexcept;
/// The code of the exception being handled; keeps its sentence and its parts. Only inside a catch
/// block.
ocean_result translate_exception() noexcept;

/// Runs `body` so that nothing is thrown out of it.
template <typename Body>
ocean_result guarded(Body&& body) noexcept {
    const PlainFloats plain;
    try {
        std::forward<Body>(body)();
        return OCEAN_OK;
    } catch (...) {
        return translate_exception();
    }
}

/// Throws CallError OCEAN_BUFFER_TOO_SMALL "NAME = GIVEN; WHY" if there is room for fewer elements
/// than needed.
void require_capacity(const char* name, std::size_t given, std::size_t needed,
                      const std::string& why);
/// Calls use(name, value) for each pair of two lists of texts. Throws CallError for NULL.
template <typename Use>
void for_each_value(const char* const* names, const char* const* values, std::size_t count,
                    const Use& use) {
    if (count == 0) return;
    require(names, "names");
    require(values, "values");
    for (std::size_t i = 0; i < count; ++i) {
        require(names[i], ("names[" + std::to_string(i) + "]").c_str());
        require(values[i], ("values[" + std::to_string(i) + "]").c_str());
        use(names[i], values[i]);
    }
}

/// Copies a text result as libocean.h promises for `out` and `size`.
void copy_text(std::string_view text, char* out, std::size_t* size);

/// Largest struct_size that is believed to be one.
inline constexpr std::size_t kMaxStructSize = 4096;

/// Throws CallError for a size that no version of a struct has had. `member` is the member or
/// argument that holds the size.
inline void require_struct_size(std::size_t size, std::size_t minimum, const std::string& member,
                                const std::string& name, std::size_t here) {
    if (size >= minimum && size <= kMaxStructSize && size % alignof(std::int32_t) == 0) return;
    const std::string given = std::to_string(size);
    const std::string what = "set it to sizeof(" + name + "), here " + std::to_string(here);
    throw CallError(OCEAN_INVALID_ARGUMENT,
                    Error(ErrorKind::invalid_value, member + " = " + given + "; " + what,
                          {.what = what, .parameter = member, .value = given}));
}

/// The caller's `size` bytes as this version's struct: what is missing is 0.
template <typename Struct>
Struct read_bytes(const void* given, std::size_t size, const std::string& name) {
    const auto* bytes = static_cast<const unsigned char*>(given);
    for (std::size_t i = sizeof(Struct); i < size; ++i) {
        if (bytes[i] != 0) {
            throw CallError(OCEAN_UNSUPPORTED, name + " of " + std::to_string(size) +
                                                   " bytes asks for what this older library "
                                                   "(version " OCEAN_VERSION ") does not have");
        }
    }
    Struct result{};
    std::memcpy(&result, given, std::min(size, sizeof(Struct)));
    return result;
}

/// The caller's struct, the argument of that name: `minimum` bytes must be there.
template <typename Struct>
Struct read_struct(const Struct* given, std::size_t minimum, const std::string& name,
                   const char* argument = "request") {
    require(given, argument);
    require_struct_size(given->struct_size, minimum, name + ".struct_size", name, sizeof(Struct));
    return read_bytes<Struct>(given, given->struct_size, name);
}

}  // namespace ocean::capi
