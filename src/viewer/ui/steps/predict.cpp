#include <algorithm>
#include <array>

#include "viewer/model/story/predicting.hpp"
#include "viewer/ui/steps/parts.hpp"
#include "viewer/ui/widgets/buttons.hpp"
#include "viewer/ui/widgets/wrapped.hpp"

namespace glassbox {

namespace {

/// A button that gives an answer.
struct Choice {
    const char* label;
    double said;
};

void draw_choices(const Frame& frame, std::span<const Choice> choices) {
    for (const auto& [label, said] : choices) {
        if (ImGui::Button(label)) answer(frame.state, frame.results, said);
        ImGui::SameLine();
    }
}

/// A field for a number of bits: Enter answers.
void draw_bits(const Frame& frame, bool is_new) {
    std::string& typed = frame.state.predicting.typed;
    std::array<char, 16> text{};
    std::copy_n(typed.data(), std::min(typed.size(), text.size() - 1), text.data());
    ImGui::SetNextItemWidth(5 * ImGui::GetFontSize());
    if (is_new) ImGui::SetKeyboardFocusHere();
    const bool entered =
        ImGui::InputTextWithHint("##bits", "bits", text.data(), text.size(),
                                 ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CharsDecimal);
    typed = text.data();
    ImGui::SameLine();
    const std::optional<double> said = answer_in(typed, Asked::bits);
    if ((button_if(said.has_value(), "Answer") || entered) && said) answer(frame.state, frame.results, said);
    ImGui::SameLine();
}

/// Whether this question was not yet drawn in the last frame.
bool is_new(const Frame& frame) {
    ImGuiStorage* const storage = ImGui::GetStateStorage();
    const ImGuiID id = ImGui::GetID("asked");
    const int now = static_cast<int>(frame.state.predicting.answers.size()) + 1;
    const bool changed = storage->GetInt(id) != now;
    storage->SetInt(id, now);
    return changed;
}

void draw_question(const Frame& frame, const Question& question) {
    draw_wrapped(frame.palette.accent, in_words(*frame.results.story, frame.results.timeline, question));
    constexpr Choice verdicts[] = {{"Hit (h)", 1}, {"Miss (m)", 0}};
    constexpr Choice signs[] = {{"+ positive", 1}, {"− negative", -1}, {"0 zero", 0}};
    const bool begins = is_new(frame);
    if (question.asked == Asked::hit) draw_choices(frame, verdicts);
    if (question.asked == Asked::sign) draw_choices(frame, signs);
    if (question.asked == Asked::bits) draw_bits(frame, begins);
    if (ImGui::Button("Skip (k)")) answer(frame.state, frame.results, {});
}

/// How the answers went that the last one settled.
void draw_judgement(const Frame& frame) {
    const auto& [story, events, all] = std::tie(frame.results.story, frame.results.timeline, frame.results.questions);
    const Answers& answers = frame.state.predicting.answers;
    for (const std::size_t i : just_settled(events, all, answers)) {
        const bool right = is_right(all[i], *answers[i]);
        draw_wrapped(right ? frame.palette.passed : frame.palette.failed,
                     (right ? "✓ " : "✗ ") + judged(*story, events, all[i], *answers[i]));
    }
}

}  // namespace

void draw_predict(const Frame& frame) {
    ViewerState& state = frame.state;
    bool on = state.predicting.on;
    if (ImGui::Checkbox("Predict first", &on)) set_predicting(state, frame.results, on);
    tip("Be asked before each test: hit or miss, which sign, how many bits (p)");
    if (!state.predicting.on) return;
    ImGui::SameLine(0, 2 * ImGui::GetFontSize());
    ImGui::TextUnformatted(in_words(score_so_far(state)).c_str());
    draw_judgement(frame);
    if (const Question* const question = open_question(state, frame.results)) return draw_question(frame, *question);
    const Question* const next = next_question(state, frame.results);
    if (!next) return draw_wrapped(frame.palette.faint_text, "All that was asked is answered: the steps are yours.");
    if (ImGui::Button("To the next question (End)")) state.step = next->at;
}

}  // namespace glassbox
