#include "viewer/ui/space/boxes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "viewer/model/space/flight.hpp"
#include "viewer/ui/widgets/buttons.hpp"

namespace glassbox {

namespace {

float sample_length() { return ImGui::GetFontSize() * 1.8f; }

/// A sample of a box's line style, its middle at this height.
void paint_sample(const SpaceCanvas& canvas, ImVec2 at, const BoxLine& line) {
    const float length = sample_length();
    if (!line.dashed) {
        canvas.list.AddLine(at, {at.x + length, at.y}, line.color, line.width);
        return;
    }
    constexpr int dashes = 4;  // and three gaps between them
    const float piece = length / (2 * dashes - 1);
    for (int i = 0; i < dashes; ++i) {
        const float from = at.x + 2 * piece * static_cast<float>(i);
        canvas.list.AddLine({from, at.y}, {from + piece, at.y}, line.color, line.width);
    }
}

/// Draws words from `left` on, below `top`, on a background of their own. Returns where they end.
float paint_words(const SpaceCanvas& canvas, Labels& labels, float left, float top, const std::string& words,
                  ImU32 color) {
    const float pad = ImGui::GetFontSize() * .3f, room = canvas.corner.x + static_cast<float>(canvas.camera.area.x);
    const float width = std::clamp(room - left - pad, 1.f, 30 * ImGui::GetFontSize());
    const ImVec2 size = ImGui::CalcTextSize(words.c_str(), nullptr, false, width);
    const ImVec2 end{left + size.x, top + size.y};
    labels.keep_free({canvas.corner.x, top}, end);
    canvas.list.AddRectFilled({left - pad, top}, {end.x + pad, end.y}, faded(canvas.frame.palette.canvas, .85));
    canvas.list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {left, top}, color, words.c_str(), nullptr, width);
    return end.y;
}

/// "level 3 of 7".
std::string words_of_level(const Frame& frame) {
    const std::optional<int> level = shown_level(frame.state, frame.results);
    if (!level) return frame.results.boxes ? "no boxes" : "…";
    return fmt::format("level {} of {}", *level, frame.results.boxes->deepest());
}

}  // namespace

BoxLine line_of(const SpaceCanvas& canvas, Passage passage) {
    const Palette& palette = canvas.frame.palette;
    const float width = line_width();
    if (passage == Passage::opened) return {palette.box, 1.9f * width, false};
    if (passage == Passage::met) return {palette.box, 1.5f * width, true};
    // The more boxes there are, the fainter is each; still fainter if others must stand out.
    const BoxesOnLevel* const shown = canvas.frame.boxes.shown();
    const double count = shown ? static_cast<double>(shown->drawn.size()) : 1;
    const double opacity = std::clamp(9 / std::sqrt(count), .25, .75) * (shown && shown->met > 0 ? .8 : 1);
    return {faded(palette.faint_text, opacity), std::max(1.f, .7f * width), false};
}

ImVec2 draw_box_buttons(const Frame& frame, ImVec2 at) {
    ViewerState& state = frame.state;
    const ImGuiStyle& style = ImGui::GetStyle();
    const float gap = style.ItemInnerSpacing.x;
    ImGui::SetCursorScreenPos(at);
    if (toggle("Boxes", state.box_level.has_value())) {
        if (state.box_level) state.box_level.reset();
        else state.box_level = 0;
    }
    tip("The boxes in which the engine sorts surfaces, level by level (b)");
    if (frame.results.story && frame.results.story->hit) {
        ImGui::SameLine(0, gap);
        const bool is_back = flies_back(state);
        if (ImGui::Button(is_back ? "All" : "To the hit")) fly_to_hit_or_back(state);
        tip(is_back ? "Fly back to where all is in sight (z)" : "Fly to the ray's first hit (z)");
    }
    if (!state.box_level) return ImGui::GetItemRectMax();
    const std::optional<int> level = shown_level(state, frame.results);
    ImGui::SameLine(0, gap);
    if (button_if(level && *level > 0, "−##boxes")) go_back(state, frame.results);
    tip("A level back, to fewer and larger boxes (Shift+b)");
    const std::string words = words_of_level(frame);
    const ImVec2 from{ImGui::GetItemRectMax().x, at.y};
    const float width = ImGui::CalcTextSize(words.c_str()).x + 2 * gap;
    ImGui::GetWindowDrawList()->AddRectFilled(from, {from.x + width, at.y + ImGui::GetFrameHeight()},
                                              faded(frame.palette.canvas, .85));
    ImGui::SameLine(0, gap);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(words.c_str());
    ImGui::SameLine(0, gap);
    if (button_if(level && *level < frame.results.boxes->deepest(), "+##boxes")) go_deeper(state, frame.results);
    tip("A level deeper, to more and smaller boxes (b)");
    return ImGui::GetItemRectMax();
}

float paint_box_legend(const SpaceCanvas& canvas, Labels& labels, float top) {
    const BoxesInWords& words = canvas.frame.boxes.words();
    const float font = ImGui::GetFontSize(), left = canvas.corner.x + font * .3f;
    const auto row = [&](const std::string& text, Passage passage) {
        if (text.empty()) return;
        float from = left;
        if (canvas.frame.boxes.shown()) {
            BoxLine line = line_of(canvas, passage);
            if (passage == Passage::missed) line.color = canvas.frame.palette.faint_text;  // must be visible
            paint_sample(canvas, {left, top + font / 2}, line);
            from += sample_length() + font * .5f;
        }
        top = paint_words(canvas, labels, from, top, text, canvas.frame.palette.text);
    };
    row(words.boxes, Passage::missed);
    row(words.met, Passage::met);
    row(words.opened, Passage::opened);
    if (!words.whole.empty())
        top = paint_words(canvas, labels, left, top, words.whole, canvas.frame.palette.faint_text);
    return top;
}

}  // namespace glassbox
