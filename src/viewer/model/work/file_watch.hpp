#pragma once
#include <atomic>
#include <condition_variable>
#include <filesystem>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace glassbox {

/// Looks at files several times a second, which works on network and virtual file systems too, and notices when one has
/// changed.
class FileWatch {
public:
    /// Whether a file that goes away has changed. An editor may take it away for a moment while it writes.
    enum class Gone { is_no_change, is_a_change };

    /// `wake` is called from another thread when there is something to tell.
    FileWatch(std::vector<std::filesystem::path> files, Gone gone, std::function<void()> wake);

    /// Whether a file has changed since this was last asked.
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
    std::jthread thread_;  // last: it uses all the others
};

}  // namespace glassbox
