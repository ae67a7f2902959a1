#include "learn/watch.hpp"

#include <condition_variable>
#include <mutex>

#include "learn/build/headers.hpp"

namespace glassbox::learn {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr auto between_looks = 80ms;
constexpr auto to_settle = 30ms;  // an editor that writes in several steps is faster than that

/// Times and sizes of the headers.
std::string states_in(const fs::path& folder) {
    std::string state;
    for (const fs::path& file : headers_in(folder)) state += state_of(file) + '\n';
    return state;
}

/// Returns false if asked to stop in the meantime.
bool sleep(std::chrono::milliseconds time, const std::stop_token& stop) {
    std::mutex mutex;
    std::unique_lock lock(mutex);
    std::condition_variable_any stopped;
    stopped.wait_for(lock, stop, time, [] { return false; });
    return !stop.stop_requested();
}

}  // namespace

Watch::Watch(fs::path folder)
    : folder_(std::move(folder)), seen_(states_in(folder_)), known_(fingerprint_of_headers(folder_)) {}

bool Watch::wait(const std::stop_token& stop) {
    while (sleep(between_looks, stop)) {
        std::string state = states_in(folder_);
        if (state == seen_) continue;
        for (bool settled = false; !settled;) {
            if (!sleep(to_settle, stop)) return false;
            std::string now = states_in(folder_);
            settled = now == state;
            state = std::move(now);
        }
        seen_ = std::move(state);
        std::string fingerprint = fingerprint_of_headers(folder_);
        if (fingerprint == known_) continue;
        known_ = std::move(fingerprint);
        return true;
    }
    return false;
}

}  // namespace glassbox::learn
