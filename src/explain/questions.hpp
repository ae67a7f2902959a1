#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "explain/timeline.hpp"

namespace glassbox {

/// What a reader can be asked to predict.
enum class Asked {
    hit,   ///< does the ray meet the surface?
    bits,  ///< how many bits of a cancellation's result are lost?
    sign,  ///< which sign has a number that decides a test?
};

/// A question that the record of a computation answers; nobody writes them down.
struct Question {
    Asked asked = Asked::hit;
    std::size_t at = 0;      ///< the event after which it is asked; of bits, the one that it is about
    std::size_t answer = 0;  ///< the event that gives the answer
    double right = 0;        ///< 1 for a hit and 0 for a miss; the sign, -1, 0 or 1; the bits lost
};

/// Returns all that can be asked of a timeline, in the order of asking: of each surface whether it is met; of each
/// named number that a comparison with 0 decides by, its sign; of each cancellation, the bits lost. Nothing is asked
/// whose answer is not sure: what is not finite, a sign that rounding has changed or that is not known, and a hit
/// or miss that rests on one.
std::vector<Question> questions(const Story& story, std::span<const Event> events);

/// Whether an answer counts as right: the same sign, hit or miss; of bits, at most 1 too many or too few.
bool is_right(const Question& question, double said);

/// Returns the number for what a reader typed: h or m; +, - or 0; a number of bits. None if it is no such answer.
std::optional<double> answer_in(std::string_view typed, Asked asked);

/// A reader's answers to the first questions, in their order: none where it was skipped.
using Answers = std::vector<std::optional<double>>;

/// Returns how many events may be seen once so many questions are answered or skipped: all up to the next question.
std::size_t events_seen(std::span<const Event> events, std::span<const Question> questions, std::size_t answered);

/// Whether the timeline, as far as it may be seen, shows who is right: hit or miss is asked before a test, and seen
/// at its end.
bool is_settled(const Question& question, std::size_t seen);

/// Returns which of the answers the last one has settled: its own, and hits or misses that may be seen now. As they are
/// seen.
std::vector<std::size_t> just_settled(std::span<const Event> events, std::span<const Question> questions,
                                      const Answers& answers);

/// How many of the settled answers are right.
struct Score {
    int right = 0, of = 0;

    bool operator==(const Score&) const = default;
};
Score score(std::span<const Event> events, std::span<const Question> questions, const Answers& answers);

/// "7 of 9 right"; "nothing predicted yet".
std::string in_words(const Score& score);

/// "surface 0, sphere about (100, 350, 350), radius 50: hit or miss?"
std::string in_words(const Story& story, std::span<const Event> events, const Question& question);

/// The answer with the numbers that decide: "missed: Δ < 0, the line passes the sphere: Δ = -4600".
std::string answer_in_words(const Story& story, std::span<const Event> events, const Question& question);

/// "right: …" or "wrong: …", with the answer.
std::string judged(const Story& story, std::span<const Event> events, const Question& question, double said);

}  // namespace glassbox
