#pragma once
#include <algorithm>
#include <string_view>

#include "scene/named.hpp"
#include "viewer/ui/panels.hpp"

namespace glassbox {

/// Applies a change made by one click.
template <class Change>
void change_setup(ViewerState& state, const Change& change) {
    Setup setup = state.setup.now();
    change(setup);
    state.setup.change(std::move(setup));
}

/// Applies a change made by the item that was just drawn: one drag, or one number typed, is one undo step.
template <class Change>
void drag_setup(ViewerState& state, const Change& change) {
    if (ImGui::IsItemActivated()) state.setup.end_drag();
    Setup setup = state.setup.now();
    change(setup);
    state.setup.drag(std::move(setup));
}

/// What a number may be, and how it is shown.
struct Range {
    double least, most;
    const char* format;
    bool logarithmic = false;
};

/// Whether the second click of a double click is being held: it means "as the scene says", not a position on the
/// slider.
inline bool is_double_clicked() {
    return ImGui::IsItemActive() && ImGui::GetIO().MouseDown[0] && ImGui::GetIO().MouseClickedLastCount[0] >= 2;
}

/// A slider with its label on the right, for the number that `get(setup)` refers to. A double click, or the button that
/// appears when it differs, restores `own`, the scene's own value. With Ctrl a number can be typed, also beyond the
/// slider's ends, from 0 on.
template <class Get>
void setup_slider(ViewerState& state, const char* label, double own, const Range& range, const Get& get) {
    ImGui::PushID(label);
    Setup setup = state.setup.now();
    double value = get(setup);
    const ImGuiStyle& style = ImGui::GetStyle();
    const float button = ImGui::GetFrameHeight(), font = ImGui::GetFontSize();
    const float name = std::min(8 * font, ImGui::GetContentRegionAvail().x * .4f);
    ImGui::SetNextItemWidth(
        std::max(3 * font, ImGui::GetContentRegionAvail().x - name - button - 2 * style.ItemInnerSpacing.x));
    const bool moved = ImGui::SliderScalar("##value", ImGuiDataType_Double, &value, &range.least, &range.most,
                                           range.format, range.logarithmic ? ImGuiSliderFlags_Logarithmic : 0);
    const bool again = is_double_clicked();
    if (ImGui::IsItemHovered() && !ImGui::IsItemActive())
        ImGui::SetTooltip("Ctrl+click to type a number; double click: as the scene says");
    if (again) value = own;
    if ((moved || again) && value >= 0 && value <= 1e300) drag_setup(state, [&](Setup& next) { get(next) = value; });
    ImGui::SameLine(0, style.ItemInnerSpacing.x);
    if (get(setup) != own) {
        if (ImGui::Button("↺", {button, 0})) change_setup(state, [&](Setup& next) { get(next) = own; });
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("as the scene says: %g", own);
    } else {
        ImGui::Dummy({button, button});
    }
    ImGui::SameLine(0, style.ItemInnerSpacing.x);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label);
    ImGui::PopID();
}

/// A list of the names in a table, each with its line of help; calls `choose(value)` when another one is chosen.
template <class Table, class Choose>
void choice(const Frame& frame, const char* label, const Table& table, std::string_view present, const Choose& choose) {
    const float font = ImGui::GetFontSize();
    ImGui::TextUnformatted(label);
    ImGui::SetNextItemWidth(-1);
    const float widest = std::min(34 * font, ImGui::GetMainViewport()->WorkSize.x * .9f);
    ImGui::SetNextWindowSizeConstraints({0, 0}, {widest, 1e9f});
    ImGui::PushID(label);
    std::string_view help;
    for (const auto& entry : table)
        if (entry.name == present) help = entry.help;
    if (ImGui::BeginCombo("##choice", std::string(present).c_str())) {
        for (const auto& entry : table) {
            if (ImGui::Selectable(std::string(entry.name).c_str(), entry.name == present) && entry.name != present)
                choose(entry.value);
            ImGui::Indent(font);
            ImGui::PushStyleColor(ImGuiCol_Text, frame.palette.faint_text);
            ImGui::PushTextWrapPos(widest - font);
            ImGui::TextUnformatted(entry.help.data(), entry.help.data() + entry.help.size());
            ImGui::PopTextWrapPos();
            ImGui::PopStyleColor();
            ImGui::Unindent(font);
        }
        ImGui::EndCombo();
    }
    ImGui::PopID();
    ImGui::PushStyleColor(ImGuiCol_Text, frame.palette.faint_text);
    ImGui::TextWrapped("%s", std::string(help).c_str());
    ImGui::PopStyleColor();
}

}  // namespace glassbox
