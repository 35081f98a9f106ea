// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// SHA-256 by Windows. See sha256.hpp.
#define WIN32_LEAN_AND_MEAN
#define NOMINMAX
#include <windows.h>
// The header below needs the types of the header above.
#include <bcrypt.h>

#include <algorithm>
#include <stdexcept>

#include "sha256.hpp"

namespace ocean {
namespace {

void require(NTSTATUS status) {
    if (status != 0) throw std::runtime_error("Windows cannot compute SHA-256");
}

}  // namespace

struct Sha256::Impl {
    Impl() {
        require(BCryptCreateHash(BCRYPT_SHA256_ALG_HANDLE, &hash, nullptr, 0, nullptr, 0, 0));
    }
    ~Impl() { BCryptDestroyHash(hash); }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    BCRYPT_HASH_HANDLE hash = nullptr;
};

Sha256::Sha256() : impl_(std::make_unique<Impl>()) {}

Sha256::~Sha256() = default;

void Sha256::add(std::string_view bytes) {
    constexpr std::size_t kBlock = std::size_t{1} << 30;  // a call takes less than 4 GiB
    for (; !bytes.empty(); bytes.remove_prefix(std::min(kBlock, bytes.size()))) {
        const std::string_view block = bytes.substr(0, kBlock);
        auto* const data = reinterpret_cast<unsigned char*>(const_cast<char*>(block.data()));
        require(BCryptHashData(impl_->hash, data, static_cast<ULONG>(block.size()), 0));
    }
}

std::array<unsigned char, 32> Sha256::digest() {
    std::array<unsigned char, 32> digest{};
    require(BCryptFinishHash(impl_->hash, digest.data(), digest.size(), 0));
    return digest;
}

}  // namespace ocean
