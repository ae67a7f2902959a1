#pragma once
#include <algorithm>
#include <string_view>
#include <type_traits>
#include <variant>

#include "render/parameters.hpp"
#include "scene/named.hpp"
#include "viewer/ui/panels.hpp"
#include "viewer/ui/widgets/slider.hpp"

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

/// Whether the second click of a double click is being held: it means "as the scene says", not a position on the
/// slider.
inline bool is_double_clicked() {
    return ImGui::IsItemActive() && ImGui::GetIO().MouseDown[0] && ImGui::GetIO().MouseClickedLastCount[0] >= 2;
}

/// A slider for the number that is that member of the setup. A double click, or the button
/// that appears when it differs, restores the scene's own value. With Ctrl a number can be typed, also beyond the
/// slider's ends, from 0 on.
template <class Member>
void setup_slider(ViewerState& state, const Parameter& parameter, Member member) {
    const auto& [least, most, format, is_logarithmic] = parameter.range;
    ImGui::PushID(parameter.label);
    const double now = part(state.setup.now(), member);
    const Setup scenes = setup_of(*state.scene);
    const double own = part(scenes, member);
    double value = now;
    const float button = ImGui::GetFrameHeight(), gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const bool moved = slider("##value", parameter.label, value, {least, most, format, is_logarithmic}, button + gap);
    const bool again = is_double_clicked();
    if (ImGui::IsItemHovered() && !ImGui::IsItemActive())
        ImGui::SetTooltip("Ctrl+click to type a number; double click: as the scene says");
    if (again) value = own;
    if ((moved || again) && value >= 0 && value <= 1e300)
        drag_setup(state, [&](Setup& next) { part(next, member) = value; });
    if (now != own) {
        ImGui::SameLine(0, gap);
        if (ImGui::Button("↺", {button, 0})) change_setup(state, [&](Setup& next) { part(next, member) = own; });
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("as the scene says: %g", own);
    }
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

/// A slider for a parameter that is a number, 0 or more; nothing for another one.
inline void offer_slider(ViewerState& state, const Parameter& parameter) {
    std::visit(
        [&](auto member) {
            using Value = std::remove_cvref_t<decltype(part(state.setup.now(), member))>;
            if constexpr (std::is_same_v<Value, double>) setup_slider(state, parameter, member);
        },
        parameter.member);
}

/// A list for a parameter that is chosen by name; nothing for another one.
inline void offer_choice(const Frame& frame, const Parameter& parameter) {
    std::visit(
        [&](auto member) {
            const auto now = part(frame.state.setup.now(), member);
            using Value = std::remove_const_t<decltype(now)>;
            if constexpr (is_choice<Value>) {
                const auto choose = [&](const Value& value) {
                    change_setup(frame.state, [&](Setup& setup) { part(setup, member) = value; });
                };
                choice(frame, parameter.label, choices<Value>, name_of(now), choose);
            }
        },
        parameter.member);
}

}  // namespace glassbox
