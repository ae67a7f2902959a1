#include "output/whole_file.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "render/job.hpp"
#include "scene/error.hpp"

namespace glassbox {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t chunk = std::size_t{1} << 20;  // bytes between two looks at the stop token

fs::path folder_of(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

/// What to do about an error number, for whoever typed the path.
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

/// An open file descriptor, closed at the end of its life.
class OpenFile {
public:
    explicit OpenFile(int descriptor) : descriptor_(descriptor) {}
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;
    ~OpenFile() {
        if (descriptor_ >= 0) ::close(descriptor_);
    }

    int descriptor() const { return descriptor_; }

    /// 0, or the error number: some file systems report a full disk no sooner.
    int close() {
        const int result = ::close(descriptor_);
        descriptor_ = -1;
        return result == 0 ? 0 : errno;
    }

private:
    int descriptor_;
};

/// A file that is removed again at the end of its life, unless it was renamed; and as soon as its writer is asked to
/// stop, so that nothing is left of it even if the program has to be ended then.
class Temporary {
public:
    Temporary(fs::path path, const std::stop_token& stop)
        : path_(std::move(path)), at_stop_(stop, [file = path_] { ::unlink(file.c_str()); }) {}
    Temporary(const Temporary&) = delete;
    Temporary& operator=(const Temporary&) = delete;
    ~Temporary() {
        if (!path_.empty()) ::unlink(path_.c_str());
    }

    /// 0, or the error number.
    int rename(const fs::path& target) {
        if (::rename(path_.c_str(), target.c_str()) != 0) return errno;
        path_.clear();
        return 0;
    }

private:
    fs::path path_;
    std::stop_callback<std::function<void()>> at_stop_;
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

/// Pieces are gathered to whole chunks, so that a sink may be fed a line at a time.
void write_pieces(OpenFile& file, const std::function<void(const Sink&)>& produce, const fs::path& shown,
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

/// The file behind a symbolic link, so that replacing the file leaves the link alone.
fs::path behind_links(const fs::path& path) {
    std::error_code failed;
    if (!fs::is_symlink(path, failed)) return path;
    const fs::path target = fs::weakly_canonical(folder_of(path) / fs::read_symlink(path, failed), failed);
    return failed ? path : target;
}

/// A descriptor of one's own for what is not a plain file. One that is open already is taken as it is: opening
/// /dev/stdout anew would empty the file behind `>>`.
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

/// Creates a file with a name of its own in that folder; the mode is 0666 less the umask, as for any new file.
std::pair<fs::path, int> create_temporary(const fs::path& folder, const fs::path& shown) {
    for (int attempt = 0; attempt < 10000; ++attempt) {
        fs::path path = folder / fmt::format(".glassbox-{}-{}.tmp", ::getpid(), attempt);
        const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor >= 0) return {std::move(path), descriptor};
        if (errno != EEXIST) fail(shown, errno);
    }
    fail(shown, EEXIST);
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

    if (stop.stop_requested()) throw Cancelled{};  // before there is a temporary that nobody would remove
    const fs::path target = behind_links(path);
    auto [name, descriptor] = create_temporary(folder_of(target), path);
    Temporary temporary(std::move(name), stop);
    OpenFile file(descriptor);

    struct stat existing {};
    if (::stat(target.c_str(), &existing) == 0 && ::fchmod(descriptor, existing.st_mode & 07777) != 0)
        fail(path, errno);
    write_pieces(file, produce, path, stop);
    // Synchronised before the rename: after a power cut the name must not stand for an empty file.
    if (::fsync(descriptor) != 0 && errno != EINVAL && errno != ENOTSUP) fail(path, errno);
    if (const int number = file.close()) fail(path, number);
    const int number = temporary.rename(target);
    if (number == 0) return;
    if (stop.stop_requested()) throw Cancelled{};
    fail(path, number);
}

void write_whole(const fs::path& path, std::span<const std::byte> bytes, std::stop_token stop) {
    write_whole(
        path, [&](const Sink& sink) { sink(bytes); }, stop);
}

}  // namespace glassbox
