// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/internal/bridge/endpoint.hpp"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>

#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/text.hpp"

namespace ocean::bridge {
namespace {

bool is_ipv6(const std::string& host) {
    return host.find(':') != std::string::npos;
}

}  // namespace

std::string Endpoint::text() const {
    const std::string shown = is_ipv6(host) ? '[' + host + ']' : host;
    return shown + ':' + std::to_string(port);
}

bool Endpoint::is_loopback() const {
    in_addr four{};
    if (::inet_pton(AF_INET, host.c_str(), &four) == 1) {
        return (ntohl(four.s_addr) >> 24) == 127;
    }
    in6_addr six{};
    if (::inet_pton(AF_INET6, host.c_str(), &six) == 1) return IN6_IS_ADDR_LOOPBACK(&six) != 0;
    return host == "localhost";
}

Endpoint parse_endpoint(std::string_view text, const std::string& what,
                        unsigned short default_port) {
    constexpr std::size_t kMaxHostBytes = 255;
    const auto refused = [&] {
        const std::string given = text::printable(text);
        const std::string allowed = "HOST:PORT, such as " +
                                    Endpoint{"127.0.0.1", default_port}.text() + " or " +
                                    Endpoint{"::1", default_port}.text();
        return Error(ErrorKind::invalid_value, what + " " + given + ": allowed: " + allowed,
                     {.parameter = what, .value = given, .allowed = allowed});
    };
    Endpoint endpoint{.port = default_port};
    std::string_view rest = text;
    if (rest.starts_with('[')) {
        const std::size_t end = rest.find(']');
        if (end == std::string_view::npos) throw refused();
        endpoint.host = rest.substr(1, end - 1);
        rest.remove_prefix(end + 1);
        in6_addr six{};
        if (::inet_pton(AF_INET6, endpoint.host.c_str(), &six) != 1) throw refused();
    } else {
        endpoint.host = rest.substr(0, rest.find(':'));
        rest.remove_prefix(endpoint.host.size());
    }
    const bool plain =
        std::ranges::all_of(endpoint.host, [](char c) { return c > ' ' && c < 127; });
    if (endpoint.host.empty() || endpoint.host.size() > kMaxHostBytes || !plain) throw refused();
    if (rest.empty()) return endpoint;
    if (!rest.starts_with(':')) throw refused();
    try {
        endpoint.port =
            static_cast<unsigned short>(parse_whole_number(rest.substr(1), "port", 0, 65535));
    } catch (const Error&) {
        throw refused();
    }
    return endpoint;
}

std::vector<std::string> network_interfaces() {
    std::vector<std::string> interfaces;
    ifaddrs* first = nullptr;
    if (::getifaddrs(&first) != 0) return interfaces;
    for (const ifaddrs* entry = first; entry != nullptr; entry = entry->ifa_next) {
        if (entry->ifa_addr == nullptr || (entry->ifa_flags & IFF_UP) == 0) continue;
        const int family = entry->ifa_addr->sa_family;
        const void* address = nullptr;
        if (family == AF_INET) {
            address = &reinterpret_cast<const sockaddr_in*>(entry->ifa_addr)->sin_addr;
        } else if (family == AF_INET6) {
            address = &reinterpret_cast<const sockaddr_in6*>(entry->ifa_addr)->sin6_addr;
        }
        std::array<char, INET6_ADDRSTRLEN> text{};
        if (address == nullptr ||
            ::inet_ntop(family, address, text.data(), text.size()) == nullptr) {
            continue;
        }
        interfaces.push_back(std::string(entry->ifa_name) + ' ' + text.data());
    }
    ::freeifaddrs(first);
    return interfaces;
}

std::string read_token(const std::string& path) {
    constexpr std::size_t kMinBytes = 16;
    constexpr std::size_t kMaxBytes = 256;
    const auto refused = [&](const std::string& why) {
        return text::error_at(ErrorKind::bad_file, path, 0, why);
    };
    std::string token = text::read_file(path, std::size_t{1} << 20);
    struct stat status {};
    if (::stat(path.c_str(), &status) == 0 && (status.st_mode & 077u) != 0) {
        throw refused(
            "other users may read this token; allowed: a file that only its owner reads, mode 600");
    }
    while (token.ends_with('\n') || token.ends_with('\r')) token.pop_back();
    const bool plain = std::ranges::all_of(token, [](char c) { return c > ' ' && c < 127; });
    if (!plain || token.size() < kMinBytes || token.size() > kMaxBytes) {
        throw refused(
            "is not a token; allowed: one line of 16 .. 256 ASCII characters without blanks");
    }
    return token;
}

bool same_token(std::string_view guess, std::string_view token) {
    unsigned different = guess.size() == token.size() ? 0 : 1;
    for (std::size_t i = 0; i < guess.size(); ++i) {
        const char other = token.empty() ? '\0' : token[i % token.size()];
        different |= static_cast<unsigned char>(guess[i] ^ other);
    }
    return different == 0 && !token.empty();
}

void require_descriptors(std::size_t count) {
    constexpr rlim_t kOthers = 64;  // other open descriptors of the program
    rlimit limit{};
    if (::getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
    const rlim_t needed = static_cast<rlim_t>(count) + kOthers;
    if (limit.rlim_cur >= needed) return;
    const rlim_t allowed = limit.rlim_max;
    limit.rlim_cur = needed;
    if (allowed >= needed && ::setrlimit(RLIMIT_NOFILE, &limit) == 0) return;
    throw Error(ErrorKind::unsupported,
                std::to_string(count) + " clients need " + std::to_string(needed) +
                    " descriptors; this system allows " + std::to_string(allowed) +
                    " (ulimit -Hn), enough for " +
                    std::to_string(allowed > kOthers ? allowed - kOthers : 0) + " clients");
}

}  // namespace ocean::bridge
