#include "viewer/model/work/file_watch.hpp"

#include <chrono>
#include <utility>

#include "viewer/model/files/file_version.hpp"

namespace glassbox {

FileWatch::FileWatch(std::vector<std::filesystem::path> files, Gone gone, std::function<void()> wake)
    : files_(std::move(files)),
      gone_(gone),
      wake_(std::move(wake)),
      thread_([this](const std::stop_token& end) { run(end); }) {}

void FileWatch::run(const std::stop_token& end) {
    constexpr std::chrono::milliseconds between_looks{125};
    const auto look = [this] {
        std::vector<FileVersion> versions;
        for (const std::filesystem::path& file : files_) versions.push_back(file_version(file));
        return versions;
    };
    std::vector<FileVersion> last = look();
    std::unique_lock lock(mutex_);
    while (!end.stop_requested()) {
        ended_.wait_for(lock, end, between_looks, [] { return false; });
        const std::vector<FileVersion> now = look();
        bool changed = false;
        for (std::size_t i = 0; i < now.size(); ++i)
            changed = changed || (now[i] != last[i] && (now[i] != FileVersion{} || gone_ == Gone::is_a_change));
        last = now;
        if (!changed) continue;
        changed_ = true;
        wake_();
    }
}

}  // namespace glassbox
