#pragma once
#include <atomic>
#include <cstdint>
#include <string>
#include <thread>

namespace glassbox {

/// Shows on stderr the progress of long work and the time left: a bar on a terminal, plain lines elsewhere, nothing for
/// work done in under a second.
class Progress {
public:
    /// `what` names the work: "rendering". `total` is its number of pixels or rays.
    Progress(std::string what, std::int64_t total);

    /// The counter that the work counts up to `total`.
    std::atomic<std::int64_t>& done() { return done_; }

private:
    void show(const std::stop_token& stop) const;

    std::string what_;
    std::int64_t total_;
    std::atomic<std::int64_t> done_ = 0;
    std::jthread watcher_;
};

}  // namespace glassbox
