// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Atomic output. A temporary `.NAME.ocean-PID-COUNT.tmp` is locked while its writer is running, so
// that a later run can distinguish the leftovers of a killed process from a file that another
// process is writing. Writers do not handle signals: an interrupted program finishes or abandons a
// file between two frames.
#include "ocean/internal/io/output_file.hpp"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <filesystem>
#include <system_error>

#ifdef _WIN32
#include <io.h>
#include <process.h>
#else
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

#include "ocean/error.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/internal/text.hpp"

namespace ocean::io {
namespace {

constexpr std::string_view kMark = ".ocean-";
constexpr std::string_view kSuffix = ".tmp";

// The calls for which C++ has no portable function. Windows does not remove open files, so that the
// temporary needs no lock there.
#ifdef _WIN32
int process_id() {
    return _getpid();
}
bool sync_to_disk(std::FILE* file) {
    return _commit(_fileno(file)) == 0;
}
bool claim(std::FILE*) {
    return true;
}
int keep_lock(std::FILE*) {
    return -1;
}
void release_lock(int) {}
bool seek_to(std::FILE* file, std::uint64_t position) {
    return _fseeki64(file, static_cast<long long>(position), SEEK_SET) == 0;
}
long long position_of(std::FILE* file) {
    return _ftelli64(file);
}
bool abandoned(const std::filesystem::path&) {
    return true;
}
bool may_write(const std::filesystem::path&) {
    return true;
}
int lock_folder(const std::string&) {
    return -1;
}
#else
int process_id() {
    return static_cast<int>(getpid());
}

bool sync_to_disk(std::FILE* file) {
    int result = 0;
    do {
        result = fsync(fileno(file));
    } while (result != 0 && errno == EINTR);
    // Pipes and devices cannot be synchronised with a disk.
    return result == 0 || errno == EINVAL || errno == ENOTSUP;
}

// Returns false if a cleaner removed the file between its creation and this lock.
bool claim(std::FILE* file) {
    flock(fileno(file), LOCK_EX);
    struct stat status {};
    return fstat(fileno(file), &status) == 0 && status.st_nlink > 0;
}

// A second descriptor of the open file keeps the lock after the stream is closed.
int keep_lock(std::FILE* file) {
    return dup(fileno(file));
}
void release_lock(int descriptor) {
    if (descriptor >= 0) close(descriptor);
}

bool seek_to(std::FILE* file, std::uint64_t position) {
    return fseeko(file, static_cast<off_t>(position), SEEK_SET) == 0;
}
long long position_of(std::FILE* file) {
    return static_cast<long long>(ftello(file));
}

bool may_write(const std::filesystem::path& folder) {
    return access(folder.c_str(), W_OK | X_OK) == 0;
}

int lock_folder(const std::string& folder) {
    const int descriptor =
        open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    while (descriptor >= 0 && flock(descriptor, LOCK_EX) != 0 && errno == EINTR) continue;
    return descriptor;
}

bool abandoned(const std::filesystem::path& path) {
    const int descriptor = open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW);
    if (descriptor < 0) return false;
    // The lock is kept until the file is removed: see claim().
    const bool unused = flock(descriptor, LOCK_EX | LOCK_NB) == 0 && unlink(path.c_str()) == 0;
    close(descriptor);
    return unused;
}
#endif

/// Returns the folder, or its nearest parent that exists.
std::filesystem::path nearest_existing(const std::string& folder) {
    std::error_code code;
    std::filesystem::path place =
        std::filesystem::absolute(utf8_path(folder.empty() ? "." : folder), code);
    while (!std::filesystem::exists(place, code) && place.has_relative_path()) {
        place = place.parent_path();
    }
    return place;
}

/// Returns the path that links lead to, also where nothing is there yet.
std::filesystem::path behind_links(std::filesystem::path path) {
    constexpr int kMaxLinks = 40;  // as Linux follows
    std::error_code code;
    for (int links = 0; links < kMaxLinks && std::filesystem::is_symlink(path, code); ++links) {
        path = path.parent_path() / std::filesystem::read_symlink(path, code);
    }
    return path;
}

}  // namespace

FolderLock::FolderLock(const std::string& folder) : descriptor_(lock_folder(folder)) {}

FolderLock::~FolderLock() {
    release_lock(descriptor_);
}

OutputFile::OutputFile(const std::string& path) : path_(path), target_(path) {
    std::error_code error;
    const auto native = utf8_path(path);
    const auto status = std::filesystem::status(native, error);
    if (path.empty() || std::filesystem::is_directory(status)) {
        fail("cannot write", path.empty() ? ENOENT : EISDIR);
    }
    target_ = behind_links(native).string();
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
        file_ = std::fopen(target_.c_str(), "wb");
        if (file_ == nullptr) fail("cannot write", errno);
        return;
    }
    open_temporary();
}

void OutputFile::open_temporary() {
    static std::atomic<unsigned> counter{0};
    const auto target = utf8_path(target_);
    for (;;) {
        const std::string unique =
            std::to_string(process_id()) + "-" + std::to_string(counter.fetch_add(1));
        const std::string name = name_of_file("." + target.filename().string(),
                                              std::string(kMark) + unique + std::string(kSuffix));
        temporary_ = (target.parent_path() / name).string();
        file_ = std::fopen(temporary_.c_str(), "wbx");
        if (file_ == nullptr && errno == EEXIST) continue;
        if (file_ == nullptr) {
            const int error = errno;
            temporary_.clear();
            fail("cannot write", error);
        }
        if (claim(file_)) return;
        std::fclose(file_);
    }
}

