#include "viewer/ui/mine/mine.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "render/option_names.hpp"
#include "viewer/ui/overlay/parts.hpp"
#include "viewer/ui/widgets/buttons.hpp"
#include "viewer/ui/widgets/wrapped.hpp"

namespace glassbox {

namespace {

using learn::mine::PictureUpdate;
using learn::mine::Stand;

/// The line that does not compile, with a caret below the place.
std::string source_of(const std::optional<learn::CompileError>& error) {
    return error && !error->source.empty() ? learn::with_caret(*error) : "";
}

MineSign sign_of(const Palette& palette, Stand stand) {
    switch (stand) {
        case Stand::not_there:
            return {"⚠", palette.warning};
        case Stand::compiling:
        case Stand::drawing:
            return {"…", palette.faint_text};
        case Stand::not_written:
            return {"☐", palette.warning};
        case Stand::drawn:
            return {"✓", palette.passed};
        case Stand::does_not_compile:
        case Stand::failed:
            break;
    }
    return {"✗", palette.failed};
}

void draw_source_of(const Frame& frame, const std::optional<learn::CompileError>& error) {
    const std::string source = source_of(error);
    if (source.empty()) return;
    ImGui::PushFont(frame.fonts.mono);
    ImGui::TextUnformatted(source.c_str());
    ImGui::PopFont();
}

std::string how_long(const PictureUpdate& update) {
    std::string text = fmt::format("drawn in {:.2f} s", update.draw_seconds);
    if (update.compile_seconds > 0) text = fmt::format("compiled in {:.1f} s, ", update.compile_seconds) + text;
    return text;
}

}  // namespace

MineSign mine_sign(const Frame& frame) {
    const Palette& palette = frame.palette;
    if (!frame.state.mine.problem.empty()) return {"⚠", palette.warning};
    if (!frame.results.mine) return {"…", palette.faint_text};
    const MineSign sign = sign_of(palette, frame.results.mine->stand);
    return frame.results.mine->spot && frame.results.mine->stand == Stand::drawn ? MineSign{"⚠", palette.warning}
                                                                                 : sign;
}

std::string mine_words(const Frame& frame) {
    if (!frame.state.mine.problem.empty()) return frame.state.mine.problem;
    if (!frame.results.mine) return "";
    const PictureUpdate& update = *frame.results.mine;
    if (!update.error || update.error->plain.empty()) return update.words;
    return update.words + "\n" + update.error->plain;
}

void draw_lesson_choice(const Frame& frame) {
    ViewerState& state = frame.state;
    if (!state.mine.workspace) return;
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Lesson");
    for (const learn::Exercise& exercise : state.mine.workspace->exercises) {
        const std::string label = fmt::format("{}##mine", exercise.number);
        flow(label.c_str(), ImGui::GetStyle().ItemInnerSpacing.x);
        if (toggle(label.c_str(), state.mine.chosen == LessonChoice(exercise.number)))
            show_mine(state, exercise.number);
        tip(exercise.title.c_str());
    }
    constexpr const char* all = "all that I have written##mine";
    flow(all, ImGui::GetStyle().ItemInnerSpacing.x);
    if (toggle(all, is_of_all(state.mine))) show_mine(state, AllLessons{});
    tip("Every lesson that you have finished draws, all at once");
}

std::string mine_title(const ViewerState& state) {
    if (is_of_all(state.mine)) return "mine: all that I have written";
    const learn::Exercise* const exercise = exercise_of(state.mine);
    return "mine: " + (exercise ? exercise->name : "no lesson");
}

bool mine_is_old(const Frame& frame) {
    return frame.results.mine && !frame.results.mine->drawing && frame.results.other.image;
}

void draw_mine_banner(const Frame& frame, ImVec2 corner, ImVec2 size, float left) {
    const std::string words = mine_words(frame);
    if (words.empty()) return;
    const auto [sign, color] = mine_sign(frame);
    const float font = ImGui::GetFontSize(), pad = font / 2;
    const float room = corner.x + size.x - left - 3 * pad;
    if (room < 6 * font) return;
    const std::string text = wrapped(fmt::format("{} {}", sign, words), room);
    const std::string source = frame.results.mine ? source_of(frame.results.mine->error) : "";
    const ImVec2 extent = ImGui::CalcTextSize(text.c_str());
    const ImVec2 lines = frame.fonts.mono->CalcTextSizeA(font, 1e9f, 0, source.c_str());
    const float below = source.empty() ? 0 : lines.y + pad / 2;
    const ImVec2 to{std::min(corner.x + size.x - pad / 2, left + 2.5f * pad + std::max(extent.x, lines.x)),
                    corner.y + size.y - pad / 2};
    const ImVec2 from{left + pad / 2, std::max(corner.y, to.y - extent.y - below - 2 * pad)};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(from, to, ImGui::GetColorU32(ImGuiCol_PopupBg), pad / 2);
    list.AddRect(from, to, color, pad / 2, 0, std::max(2.f, font / 9));
    list.PushClipRect(from, to, true);
    list.AddText(ImGui::GetFont(), font, {from.x + pad, from.y + pad}, frame.palette.text, text.c_str());
    if (!source.empty())
        list.AddText(frame.fonts.mono, font, {from.x + pad, from.y + pad + extent.y + pad / 2}, frame.palette.text,
                     source.c_str());
    list.PopClipRect();
}

void draw_mine_state(const Frame& frame) {
    ViewerState& state = frame.state;
    const auto [sign, color] = mine_sign(frame);
    const std::string words = mine_words(frame);
    const PictureUpdate* const update = frame.results.mine.get();
    const bool drawn = update && update->stand == Stand::drawn;
    draw_wrapped(color, fmt::format("{} {}", sign, words.empty() && drawn ? how_long(*update) : words));
    if (!update) return;
    if (update->drawing && !update->by_whom.empty()) draw_wrapped(update->by_whom);
    draw_source_of(frame, update->error);
    if (update->error && update->error->others > 0)
        faint(frame, fmt::format("and {} more after it, which it may have caused", update->error->others));
    if (update->spot && ImGui::Button(fmt::format("Pin ({}, {})", update->spot->x, update->spot->y).c_str()))
        pin(state, *update->spot);
    if (mine_is_old(frame)) faint(frame, "The picture is the last one that there was.");
    if (drawn && update->drawing->not_numbers > 0) swatch({255, 0, 255}, "not a number (NaN)");
    if (drawn && update->drawing->undecided > 0) swatch({255, 160, 0}, "undecided; counted below where it is not ours");
    if (state.mine.chosen && state.setup.now().options.scalar != scalar_of(state.mine))
        draw_wrapped(frame.palette.warning,
                     fmt::format("⚠ Ours is not computed in {} now: it may differ from mine by rounding alone.",
                                 name_of(scalar_of(state.mine))));
    if (update->said.empty()) return;
    faint(frame, "It printed:");
    ImGui::PushFont(frame.fonts.mono);
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(update->said.c_str(),
                           update->said.c_str() + std::min<std::size_t>(update->said.size(), 2000));
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
}

void draw_recording(const Frame& frame) {
    const learn::mine::RecordingUpdate& update = frame.results.mine_steps.update;
    if (!frame.state.mine.problem.empty()) return draw_wrapped(frame.palette.warning, "⚠ " + frame.state.mine.problem);
    if (update.words.empty()) return;
    const auto [sign, color] = sign_of(frame.palette, update.stand);
    draw_wrapped(color, fmt::format("{} {}", sign, update.words));
    if (!update.error) return;
    draw_source_of(frame, update.error);
    if (!update.error->plain.empty()) draw_wrapped(update.error->plain);
}

}  // namespace glassbox
