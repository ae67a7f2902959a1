#include "viewer/ui/overlay/beside.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <string_view>

#include "render/option_names.hpp"
#include "viewer/ui/mine/mine.hpp"
#include "viewer/ui/overlay/parts.hpp"
#include "viewer/ui/widgets/edit.hpp"
#include "viewer/ui/widgets/wrapped.hpp"

namespace glassbox {

namespace {

void choose_other(const Frame& frame) {
    Options& other = frame.state.other;
    choice(frame, "The other scalar", scalars, name_of(other.scalar), [&](Scalar scalar) { other.scalar = scalar; });
    choice(frame, "Its triangle rule", triangle_rules, name_of(other.triangle_rule),
           [&](const TriangleRule& rule) { other.triangle_rule = rule; });
    if (auto* rule = std::get_if<Tolerance>(&other.triangle_rule)) {
        double value = rule->tolerance;
        ImGui::TextUnformatted("Its tolerance, in units of length³");
        ImGui::SetNextItemWidth(-1);
        if (ImGui::InputDouble("##tolerance", &value, 0, 0, "%.6g") && std::isfinite(value) && value >= 0)
            rule->tolerance = value;
    }
    choice(frame, "Its sphere rule", sphere_rules, name_of(other.sphere_rule),
           [&](const SphereRule& rule) { other.sphere_rule = rule; });
}

bool computed_alike(const Options& one, const Options& other) {
    return one.scalar == other.scalar && one.sphere_rule == other.sphere_rule &&
           one.triangle_rule == other.triangle_rule;
}

void tell_difference(const Frame& frame) {
    const auto& differing = frame.pictures.differing();
    if (!differing || frame.results.busy) return faint(frame, "… both are being rendered");
    const double all = 1.0 * frame.state.scene->width * frame.state.scene->height;
    if (differing->pixels == 0) {
        ImGui::TextWrapped("No pixel differs.");
        return;
    }
    ImGui::TextWrapped("%s", fmt::format("{} of {:.0f} {} ({:.2g} %), by at most {} of 255", differing->pixels, all,
                                         differing->pixels == 1 ? "differs" : "differ",
                                         100 * static_cast<double>(differing->pixels) / all, differing->greatest)
                                 .c_str());
    const auto [x, y] = differing->where;
    if (ImGui::Button(fmt::format("Pin ({}, {}), where it is greatest", x, y).c_str()))
        pin(frame.state, differing->where);
}

/// Shows which brightness stands for which difference.
void difference_legend(const Frame& frame) {
    constexpr int magnification = Difference::magnification, brightest = 255 / magnification;
    faint(frame,
          fmt::format("The difference is drawn {} times as bright: black where nothing differs.", magnification));
    const float size = ImGui::GetFontSize(), width = ImGui::GetContentRegionAvail().x - size;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto x = [&](int difference) { return at.x + width * static_cast<float>(difference) / (brightest + 2); };
    for (int d = 0; d <= brightest + 1; ++d) {
        const int level = std::min(255, magnification * d);
        list.AddRectFilled({x(d), at.y}, {x(d + 1), at.y + size}, IM_COL32(level, level, level, 255));
    }
    list.AddRect(at, {x(brightest + 2), at.y + size}, frame.palette.line);
    for (const int d : {0, 8, 16, 24, brightest + 1}) {
        const std::string label = d > brightest ? fmt::format("{}+", d) : std::to_string(d);
        const float middle = (x(d) + x(d + 1)) / 2;
        list.AddLine({middle, at.y + size}, {middle, at.y + size * 1.25f}, frame.palette.text);
        list.AddText({std::max(at.x, middle - ImGui::CalcTextSize(label.c_str()).x / 2), at.y + size * 1.25f},
                     frame.palette.text, label.c_str());
    }
    ImGui::Dummy({width, size * 2.4f});
    faint(frame, "of 255, in each of red, green and blue");
}

}  // namespace

std::string how_computed(const Options& options) {
    std::string text(name_of(options.scalar));
    if (options.stage >= 3) text += ", " + written(options.triangle_rule);
    if (options.stage >= 2) text += ", " + std::string(name_of(options.sphere_rule));
    return text;
}

void draw_beside(const Frame& frame) {
    ViewerState& state = frame.state;
    const float room =
        ImGui::GetContentRegionAvail().x - ImGui::GetFrameHeight() - ImGui::GetStyle().ItemInnerSpacing.x;
    const auto radio = [&](Beside beside, std::string_view text) {
        const std::string label = wrapped(text, room) + "###" + std::string(text);  // the same wherever it breaks
        if (!ImGui::RadioButton(label.c_str(), state.beside == beside)) return false;
        show_beside(state, beside);
        return true;
    };
    radio(Beside::nothing, "nothing");
    radio(Beside::overlay, "the overlay");
    const bool chosen = radio(Beside::other, "another scalar or rule");
    const bool chosen_difference = radio(Beside::difference, "their difference");
    radio(Beside::mine, "my code");
    radio(Beside::mine_difference, "my code's difference from ours");
    const bool with_other = state.beside == Beside::other || state.beside == Beside::difference;
    // Make the two differ, so that there is something to see at once.
    if ((chosen || chosen_difference) && computed_alike(state.setup.now().options, state.other))
        state.other.scalar = state.other.scalar == Scalar::float_ ? Scalar::double_ : Scalar::float_;
    if (state.beside == Beside::nothing) faint(frame, "One picture; the overlay lies over all of it.");
    else faint(frame, "On the right of the split: drag its handle on the picture.");
    if (state.beside == Beside::overlay && state.overlay.measurement.empty())
        faint(frame, "Nothing is laid over yet: choose a measurement above.");
    if (shows_mine(state)) {
        draw_lesson_choice(frame);
        draw_mine_state(frame);
        if (frame.results.mine && frame.results.mine->stand == learn::mine::Stand::drawn) tell_difference(frame);
        if (state.beside == Beside::mine_difference) difference_legend(frame);
    }
    if (!with_other) return;
    const Options& now = state.setup.now().options;
    ImGui::TextWrapped("this: %s", how_computed(now).c_str());
    if (computed_alike(now, state.other)) {
        ImGui::PushStyleColor(ImGuiCol_Text, frame.palette.warning);
        ImGui::TextWrapped("The other is computed as this one is: choose another scalar or rule.");
        ImGui::PopStyleColor();
    }
    tell_difference(frame);
    if (state.beside == Beside::difference) difference_legend(frame);
    choose_other(frame);
}

}  // namespace glassbox
