#pragma once
#include <atomic>
#include <condition_variable>
#include <filesystem>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace glassbox {

/// Checks files for changes several times a second, which works on network and virtual file systems, too.
class FileWatch {
public:
    /// Whether removing a file is a change. An editor may remove it for a moment while it writes.
    enum class Gone { is_no_change, is_a_change };

    /// Calls `wake` from another thread when a file has changed.
    FileWatch(std::vector<std::filesystem::path> files, Gone gone, std::function<void()> wake);

    /// Whether a file has changed since the last call.
    bool has_changed() { return changed_.exchange(false); }

    const std::vector<std::filesystem::path>& files() const { return files_; }

private:
    void run(const std::stop_token& end);

    std::vector<std::filesystem::path> files_;
    Gone gone_;
    std::function<void()> wake_;
    std::atomic<bool> changed_ = false;
    std::mutex mutex_;
    std::condition_variable_any ended_;
    std::jthread thread_;  // last: it uses all other members
};

}  // namespace glassbox
