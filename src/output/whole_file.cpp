#include "output/whole_file.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "render/job.hpp"
#include "scene/error.hpp"

namespace glassbox {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t chunk = std::size_t{1} << 20;  // bytes between two checks of the stop token

fs::path folder_of(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

/// Advice for an error number, for the user who typed the path.
std::string remedy(const fs::path& path, int number) {
    const std::string folder = folder_of(path).string();
    std::error_code ignored;
    switch (number) {
        case ENOENT:
            if (path.empty() || !path.has_filename()) return "name a file, such as picture.png";
            if (!fs::exists(folder, ignored))
                return fmt::format("create the folder {}/ first, or name another file", folder);
            return "name another file";
        case ENOTDIR:
            return fmt::format("{} is not a folder; name another file", folder);
        case EISDIR:
            return fmt::format("name a file in it, such as {}", (path / "picture.png").string());
        case EACCES:
        case EPERM:
        case EROFS:
            return "allow writing there, or name a file in a folder of your own";
        case EFBIG:
            return "raise the limit on the size of files (ulimit -f), or name a file on another disk";
        case ENOSPC:
        case EDQUOT:
            return "free some space, or name a file on another disk";
        case ENAMETOOLONG:
            return "choose a shorter name";
        default:
            return "name another file";
    }
}

[[noreturn]] void fail(const fs::path& path, int number) {
    throw error_at({path.empty() ? "\"\"" : path.string()},
                   fmt::format("cannot write: {}; {}", std::system_category().message(number), remedy(path, number)));
}

/// Owns an open file descriptor and closes it.
class OpenFile {
public:
    explicit OpenFile(int descriptor) : descriptor_(descriptor) {}
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;
    ~OpenFile() {
        if (descriptor_ >= 0) ::close(descriptor_);
    }

    int descriptor() const { return descriptor_; }

    /// Opens for writing; on failure the descriptor is -1 and errno is set.
    void open(const fs::path& path, int how) { descriptor_ = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | how, 0666); }

    /// Closes the file. Returns 0 or the error number: some file systems report a full disk only here.
    int close() {
        const int result = ::close(descriptor_);
        descriptor_ = -1;
        return result == 0 ? 0 : errno;
    }

private:
    int descriptor_;
};

/// Removes its file on destruction unless it was renamed; and as soon as its writer is asked to stop, so that nothing
/// is left even if the program must then be ended.
class Temporary {
public:
    Temporary(fs::path path, const std::stop_token& stop)
        : path_(std::move(path)), at_stop_(stop, [file = path_] { ::unlink(file.c_str()); }) {}
    Temporary(const Temporary&) = delete;
    Temporary& operator=(const Temporary&) = delete;
    ~Temporary() {
        if (!path_.empty()) ::unlink(path_.c_str());
    }

    /// Renames the file. Returns 0 or the error number.
    int rename(const fs::path& target) {
        if (::rename(path_.c_str(), target.c_str()) != 0) return errno;
        path_.clear();
        return 0;
    }

private:
    fs::path path_;
    std::stop_callback<std::function<void()>> at_stop_;
};

/// Finds a free name in that folder, for which `take` creates a file; `take` returns whether it could.
fs::path take_free_name(const fs::path& folder, const fs::path& shown,
                        const std::function<bool(const fs::path&)>& take) {
    for (int attempt = 0; attempt < 10000; ++attempt) {
        fs::path path = folder / fmt::format(".glassbox-{}-{}.tmp", ::getpid(), attempt);
        if (take(path)) return path;
        if (errno != EEXIST) fail(shown, errno);
    }
    fail(shown, EEXIST);
}

/// The system's path to an open file, whether or not it has another name.
std::string shown_by_system(int descriptor) { return fmt::format("/proc/self/fd/{}", descriptor); }

/// Creates a file without a name, to be named when it is complete; the system removes it however the program ends, even
/// by SIGKILL. Returns -1 where the file system has no such files, or the system no way to name them.
int create_nameless([[maybe_unused]] const fs::path& folder) {
#if defined O_TMPFILE && !defined GLASSBOX_NAMED_TEMPORARIES
    const int descriptor = ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
    if (descriptor < 0 || ::access(shown_by_system(descriptor).c_str(), F_OK) == 0) return descriptor;
    ::close(descriptor);
#endif
    return -1;
}

/// A new file in a folder that gets its own name only when it is complete. Its mode is 0666 less the umask, as for any
/// new file.
class Draft {
public:
    Draft(fs::path folder, const fs::path& shown, const std::stop_token& stop)
        : folder_(std::move(folder)), shown_(shown), stop_(stop), file_(create_nameless(folder_)) {
        if (file_.descriptor() >= 0) return;
        const auto create = [&](const fs::path& path) {
            file_.open(path, O_CREAT | O_EXCL);
            return file_.descriptor() >= 0;
        };
        temporary_.emplace(take_free_name(folder_, shown_, create), stop_);
    }

    const OpenFile& file() const { return file_; }

