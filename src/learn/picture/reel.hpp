#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace glassbox::learn::mine {

// The memory that Glassbox and a learner's program share when it records a pixel's steps: behind a Sheet that says what
// is to be traced lies a Reel, which the program fills. Plain numbers only; each count is raised when what it counts is
// whole, so what is there holds whenever the program ends.

inline constexpr std::uint32_t most_steps = 2000, most_calls = 2000,
                               most_names = 500;  // of a tape; a test has about 100
inline constexpr std::uint32_t most_tapes = 64, most_texts = 250, most_listed = 64;

struct ReelStep {
    double value;
    std::uint32_t left, right, call;
    std::int32_t line;
    std::uint8_t file;  ///< one of the texts
    std::uint8_t operation;
};
struct ReelCall {
    std::uint32_t caller;
    std::int32_t line;
    std::uint8_t header, function, file;  ///< texts
};
struct ReelName {
    std::uint32_t step;
    char text[60];
};
struct ReelText {
    char text[500];
};

struct ReelTape {
    std::int64_t surface;
    std::atomic<std::uint32_t> steps, calls, names;  ///< how many; call 0 is no call, and always there
    std::uint32_t open_call;                         ///< the call that it is in
    std::uint32_t test_steps;                        ///< of a hit: how many of its steps are the test
    std::int32_t finished, met;
    std::int64_t t_step;  ///< less than 0: t is a constant
    double t;
    ReelStep step[most_steps];
    ReelCall call[most_calls];
    ReelName name[most_names];
};

/// What the program does.
enum class ReelStage : std::int32_t { starting, view, ray_color, tests, choice, hit, done };

struct Reel {
    // What the program is told.
    std::int32_t x, y;
    std::int64_t listed[most_listed];  ///< surfaces whose tests are kept though they are missed, in order
    std::uint32_t listed_count;

    // What it writes.
    std::atomic<ReelStage> at;
    std::atomic<std::int64_t> tested;  ///< surfaces
    double ray[2][3];                  ///< from the stage ray_color on
    std::int64_t met;
    std::uint8_t color[3];  ///< at the stage done
    std::int32_t endless;   ///< whether it was ended because a tape was full
    std::int32_t not_written;
    std::int32_t has_hit;  ///< whether the last tape is of the surface that is seen
    std::atomic<std::uint32_t> texts, tapes;
    ReelText text[most_texts];
    ReelTape tape[most_tapes];
};
static_assert(std::atomic<std::uint32_t>::is_always_lock_free && std::atomic<ReelStage>::is_always_lock_free);

}  // namespace glassbox::learn::mine
