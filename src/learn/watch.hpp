#pragma once
#include <chrono>
#include <filesystem>
#include <stop_token>
#include <string>

namespace glassbox::learn {

/// Looks at the headers in a folder, at their times and sizes and, if those have changed, at what is in them: this
/// works on network and virtual file systems, too.
class Watch {
public:
    explicit Watch(std::filesystem::path folder);

    /// Waits until what is in the headers has changed since it was last asked, and does not change any more for a
    /// moment: editors empty a file, or take it away, before they write it. False if it was asked to stop.
    bool wait(const std::stop_token& stop);

private:
    std::filesystem::path folder_;
    std::string seen_;   ///< times and sizes
    std::string known_;  ///< a fingerprint of what is in them
};

}  // namespace glassbox::learn
