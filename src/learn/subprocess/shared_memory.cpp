#include "learn/subprocess/shared_memory.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>

#include "scene/error.hpp"

namespace glassbox::learn {
namespace {

/// Opens a file that has no name any more: its memory is freed with its last descriptor.
int open_nameless() {
#ifdef __linux__
    const int memory = ::memfd_create("glassbox", MFD_CLOEXEC);
    if (memory >= 0) return memory;
#endif
    std::string name = (std::filesystem::temp_directory_path() / "glassbox-XXXXXX").string();
    const int file = ::mkstemp(name.data());
    if (file >= 0) ::unlink(name.c_str());
    return file;
}

[[noreturn]] void fail(std::size_t bytes) {
    throw Error(fmt::format("error: no {} bytes of shared memory: {}; close other programs, or free space in {}", bytes,
                            std::system_category().message(errno), std::filesystem::temp_directory_path().string()));
}

}  // namespace

SharedMemory::SharedMemory(std::size_t bytes) : size_(bytes) {
    const int first = open_nameless();
    if (first < 0) fail(bytes);
    descriptor_ = ::fcntl(first, F_DUPFD_CLOEXEC, 10);  // out of the way of the descriptors that a child is given
    ::close(first);
    const bool sized = descriptor_ >= 0 && ::ftruncate(descriptor_, static_cast<off_t>(bytes)) == 0;
    void* const data = sized ? ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor_, 0) : MAP_FAILED;
    if (data == MAP_FAILED) {
        const int reason = errno;
        if (descriptor_ >= 0) ::close(descriptor_);
        errno = reason;
        fail(bytes);
    }
    data_ = data;
}

SharedMemory::SharedMemory(SharedMemory&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)),
      data_(std::exchange(other.data_, nullptr)),
      size_(std::exchange(other.size_, 0)) {}

SharedMemory::~SharedMemory() {
    if (data_ != nullptr) ::munmap(data_, size_);
    if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace glassbox::learn
