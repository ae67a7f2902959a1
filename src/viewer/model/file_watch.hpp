#pragma once
#include <atomic>
#include <condition_variable>
#include <filesystem>
#include <functional>
#include <mutex>
#include <thread>

namespace glassbox {

/// Looks at a file four times a second, which works on network and virtual file systems too, and notices when it has
/// changed.
class FileWatch {
public:
    /// `wake` is called from another thread when there is something to tell.
    FileWatch(std::filesystem::path file, std::function<void()> wake);

    /// Whether the file has changed since this was last asked.
    bool has_changed() { return changed_.exchange(false); }

    const std::filesystem::path& file() const { return file_; }

private:
    void run(const std::stop_token& end);

    std::filesystem::path file_;
    std::function<void()> wake_;
    std::atomic<bool> changed_ = false;
    std::mutex mutex_;
    std::condition_variable_any ended_;
    std::jthread thread_;  // last: it uses all the others
};

}  // namespace glassbox