    /// Gives the complete file its name.
    void publish(const fs::path& target) {
        // Syncs before the rename: after a power cut the name must not refer to an empty file.
        if (::fsync(file_.descriptor()) != 0 && errno != EINVAL && errno != ENOTSUP) fail(shown_, errno);
        if (!temporary_) link();  // only a rename replaces an existing file, and only a named file can be renamed
        if (const int number = file_.close()) fail(shown_, number);
        const int number = temporary_->rename(target);
        if (number == 0) return;
        if (stop_.stop_requested()) throw Cancelled{};
        fail(shown_, number);
    }

private:
    void link() {
        const std::string nameless = shown_by_system(file_.descriptor());
        const auto link_to = [&](const fs::path& path) {
            return ::linkat(AT_FDCWD, nameless.c_str(), AT_FDCWD, path.c_str(), AT_SYMLINK_FOLLOW) == 0;
        };
        temporary_.emplace(take_free_name(folder_, shown_, link_to), stop_);
    }

    fs::path folder_;
    const fs::path& shown_;
    std::stop_token stop_;
    OpenFile file_;
    std::optional<Temporary> temporary_;
};

void write_bytes(const OpenFile& file, std::span<const std::byte> bytes, const fs::path& shown,
                 const std::stop_token& stop) {
    while (!bytes.empty()) {
        if (stop.stop_requested()) throw Cancelled{};
        const ssize_t written = ::write(file.descriptor(), bytes.data(), std::min(bytes.size(), chunk));
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail(shown, errno);
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    if (stop.stop_requested()) throw Cancelled{};
}

/// Gathers pieces into whole chunks, so that a sink may be fed a line at a time.
void write_pieces(const OpenFile& file, const std::function<void(const Sink&)>& produce, const fs::path& shown,
                  const std::stop_token& stop) {
    std::vector<std::byte> waiting;
    produce([&](std::span<const std::byte> piece) {
        if (waiting.size() + piece.size() >= chunk) {
            write_bytes(file, waiting, shown, stop);
            waiting.clear();
        }
        if (piece.size() >= chunk) write_bytes(file, piece, shown, stop);
        else waiting.insert(waiting.end(), piece.begin(), piece.end());
    });
    write_bytes(file, waiting, shown, stop);
}

/// The file behind a symbolic link, so that replacing the file keeps the link.
fs::path behind_links(const fs::path& path) {
    std::error_code failed;
    if (!fs::is_symlink(path, failed)) return path;
    const fs::path target = fs::weakly_canonical(folder_of(path) / fs::read_symlink(path, failed), failed);
    return failed ? path : target;
}

/// A new descriptor for what is not a plain file. Duplicates one that is already open: opening /dev/stdout anew would
/// empty the file behind `>>`.
int open_device(const fs::path& path) {
    const std::string name = path.lexically_normal().string();
    if (name == "/dev/stdout") return ::dup(STDOUT_FILENO);
    if (name == "/dev/stderr") return ::dup(STDERR_FILENO);
    return ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
}

void write_directly(const fs::path& path, const std::function<void(const Sink&)>& produce, const fs::path& shown,
                    const std::stop_token& stop) {
    OpenFile file(open_device(path));
    if (file.descriptor() < 0) fail(shown, errno);
    write_pieces(file, produce, shown, stop);
    if (const int number = file.close()) fail(shown, number);
}

}  // namespace

bool is_device(const fs::path& path) {
    const std::string name = path.lexically_normal().string();
    for (const char* descriptors : {"/dev/std", "/dev/fd/", "/proc/"})
        if (name.starts_with(descriptors)) return true;
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    return fs::exists(status) && !fs::is_regular_file(status);
}

void check_writable(const fs::path& path) {
    if (path.empty() || !path.has_filename()) fail(path, fs::is_directory(path) ? EISDIR : ENOENT);
    struct stat found {};
    if (::stat(path.c_str(), &found) == 0) {
        if (S_ISDIR(found.st_mode)) fail(path, EISDIR);
        if (::access(path.c_str(), W_OK) != 0) fail(path, errno);
    } else if (errno != ENOENT) {
        fail(path, errno);
    }
    if (is_device(path)) return;
    const fs::path folder = folder_of(behind_links(path));
    if (::stat(folder.c_str(), &found) != 0) fail(path, errno);
    if (!S_ISDIR(found.st_mode)) fail(path, ENOTDIR);
    if (::access(folder.c_str(), W_OK | X_OK) != 0) fail(path, errno);
}

void write_whole(const fs::path& path, const std::function<void(const Sink&)>& produce, std::stop_token stop) {
    check_writable(path);
    if (is_device(path)) return write_directly(path, produce, path, stop);

    if (stop.stop_requested()) throw Cancelled{};  // before a temporary exists that nobody would remove
    const fs::path target = behind_links(path);
    Draft draft(folder_of(target), path, stop);

    struct stat existing {};
    if (::stat(target.c_str(), &existing) == 0 && ::fchmod(draft.file().descriptor(), existing.st_mode & 07777) != 0)
        fail(path, errno);
    write_pieces(draft.file(), produce, path, stop);
    draft.publish(target);
}

void write_whole(const fs::path& path, std::span<const std::byte> bytes, std::stop_token stop) {
    write_whole(
        path, [&](const Sink& sink) { sink(bytes); }, stop);
}

}  // namespace glassbox
