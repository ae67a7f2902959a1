#pragma once
#include <cstddef>

namespace glassbox::learn {

/// Memory without a name, all 0 at first, shared with a program that we run: it inherits the descriptor, and both map
/// it. Throws Error if the system has none to give.
class SharedMemory {
public:
    explicit SharedMemory(std::size_t bytes);
    SharedMemory(SharedMemory&& other) noexcept;
    SharedMemory& operator=(SharedMemory&&) = delete;
    ~SharedMemory();

    int descriptor() const { return descriptor_; }  ///< closed on exec, at least 10
    void* data() const { return data_; }
    std::size_t size() const { return size_; }

private:
    int descriptor_ = -1;
    void* data_ = nullptr;
    std::size_t size_ = 0;
};

}  // namespace glassbox::learn
