#pragma once
#include <string>
#include <utility>

namespace glassbox {

/// A few words about what has just been done, which go by themselves.
struct Notice {
    std::string text;  ///< empty: there is none
    bool is_error = false;
    double seconds = 0;  ///< for which it stays
};

/// What was done.
inline Notice done(std::string text) { return {std::move(text), false, 5}; }

/// What could not be done, and what would be right: it stays longer.
inline Notice refused(std::string text) { return {std::move(text), true, 12}; }

/// The notice after so many seconds.
inline Notice later(Notice notice, double seconds) {
    notice.seconds -= seconds;
    return notice.seconds > 0 ? notice : Notice{};
}

}  // namespace glassbox
