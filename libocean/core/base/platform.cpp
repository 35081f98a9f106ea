// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The only file of core, seafile and capi that knows which operating system it runs on.
#include "ocean/internal/platform.hpp"

#include <algorithm>
#include <clocale>
#include <new>
#include <string>
#include <thread>
#include <vector>

#include "base/control_groups.hpp"
#include "ocean/page_vector.hpp"

#if defined(_WIN32)
#define WIN32_LEAN_AND_MEAN
#define NOMINMAX
#include <windows.h>
#else
#include <locale.h>
#include <unistd.h>
#if defined(__APPLE__)
#include <xlocale.h>
#endif
#endif
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif
#if defined(__linux__)
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>

#include <ctime>
#include <fstream>
#endif

namespace ocean {

std::uint64_t process_number() {
#if defined(_WIN32)
    return 0;  // this system has no fork
#else
    return static_cast<std::uint64_t>(getpid());
#endif
}

PlainFloats::PlainFloats() {
    std::fegetenv(&host_);
    std::fesetenv(FE_DFL_ENV);
#if defined(__SSE2__)
    // MinGW's FE_DFL_ENV does not change MXCSR, which controls the rounding of the compiler's code.
    constexpr unsigned kDefaultSse = 0x1f80;
    host_sse_ = _mm_getcsr();
    _mm_setcsr(kDefaultSse);
#endif
}

PlainFloats::~PlainFloats() {
    std::fesetenv(&host_);
#if defined(__SSE2__)
    _mm_setcsr(host_sse_);
#endif
}

#if defined(_WIN32)
PointNumbers::PointNumbers()
    : host_(nullptr), host_mode_(_configthreadlocale(_ENABLE_PER_THREAD_LOCALE)) {
    host_ = new std::string(std::setlocale(LC_NUMERIC, nullptr));
    std::setlocale(LC_NUMERIC, "C");
}

PointNumbers::~PointNumbers() {
    const auto* const host = static_cast<std::string*>(host_);
    std::setlocale(LC_NUMERIC, host->c_str());
    delete host;
    _configthreadlocale(host_mode_);
}
#else
PointNumbers::PointNumbers() {
    static const locale_t point = newlocale(LC_NUMERIC_MASK, "C", nullptr);
    host_ = uselocale(point);
}

PointNumbers::~PointNumbers() {
    uselocale(static_cast<locale_t>(host_));
}
#endif

ThreadUsage usage_of_this_thread() {
#if defined(__linux__)
    rusage usage{};
    timespec time{};  // getrusage returns the time at the last tick
    if (getrusage(RUSAGE_THREAD, &usage) == 0 &&
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time) == 0) {
        return {usage.ru_nivcsw,
                static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec)};
    }
#endif
    return {};
}

#if defined(__linux__)
namespace {

/// Returns the number after `key` in a file of "Key: 123 kB" lines, in bytes.
std::uint64_t kilobytes_in(const char* path, const std::string& key) {
    std::ifstream file(path);
    std::string word;
    while (file >> word) {
        std::uint64_t value = 0;
        if (word == key && file >> value) return value * 1024;
    }
    return kUnknown;
}

std::vector<std::filesystem::path> own_control_groups() {
    return control_groups("/proc/self/cgroup", "/sys/fs/cgroup");
}

}  // namespace
#endif

int available_cores() {
    int cores = std::max(static_cast<int>(std::thread::hardware_concurrency()), 1);
#if defined(__linux__)
    cpu_set_t set;
    CPU_ZERO(&set);
    if (sched_getaffinity(0, sizeof(set), &set) == 0) cores = std::max(CPU_COUNT(&set), 1);
    cores = std::min(cores, cores_of_cgroups(own_control_groups()));
#endif
    return cores;
}

namespace {

CacheSizes read_cache_sizes() {
    CacheSizes sizes;
#if defined(__linux__)
    // On AMD, sysconf() returns the whole machine's last-level cache instead of the one that a core
    // shares.
    for (int index = 0; index < 8; ++index) {
        const std::string folder =
            "/sys/devices/system/cpu/cpu0/cache/index" + std::to_string(index) + '/';
        int level = 0;
        std::size_t kilobytes = 0;
        char unit = 0;
        std::ifstream(folder + "level") >> level;
        std::ifstream(folder + "size") >> kilobytes >> unit;
        if (kilobytes == 0 || unit != 'K') continue;
        if (level == 2) sizes.core = kilobytes << 10;
        if (level >= 2) sizes.shared = kilobytes << 10;
    }
#endif
    return sizes;
}

}  // namespace

CacheSizes cache_sizes() {
    static const CacheSizes sizes = read_cache_sizes();
    return sizes;
}

#if defined(__linux__)
std::uint64_t available_memory() {
    std::uint64_t least = kilobytes_in("/proc/meminfo", "MemAvailable:");
    least = std::min(least, memory_of_cgroups(own_control_groups()));
    struct rlimit limit {};
    if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY) {
        const std::uint64_t used = kilobytes_in("/proc/self/status", "VmSize:");
        least = std::min(least, left_of(limit.rlim_cur, used));
    }
    return least;
}
#elif defined(_WIN32)
std::uint64_t available_memory() {
    MEMORYSTATUSEX status{};
    status.dwLength = sizeof(status);
    if (!GlobalMemoryStatusEx(&status)) return kUnknown;
    return std::min(status.ullAvailPhys, status.ullAvailVirtual);
}
#else
std::uint64_t available_memory() {
    return kUnknown;
}
#endif

namespace {

constexpr std::size_t kHugePage = std::size_t{2} << 20;

std::align_val_t page_alignment(std::size_t bytes) {
    return std::align_val_t{bytes >= kHugePage ? kHugePage : 64};
}

}  // namespace

void* allocate_pages(std::size_t bytes) {
    if (bytes == 0) return nullptr;
    void* const pages = ::operator new(bytes, page_alignment(bytes));
#if defined(__linux__)
    // This is a hint: without it the array works, somewhat more slowly.
    if (bytes >= kHugePage) static_cast<void>(madvise(pages, bytes, MADV_HUGEPAGE));
#endif
    return pages;
}

void free_pages(void* pages, std::size_t bytes) {
    if (pages != nullptr) ::operator delete(pages, page_alignment(bytes));
}

std::filesystem::path utf8_path(std::string_view text) {
    return std::filesystem::path(std::u8string(text.begin(), text.end()));
}

}  // namespace ocean
