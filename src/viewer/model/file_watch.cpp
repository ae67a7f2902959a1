#include "viewer/model/file_watch.hpp"

#include <chrono>
#include <utility>

namespace glassbox {

namespace {

struct Version {
    std::filesystem::file_time_type written{};
    std::uintmax_t size = 0;

    bool operator==(const Version&) const = default;
};

/// An editor may take the file away for a moment while it writes: that is a version of its own, and no error.
Version version(const std::filesystem::path& file) {
    std::error_code gone;
    Version now;
    now.written = std::filesystem::last_write_time(file, gone);
    if (gone) return {};
    now.size = std::filesystem::file_size(file, gone);
    return gone ? Version{} : now;
}

}  // namespace

FileWatch::FileWatch(std::filesystem::path file, std::function<void()> wake)
    : file_(std::move(file)), wake_(std::move(wake)), thread_([this](const std::stop_token& end) { run(end); }) {}

void FileWatch::run(const std::stop_token& end) {
    Version last = version(file_);
    std::unique_lock lock(mutex_);
    while (!end.stop_requested()) {
        ended_.wait_for(lock, end, std::chrono::milliseconds(250), [] { return false; });
        const Version now = version(file_);
        if (now == last) continue;
        last = now;
        if (now == Version{}) continue;
        changed_ = true;
        wake_();
    }
}

}  // namespace glassbox
