#pragma once
#include <atomic>
#include <cstdint>
#include <string>
#include <thread>

namespace glassbox {

/// Shows on stderr how far long work is and how long it will still take: a bar on a terminal, plain lines elsewhere,
/// nothing for work that is done in under a second.
class Progress {
public:
    /// `what` names the work: "rendering". `total` is its number of pixels or rays.
    Progress(std::string what, std::int64_t total);

    /// What the work counts up to `total`.
    std::atomic<std::int64_t>& done() { return done_; }

private:
    void show(const std::stop_token& stop) const;

    std::string what_;
    std::int64_t total_;
    std::atomic<std::int64_t> done_ = 0;
    std::jthread watcher_;
};

}  // namespace glassbox
