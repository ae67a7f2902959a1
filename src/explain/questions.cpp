#include "explain/questions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <tuple>

#include "explain/loss.hpp"
#include "explain/phrases.hpp"
#include "explain/words.hpp"

namespace glassbox {

namespace {

using story::StoryStep;
using story::Surface;

constexpr double bits_off_at_most = 1;

const StoryStep& step_of(const Story& story, const Event& event) {
    return tape_of(story, *event.place)[event.place->step];
}

bool is_zero(const StoryStep& step) { return step.step.operation == Operation::constant && step.step.value == 0; }

/// Whether a comparison with 0 decides by that step.
bool is_compared_with_zero(std::span<const StoryStep> tape, StepNumber number) {
    return std::any_of(tape.begin() + number, tape.end(), [&](const StoryStep& later) {
        const auto& [operation, left, right, value, file, line, call] = later.step;
        if (!is_comparison(operation)) return false;
        return (left == number && is_zero(tape[right])) || (right == number && is_zero(tape[left]));
    });
}

/// Whether an event computes a named number whose sign decides something.
bool decides(const Story& story, const Event& event) {
    if (!event.place || step_of(story, event).name.empty()) return false;
    return is_compared_with_zero(tape_of(story, *event.place), event.place->step);
}

int sign_of(const Checked& number) { return (number.recorded > 0) - (number.recorded < 0); }

/// Whether the computed sign is the true one.
bool has_sure_sign(const Checked& number) {
    return std::isfinite(number.recorded) && number.known != Known::not_at_all && !may_be_zero(number) &&
           sign_of(number) == number.sign;
}

/// Whether rounding has changed no comparison of the test. What is proven does not depend on them.
bool has_sure_answer(const Surface& surface, const Options& options) {
    if (surface.fate == story::Fate::overflow) return false;
    return is_proven(options.scalar) || std::all_of(surface.steps.begin(), surface.steps.end(), [](const auto& told) {
               const Checked& checked = told.checked;
               return !is_comparison(told.step.operation) ||
                      (checked.known != Known::not_at_all && checked.value == checked.truth);
           });
}

/// Whether a reader can stop at an event and look forward: it is no step, or has a name, or is a comparison.
bool is_resting_place(const Story& story, const Event& event) {
    if (!event.place) return true;
    const StoryStep& told = step_of(story, event);
    return !told.name.empty() || is_comparison(told.step.operation);
}

std::string shape_in_words(const Surface& surface) {
    if (const auto* sphere = std::get_if<story::SphereTest>(&surface.test))
        return fmt::format("{} about {}, radius {}", word(surface.kind), triple(sphere->center),
                           short_number(sphere->radius));
    const auto& [A, B, C] = std::get<story::TriangleTest>(surface.test).vertices;
    return fmt::format("{} A = {}, B = {}, C = {}", word(surface.kind), triple(A), triple(B), triple(C));
}

/// "Δ = -4600"
std::string named_number(const StoryStep& told) {
    return fmt::format("{} = {}", told.name, short_number(told.checked.value));
}

/// The numbers of a surface's test whose signs decide.
std::string deciding_numbers(const Story& story, std::span<const Event> events, const Question& question) {
    std::string all;
    for (std::size_t i = question.at; i < question.answer; ++i)
        if (decides(story, events[i])) all += (all.empty() ? ": " : ", ") + named_number(step_of(story, events[i]));
    return all;
}

/// "from numbers that have lost 0.6 and 0.0"
std::string lost_before(const Story& story, const Event& event) {
    const std::span<const StoryStep> tape = tape_of(story, *event.place);
    const Step& step = tape[event.place->step].step;
    return fmt::format("from numbers that have lost {:.1f} and {:.1f}", tape[step.left].checked.bits_lost,
                       tape[step.right].checked.bits_lost);
}

}  // namespace

std::vector<Question> questions(const Story& story, std::span<const Event> events) {
    std::vector<Question> all;
    std::size_t resting = 0;  // the last such place before the present event
    std::optional<std::size_t> begun;
    for (std::size_t i = 0; i < events.size(); ++i) {
        const Event& event = events[i];
        if (event.surface && !event.holds) begun = i;
        if (event.surface && event.holds && begun && has_sure_answer(story.surfaces[*event.surface], story.options))
            all.push_back({Asked::hit, *begun, i, *event.holds ? 1.0 : 0.0});
        if (event.place) {
            const Checked& number = step_of(story, event).checked;
            if (decides(story, event) && has_sure_sign(number))
                all.push_back({Asked::sign, resting, i, static_cast<double>(number.sign)});
            if (event.cancellation && std::isfinite(number.bits_lost) && std::isfinite(number.recorded))
                all.push_back({Asked::bits, i, i, number.bits_lost});
        }
        if (is_resting_place(story, event)) resting = i;
    }
    const auto place = [](const Question& question) {
        return std::tuple(question.at, question.asked, question.answer);
    };
    std::sort(all.begin(), all.end(), [&](const auto& a, const auto& b) { return place(a) < place(b); });
    return all;
}

bool is_right(const Question& question, double said) {
    return question.asked == Asked::bits ? std::abs(said - question.right) <= bits_off_at_most : said == question.right;
}

std::optional<double> answer_in(std::string_view typed, Asked asked) {
    const auto is = [&](std::initializer_list<std::string_view> words) {
        return std::find(words.begin(), words.end(), typed) != words.end();
    };
    if (asked == Asked::hit)
        return is({"h", "hit"}) ? std::optional(1.0) : is({"m", "miss"}) ? std::optional(0.0) : std::nullopt;
    if (asked == Asked::sign) {
        if (is({"+"})) return 1;
        if (is({"-", "−"})) return -1;
        return is({"0"}) ? std::optional(0.0) : std::nullopt;
    }
    double bits = 0;
    const auto [end, error] = std::from_chars(typed.data(), typed.data() + typed.size(), bits);
    const bool is_whole_text = error == std::errc{} && end == typed.data() + typed.size();
    return is_whole_text && std::isfinite(bits) && bits >= 0 ? std::optional(bits) : std::nullopt;
}

std::size_t events_seen(std::span<const Event> events, std::span<const Question> questions, std::size_t answered) {
    return answered < questions.size() ? questions[answered].at + 1 : events.size();
}

bool is_settled(const Question& question, std::size_t seen) { return question.answer < seen; }

std::vector<std::size_t> just_settled(std::span<const Event> events, std::span<const Question> questions,
                                      const Answers& answers) {
    std::vector<std::size_t> settled;
    if (answers.empty()) return settled;
    const std::size_t last = answers.size() - 1;
    const std::size_t before = events_seen(events, questions, last), seen = events_seen(events, questions, last + 1);
    for (std::size_t i = 0; i <= last; ++i)
        if (answers[i] && is_settled(questions[i], seen) && (i == last || !is_settled(questions[i], before)))
            settled.push_back(i);
    std::stable_sort(settled.begin(), settled.end(),
                     [&](std::size_t a, std::size_t b) { return questions[a].answer < questions[b].answer; });
    return settled;
}

Score score(std::span<const Event> events, std::span<const Question> questions, const Answers& answers) {
    const std::size_t seen = events_seen(events, questions, answers.size());
    Score score;
    for (std::size_t i = 0; i < std::min(answers.size(), questions.size()); ++i) {
        if (!answers[i] || !is_settled(questions[i], seen)) continue;
        ++score.of;
        score.right += is_right(questions[i], *answers[i]) ? 1 : 0;
    }
    return score;
}

std::string in_words(const Score& score) {
    return score.of == 0 ? "nothing predicted yet" : fmt::format("{} of {} right", score.right, score.of);
}

std::string in_words(const Story& story, std::span<const Event> events, const Question& question) {
    const Event& event = events[question.answer];
    switch (question.asked) {
        case Asked::hit: {
            const Surface& surface = story.surfaces[*event.surface];
            return fmt::format("surface {}, {}: hit or miss?", surface.number, shape_in_words(surface));
        }
        case Asked::sign:
            return (event.has_values ? step_of(story, event).name : event.formula) + ": which sign?";
        case Asked::bits:
            return fmt::format("{}: {}, {}: how many bits has it lost?", event.formula, event.what,
                               lost_before(story, event));
    }
    return "";
}

std::string answer_in_words(const Story& story, std::span<const Event> events, const Question& question) {
    const Event& event = events[question.answer];
    switch (question.asked) {
        case Asked::hit:
            return why(story.surfaces[*event.surface], story) + deciding_numbers(story, events, question);
        case Asked::sign:
            return named_number(step_of(story, event));
        case Asked::bits:
            return fmt::format("{}; {:.0f} more or less counts as right", lost(step_of(story, event).checked),
                               bits_off_at_most);
    }
    return "";
}

std::string judged(const Story& story, std::span<const Event> events, const Question& question, double said) {
    return fmt::format("{}: {}", is_right(question, said) ? "right" : "wrong",
                       answer_in_words(story, events, question));
}

}  // namespace glassbox