OutputFile::~OutputFile() {
    discard();
}

void OutputFile::write(std::string_view bytes) {
    errno = 0;
    if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) {
        fail("cannot write", errno);
    }
}

void OutputFile::seek(std::uint64_t position) {
    if (!seek_to(file_, position)) fail("cannot write", errno);
}

std::uint64_t OutputFile::tell() {
    const long long position = position_of(file_);
    if (position < 0) fail("cannot write", errno);
    return static_cast<std::uint64_t>(position);
}

void OutputFile::commit() {
    // errno still has the reason of an earlier error of a C library.
    const bool failed_before = std::ferror(file_) != 0;
    if (!failed_before) errno = 0;
    // A full disk may be detected only here: the flush of fclose would be too late to react.
    if (std::fflush(file_) != 0 || failed_before || !sync_to_disk(file_)) {
        fail("cannot write", errno != 0 ? errno : EIO);
    }
    // A network disk may report an error only at the close, which precedes the rename; until then
    // the lock keeps cleaners away.
    const int lock = keep_lock(file_);
    const bool closed = std::fclose(file_) == 0;
    const int close_error = errno;
    file_ = nullptr;
    std::error_code rename_error;
    if (closed && !temporary_.empty()) {
        std::filesystem::rename(temporary_, target_, rename_error);
    }
    release_lock(lock);
    if (!closed) fail("cannot write", close_error);
    if (rename_error) fail("cannot write", rename_error.value());
    temporary_.clear();
}

void OutputFile::fail(const char* what, int error) const {
    throw Error(ErrorKind::output,
                std::string(what) + " '" + path_ + "': " + std::generic_category().message(error));
}

void OutputFile::discard() noexcept {
    if (file_ != nullptr) std::fclose(file_);
    file_ = nullptr;
    if (!temporary_.empty()) std::remove(temporary_.c_str());
    temporary_.clear();
}

void write_file_atomically(const std::string& path, std::string_view bytes) {
    OutputFile file(path);
    file.write(bytes);
    file.commit();
}

std::string name_of_file(std::string_view stem, std::string_view ending) {
    constexpr std::size_t kMaxBytes = 255;
    std::string name = std::string(stem) + std::string(ending);
    if (name.size() <= kMaxBytes) return name;
    std::uint64_t hash = 0xcbf29ce484222325u;  // FNV-1a
    for (const char byte : stem) {
        hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3u;
    }
    const std::string rest =
        format_text("~%016llx", static_cast<unsigned long long>(hash)) + std::string(ending);
    std::size_t kept = 0;
    for (;;) {
        // A byte outside any character counts as a character.
        const std::size_t next = std::max<std::size_t>(1, utf8_character(stem.substr(kept)));
        if (kept + next + rest.size() > kMaxBytes) break;
        kept += next;
    }
    return std::string(stem.substr(0, kept)) + rest;
}

void make_folder(const std::string& folder) {
    if (folder.empty()) return;
    std::error_code code;
    std::filesystem::create_directories(utf8_path(folder), code);
    if (!code) return;
    throw Error(ErrorKind::output, folder + ": the folder cannot be created: " + code.message());
}

void require_folder(const std::string& folder) {
    std::error_code code;
    const std::filesystem::path place = nearest_existing(folder);
    const bool is_folder = std::filesystem::is_directory(place, code);
    if (is_folder && may_write(place)) return;
    throw Error(ErrorKind::output, (folder.empty() ? "." : folder) +
                                       ": the folder cannot be written: " + place.string() +
                                       (is_folder ? " is not writable" : " is not a folder"));
}

std::uint64_t free_bytes(const std::string& folder) {
    std::error_code code;
    return std::filesystem::space(nearest_existing(folder), code).available;
}

void refuse_to_replace_foreign_file(const std::string& path, std::string_view writer,
                                    const std::function<bool()>& is_ours) {
    std::error_code code;
    const std::filesystem::path native = utf8_path(path);
    if (!std::filesystem::is_regular_file(native, code)) return;
    if (std::filesystem::file_size(native, code) == 0 || is_ours()) return;
    throw Error(ErrorKind::invalid_value,
                "'" + path + "' exists and was not written by " + std::string(writer) +
                    ": it is not replaced; move it or choose another name");
}

void write_output(const std::string& path, std::string_view bytes) {
    make_folder(utf8_path(path).parent_path().string());
    write_file_atomically(path, bytes);
}

int remove_abandoned_temporaries(const std::string& directory,
                                 const std::optional<std::vector<std::string>>& paths) {
    const auto is_asked = [&](const std::string& name) {
        const std::string ending = name.substr(name.rfind(kMark));
        return !paths || std::ranges::any_of(*paths, [&](const std::string& path) {
            return name == name_of_file("." + utf8_path(path).filename().string(), ending);
        });
    };
    int removed = 0;
    std::error_code error;
    const auto folder = utf8_path(directory.empty() ? "." : directory);
    for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        const bool ours =
            name.starts_with('.') && name.ends_with(kSuffix) && name.find(kMark) != name.npos;
        if (!ours || !is_asked(name) || !entry->is_regular_file(error)) continue;
        if (!abandoned(entry->path())) continue;
        std::filesystem::remove(entry->path(), error);
        ++removed;
    }
    return removed;
}

}  // namespace ocean::io
