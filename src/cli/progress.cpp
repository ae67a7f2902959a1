#include "cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <mutex>

namespace glassbox {

namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

/// "8 s", "2 min 05 s", "3 h 10 min".
std::string duration(double seconds) {
    const auto s = static_cast<long long>(seconds + 0.5);
    if (s < 60) return fmt::format("{} s", s);
    if (s < 3600) return fmt::format("{} min {:02} s", s / 60, s % 60);
    return fmt::format("{} h {:02} min", s / 3600, s / 60 % 60);
}

std::string bar(double fraction) {
    constexpr int width = 40;
    const int full = static_cast<int>(fraction * width);
    return std::string(static_cast<std::size_t>(full), '#') + std::string(static_cast<std::size_t>(width - full), '.');
}

/// Ignores a stderr that is full or closed.
void put(const std::string& text) {
    std::fputs(text.c_str(), stderr);
    std::fflush(stderr);
}

}  // namespace

Progress::Progress(std::string what, std::int64_t total)
    : what_(std::move(what)), total_(total), watcher_([this](const std::stop_token& stop) { show(stop); }) {}

void Progress::show(const std::stop_token& stop) const {
    const bool terminal = ::isatty(STDERR_FILENO) == 1;
    constexpr auto longest_pause = std::chrono::milliseconds(64000);
    auto pause = terminal ? std::chrono::milliseconds(100) : std::chrono::milliseconds(2000);
    const Clock::time_point start = Clock::now();
    std::mutex mutex;
    std::condition_variable_any wake;
    std::unique_lock lock(mutex);
    bool shown = false;
    wake.wait_for(lock, stop, std::chrono::seconds(1), [] { return false; });
    while (!stop.stop_requested()) {
        const double fraction = static_cast<double>(done_) / static_cast<double>(total_);
        const double elapsed = Seconds(Clock::now() - start).count();
        const std::string left =
            fraction > 0 ? duration(elapsed / fraction * (1 - fraction)) + " left" : std::string("starting");
        if (terminal) put(fmt::format("\r\x1b[K{} [{}] {:3.0f} %, {}", what_, bar(fraction), 100 * fraction, left));
        else put(fmt::format("{}: {:.0f} % done, {}\n", what_, 100 * fraction, left));
        shown = true;
        wake.wait_for(lock, stop, pause, [] { return false; });
        if (!terminal) pause = std::min(2 * pause, longest_pause);
    }
    if (shown && terminal) put("\r\x1b[K");
}

}  // namespace glassbox
