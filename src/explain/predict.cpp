#include "explain/predict.hpp"

#include <fmt/format.h>

#include "explain/phrases.hpp"
#include "explain/questions.hpp"
#include "scene/text_file.hpp"

namespace glassbox {

namespace {

std::string_view possible_answers(Asked asked) {
    switch (asked) {
        case Asked::hit:
            return "h or m";
        case Asked::sign:
            return "+, - or 0";
        case Asked::bits:
            return "a number";
    }
    return "";
}

/// A reader who is being asked.
class Reader {
public:
    Reader(const std::function<void(std::string_view)>& say, const std::function<std::optional<std::string>()>& read)
        : say_(say), read_(read) {}

    /// Whether there may be more answers.
    bool is_there() const { return is_there_; }

    /// The answer to a question; none if it is skipped, or the reader has gone.
    std::optional<double> answer(const std::string& question, Asked asked) {
        for (std::string asking = fmt::format("{} ({}) ", question, possible_answers(asked));;
             asking = fmt::format("  {}, Enter to skip, q to end: ", possible_answers(asked))) {
            say_(asking);
            const std::optional<std::string> line = read_();
            const std::string_view typed = line ? trimmed(*line) : "q";
            is_there_ = typed != "q";
            if (!is_there_ || typed.empty()) return {};
            if (const std::optional<double> said = answer_in(typed, asked)) return said;
        }
    }

private:
    const std::function<void(std::string_view)>& say_;
    const std::function<std::optional<std::string>()>& read_;
    bool is_there_ = true;
};

}  // namespace

void predict(const Story& story, const std::function<void(std::string_view)>& say,
             const std::function<std::optional<std::string>()>& read) {
    const std::vector<Event> events = timeline(story);
    const std::vector<Question> all = questions(story, events);
    say(fmt::format("Pixel ({}, {}): the ray starts at P = {} and runs along D = {}.\n", story.x, story.y,
                    triple(story.ray.P), triple(story.ray.D)));
    if (all.empty()) return say("Nothing is decided here that could be predicted.\n");
    say("Before each test: what do you expect? Enter skips a question, q ends.\n\n");
    Reader reader(say, read);
    Answers answers;
    while (answers.size() < all.size()) {
        const Question& question = all[answers.size()];
        const std::optional<double> said = reader.answer(in_words(story, events, question), question.asked);
        if (!reader.is_there()) break;
        answers.push_back(said);
        for (const std::size_t i : just_settled(events, all, answers))
            say(fmt::format("  {}\n", judged(story, events, all[i], *answers[i])));
    }
    say(fmt::format("\n{}\n", in_words(score(events, all, answers))));
}

}  // namespace glassbox
