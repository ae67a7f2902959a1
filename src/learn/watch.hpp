#pragma once
#include <filesystem>
#include <stop_token>
#include <string>

namespace glassbox::learn {

/// Watches the headers in a folder: their times and sizes and, if those have changed, their contents. This works on
/// network and virtual file systems, too.
class Watch {
public:
    explicit Watch(std::filesystem::path folder);

    /// Waits until the contents of the headers have changed since the last call and do not change any more for a
    /// moment: editors empty or delete a file before they write it. Returns false if asked to stop.
    bool wait(const std::stop_token& stop);

private:
    std::filesystem::path folder_;
    std::string seen_;   ///< times and sizes
    std::string known_;  ///< a fingerprint of what is in them
};

}  // namespace glassbox::learn
