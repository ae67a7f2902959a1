#pragma once
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>

#include "render/job.hpp"

namespace glassbox {

/// Background work of which only the newest counts: a new request stops what is running, and takes its place. Results
/// may come in several versions, each better than the one before.
template <class Result>
class Latest {
public:
    using Deliver = std::function<void(Result)>;
    /// Work gets a token that says when to stop, and delivers its results by `deliver`.
    using Work = std::function<void(const std::stop_token&, const Deliver& deliver)>;

    /// Calls `wake`, from the worker's thread, whenever there is a new result.
    explicit Latest(std::function<void()> wake)
        : wake_(std::move(wake)), thread_([this](const std::stop_token& end) { run(end); }) {}

    ~Latest() {
        thread_.request_stop();
        cancel();
    }

    /// With `goes_on`, the work continues what was requested before: results of that, present or still to come, are
    /// worth showing.
    void ask(Work work, bool goes_on = false) {
        {
            const std::lock_guard lock(mutex_);
            if (!goes_on) drop();
            next_ = std::move(work);
            current_.request_stop();
        }
        asked_.notify_one();
    }

    /// Stops the running work, which delivers nothing more.
    void cancel() {
        const std::lock_guard lock(mutex_);
        next_.reset();
        drop();
        current_.request_stop();
        error_.clear();
    }

    /// Returns the newest result, and each result only once.
    std::optional<Result> take() {
        const std::lock_guard lock(mutex_);
        return std::exchange(result_, std::nullopt);
    }

    /// Whether more results may come.
    bool busy() const {
        const std::lock_guard lock(mutex_);
        return working_ || next_;
    }

    /// Returns the error of the newest work; empty if there was none.
    std::string error() const {
        const std::lock_guard lock(mutex_);
        return error_;
    }

private:
    /// Drops what the running work has delivered and what it may still deliver.
    void drop() {
        result_.reset();
        wanted_ = false;
    }

    void run(const std::stop_token& end) {
        std::unique_lock lock(mutex_);
        while (asked_.wait(lock, end, [&] { return next_.has_value(); })) {
            const Work work = *std::exchange(next_, std::nullopt);
            current_ = std::stop_source();
            const std::stop_token token = current_.get_token();
            working_ = wanted_ = true;
            error_.clear();
            lock.unlock();
            const std::string error = attempt(work, token);
            lock.lock();
            working_ = false;
            if (!token.stop_requested()) error_ = error;
            lock.unlock();
            wake_();
            lock.lock();
        }
    }

    std::string attempt(const Work& work, const std::stop_token& token) {
        try {
            work(token, [&](Result result) { deliver(std::move(result)); });
        } catch (const Cancelled&) {
        } catch (const std::exception& error) {
            return error.what();
        }
        return {};
    }

    void deliver(Result result) {
        {
            const std::lock_guard lock(mutex_);
            if (!wanted_) return;
            result_ = std::move(result);
        }
        wake_();
    }

    std::function<void()> wake_;
    mutable std::mutex mutex_;
    std::condition_variable_any asked_;
    std::optional<Work> next_;
    std::optional<Result> result_;
    std::stop_source current_;
    bool working_ = false;
    bool wanted_ = false;  ///< whether the running work's results are wanted
    std::string error_;
    std::jthread thread_;  // last: it uses all other members
};

}  // namespace glassbox
