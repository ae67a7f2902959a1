#include "viewer/model/work/latest.hpp"

#include <doctest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <stdexcept>

using namespace glassbox;

namespace {

using namespace std::chrono_literals;

template <class Result>
std::optional<Result> awaited(Latest<Result>& latest) {
    const auto patience = std::chrono::steady_clock::now() + 20s;
    while (std::chrono::steady_clock::now() < patience) {
        const bool busy = latest.busy();
        if (auto result = latest.take()) return result;
        if (!busy) return {};
        std::this_thread::sleep_for(1ms);
    }
    return {};
}

/// Starts work that delivers 1 once it is stopped.
void begin_what_must_be_stopped(Latest<int>& latest) {
    const auto began = std::make_shared<std::atomic<bool>>(false);
    latest.ask([began](const std::stop_token& stop, const auto& deliver) {
        *began = true;
        while (!stop.stop_requested()) std::this_thread::sleep_for(1ms);
        deliver(1);
    });
    while (!*began) std::this_thread::sleep_for(1ms);
}

}  // namespace

TEST_CASE("What is asked for comes, and wakes the one who waits") {
    std::atomic<int> woken = 0;
    Latest<int> latest([&] { ++woken; });
    latest.ask([](const std::stop_token&, const auto& deliver) { deliver(7); });
    CHECK(awaited(latest) == 7);
    while (latest.busy()) std::this_thread::sleep_for(1ms);
    CHECK(woken >= 1);
    CHECK_FALSE(latest.take());
}

TEST_CASE("Only the newest counts: what runs is stopped, and what it delivers late is lost") {
    Latest<int> latest([] {});
    begin_what_must_be_stopped(latest);
    latest.ask([](const std::stop_token&, const auto& deliver) { deliver(2); });
    CHECK(awaited(latest) == 2);
}

TEST_CASE("What goes on with something takes its place, too, but what that has brought, or yet brings, is shown") {
    Latest<int> latest([] {});
    begin_what_must_be_stopped(latest);
    std::atomic<bool> first_seen = false;
    latest.ask(
        [&](const std::stop_token&, const auto& deliver) {
            while (!first_seen) std::this_thread::sleep_for(1ms);
            deliver(2);
        },
        true);
    CHECK(awaited(latest) == 1);
    first_seen = true;
    CHECK(awaited(latest) == 2);
}

TEST_CASE("Work that fails says why, once something newer is asked no more") {
    Latest<int> latest([] {});
    latest.ask([](const std::stop_token&, const auto&) { throw std::runtime_error("too large"); });
    CHECK_FALSE(awaited(latest));
    CHECK(latest.error() == "too large");
    latest.ask([](const std::stop_token&, const auto& deliver) { deliver(3); });
    CHECK(awaited(latest) == 3);
    CHECK(latest.error().empty());
}

TEST_CASE("A cancelled job brings nothing, and the end of a Latest does not wait for its work to finish") {
    Latest<int> latest([] {});
    latest.ask([](const std::stop_token& stop, const auto& deliver) {
        while (!stop.stop_requested()) std::this_thread::sleep_for(1ms);
        deliver(1);
    });
    latest.cancel();
    CHECK_FALSE(awaited(latest));
    latest.ask([](const std::stop_token& stop, const auto&) {
        while (!stop.stop_requested()) std::this_thread::sleep_for(1ms);
    });
}
