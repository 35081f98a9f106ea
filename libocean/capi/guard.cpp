// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The one place where exceptions end: each kind of failure has its code, and its sentence and
// the parts of it are kept for the thread that failed.
#include "guard.hpp"

#include <cmath>
#include <new>

namespace ocean::capi {
namespace {

/// Plain bytes: they need no memory when there is none, and no destructor when a host unloads the
/// library while its threads live on.
struct KeptText {
    static constexpr std::size_t kMaxBytes = 2048;
    char bytes[kMaxBytes];

    void keep(const char* text) noexcept {
        std::size_t length = std::strlen(text);
        if (length >= kMaxBytes) {
            length = kMaxBytes - 1;
            // Never half a UTF-8 character: step back over continuation bytes 10xxxxxx.
            while (length > 0 && (static_cast<unsigned char>(text[length]) & 0xC0u) == 0x80u)
                --length;
        }
        std::memmove(bytes, text, length);
        bytes[length] = '\0';
    }
};

struct KeptError {
    KeptText sentence, what, parameter, value, allowed;
};
thread_local KeptError kept{};

void keep(const char* sentence, const ErrorFields& fields) noexcept {
    kept.sentence.keep(sentence);
    kept.what.keep(fields.what.c_str());
    kept.parameter.keep(fields.parameter.c_str());
    kept.value.keep(fields.value.c_str());
    kept.allowed.keep(fields.allowed.c_str());
}

/// Keeps an error that is a sentence and nothing else. Allocates nothing.
void keep(const char* sentence) noexcept {
    kept = {};
    kept.sentence.keep(sentence);
    kept.what.keep(sentence);
}

ocean_result code_of(ErrorKind kind) noexcept {
    switch (kind) {
        case ErrorKind::invalid_value:
            return OCEAN_INVALID_VALUE;
        case ErrorKind::bad_file:
            return OCEAN_BAD_FILE;
        case ErrorKind::not_found:
            return OCEAN_NOT_FOUND;
        case ErrorKind::unsupported:
        case ErrorKind::no_gpu:
            return OCEAN_UNSUPPORTED;
        case ErrorKind::output:
            return OCEAN_OUTPUT;
        case ErrorKind::out_of_memory:
            return OCEAN_OUT_OF_MEMORY;
        case ErrorKind::interrupted:
            break;  // only programs are interrupted, not libraries
    }
    return OCEAN_INTERNAL;
}

}  // namespace

const char* last_error() noexcept {
    return kept.sentence.bytes;
}

const char* last_error_field(std::int32_t field) noexcept {
    switch (field) {
        case OCEAN_ERROR_WHAT:
            return kept.what.bytes;
        case OCEAN_ERROR_PARAMETER:
            return kept.parameter.bytes;
        case OCEAN_ERROR_VALUE:
            return kept.value.bytes;
        case OCEAN_ERROR_ALLOWED:
            return kept.allowed.bytes;
        default:
            return "";  // of a newer header
    }
}

ocean_result translate_exception() noexcept {
    try {
        throw;
    } catch (const CallError& error) {
        keep(error.what(), error.fields());
        return error.code();
    } catch (const Error& error) {
        keep(error.what(), error.fields());
        return code_of(error.kind());
    } catch (const std::bad_alloc&) {
        keep("out of memory");
        return OCEAN_OUT_OF_MEMORY;
    } catch (const std::exception& error) {
        keep(error.what());
    } catch (...) {
        keep("a failure of unknown kind");
    }
    return OCEAN_INTERNAL;
}

void require_reserved(std::int32_t value, const std::string& name) {
    if (value == 0) return;
    refuse({.parameter = name, .value = std::to_string(value), .allowed = "0"});
}

void require_finite(double value, const std::string& name, const char* unit) {
    if (std::isfinite(value)) return;
    refuse({.parameter = name,
            .value = std::to_string(value),
            .allowed = std::string("a finite number of ") + unit});
}

void require_capacity(const char* name, std::size_t given, std::size_t needed,
                      const std::string& why) {
    if (given >= needed) return;
    throw CallError(OCEAN_BUFFER_TOO_SMALL,
                    std::string(name) + " = " + std::to_string(given) + "; " + why);
}

void copy_text(std::string_view text, char* out, std::size_t* size) {
    require(size, "size");
    const std::size_t capacity = std::exchange(*size, text.size() + 1);
    if (out == nullptr) return;
    if (capacity <= text.size()) {
        throw CallError(OCEAN_BUFFER_TOO_SMALL,
                        "the text needs " + std::to_string(text.size() + 1) +
                            " bytes, its final 0 included; out has " + std::to_string(capacity));
    }
    text.copy(out, text.size());
    out[text.size()] = '\0';
}

}  // namespace ocean::capi
