#include "viewer/model/work/file_watch.hpp"

#include <chrono>
#include <utility>

namespace glassbox {

namespace {

struct Version {
    std::filesystem::file_time_type written{};
    std::uintmax_t size = 0;

    bool operator==(const Version&) const = default;
};

/// An editor may remove the file for a moment while it writes: that is a version of its own, and no error.
Version version(const std::filesystem::path& file) {
    std::error_code gone;
    Version now;
    now.written = std::filesystem::last_write_time(file, gone);
    if (gone) return {};
    now.size = std::filesystem::file_size(file, gone);
    return gone ? Version{} : now;
}

}  // namespace

FileWatch::FileWatch(std::vector<std::filesystem::path> files, Gone gone, std::function<void()> wake)
    : files_(std::move(files)),
      gone_(gone),
      wake_(std::move(wake)),
      thread_([this](const std::stop_token& end) { run(end); }) {}

void FileWatch::run(const std::stop_token& end) {
    constexpr std::chrono::milliseconds between_looks{125};
    const auto look = [this] {
        std::vector<Version> versions;
        for (const std::filesystem::path& file : files_) versions.push_back(version(file));
        return versions;
    };
    std::vector<Version> last = look();
    std::unique_lock lock(mutex_);
    while (!end.stop_requested()) {
        ended_.wait_for(lock, end, between_looks, [] { return false; });
        const std::vector<Version> now = look();
        bool changed = false;
        for (std::size_t i = 0; i < now.size(); ++i)
            changed = changed || (now[i] != last[i] && (now[i] != Version{} || gone_ == Gone::is_a_change));
        last = now;
        if (!changed) continue;
        changed_ = true;
        wake_();
    }
}

}  // namespace glassbox
