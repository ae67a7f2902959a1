#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "output/legend_number.hpp"
#include "output/value_words.hpp"
#include "viewer/model/overlay/laid_over.hpp"
#include "viewer/ui/overlay/parts.hpp"

namespace glassbox {

namespace {

void opacity(ViewerState& state) {
    float percent = static_cast<float>(100 * state.overlay.opacity);
    const float label = ImGui::CalcTextSize("Opacity").x + ImGui::GetStyle().ItemInnerSpacing.x;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - label);
    if (ImGui::SliderFloat("Opacity", &percent, 0, 100, "%.0f %%"))
        state.overlay.opacity = std::clamp(percent / 100.0, 0.0, 1.0);
}

/// The least and the greatest value, side by side if there is room.
void ends(const Summary& summary, std::string_view unit) {
    const int digits = digits_between(summary.least, summary.greatest);
    const std::string least = with_unit(legend_number(summary.least, digits), unit);
    if (summary.least == summary.greatest) return ImGui::TextWrapped("every value is %s", least.c_str());
    const std::string left = "least " + least;
    const std::string right = "greatest " + with_unit(legend_number(summary.greatest, digits), unit);
    ImGui::TextWrapped("%s", left.c_str());
    const float room = ImGui::GetContentRegionAvail().x, width = ImGui::CalcTextSize(right.c_str()).x;
    if (ImGui::CalcTextSize(left.c_str()).x + width + ImGui::GetFontSize() < room) ImGui::SameLine(room - width);
    ImGui::TextWrapped("%s", right.c_str());
}

void contour(const Frame& frame, const Measurement& what) {
    const float size = ImGui::GetFontSize();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(at, {at.x + size, at.y + size}, frame.palette.line);
    list.AddLine({at.x, at.y + size * .8f}, {at.x + size * .8f, at.y}, IM_COL32_WHITE, size / 8);
    list.AddLine({at.x + size * .2f, at.y + size}, {at.x + size, at.y + size * .2f}, IM_COL32_BLACK, size / 8);
    ImGui::Dummy({size, size});
    ImGui::SameLine();
    ImGui::TextWrapped("the line: where the values pass %s",
                       with_unit(legend_number(*what.contour), what.unit).c_str());
}

void counts(const Frame& frame, const Measurement& what, const Distribution& of) {
    if (of.coloring.shown) {
        // Its colours are listed even if no value lies outside.
        const auto [low, high] = of.coloring.limits();
        const auto none = [&](std::string_view side) {
            return std::ranges::none_of(of.words, [&](const ColorWord& word) { return word.text.starts_with(side); });
        };
        if (none("below")) swatch(below_color, "below " + legend_number(low) + ": no pixel");
        if (none("above")) swatch(above_color, "above " + legend_number(high) + ": no pixel");
    }
    for (const auto& [color, text, count] : of.words)
        swatch(color, text + ": " + (count == 0 ? "no pixel" : pixels(count)));
    if (of.summary.missing > 0)
        faint(frame, what.scale == Scale::difference
                         ? "At least one of the two has no value there: nothing was measured, or NaN came out."
                         : "Nothing was measured there. What came out as NaN counts as no value, too: the two look the "
                           "same.");
    const std::int64_t outside = of.outside.below + of.outside.above;
    if (what.scale == Scale::direction && outside > 0)
        ImGui::TextWrapped("beyond −1 or 1, shown as if there: %s", pixels(outside).c_str());
}

/// A number field that applies each change as it is typed. Returns whether the number has changed.
bool number_field(const char* label, double& value, float width) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label);
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    ImGui::SetNextItemWidth(width);
    ImGui::PushID(label);
    const bool changed = ImGui::InputDouble("##number", &value, 0, 0, "%.6g");
    ImGui::PopID();
    return changed;
}

std::string_view told_range(const Measurement& what) {
    if (what.range) return "The same for every picture";
    if (what.scale == Scale::diverging || what.scale == Scale::difference)
        return "As far to both sides of 0 as the values reach";
    return "From the least to the greatest value";
}

/// How the values are spaced between the ends of the colours.
void spacing(const Frame& frame, const Measurement& what, const Coloring& coloring) {
    Overlay& overlay = frame.state.overlay;
    const std::string usual =
        fmt::format("automatic: {}", name_where(spacings, [&](Spacing each) { return each == spacing_of(what, {}); }));
    const auto label = [&](Spacing each) {
        return std::string(name_where(spacings, [&](Spacing other) { return other == each; }));
    };
    ImGui::TextUnformatted("Scale of the colours");
    ImGui::SetNextItemWidth(-1);
    if (ImGui::BeginCombo("##spacing", overlay.spacing ? label(*overlay.spacing).c_str() : usual.c_str())) {
        if (ImGui::Selectable(usual.c_str(), !overlay.spacing)) overlay.spacing.reset();
        for (const auto& each : spacings)
            if (spacing_of(what, each.value) == each.value &&
                ImGui::Selectable(fmt::format("{}: {}", each.name, each.help).c_str(), overlay.spacing == each.value))
                overlay.spacing = each.value;
        ImGui::EndCombo();
    }
    if (overlay.spacing == Spacing::log && coloring.spacing != Spacing::log)
        faint(frame, "Nothing is above 0: a linear scale is shown.");
}

void range(const Frame& frame, const Measurement& what, const Summary& summary, const Coloring& coloring) {
    Overlay& overlay = frame.state.overlay;
    if (what.scale == Scale::direction) return faint(frame, "The colours always run from −1 to 1.");
    if (!what.words.empty()) return;
    spacing(frame, what, coloring);
    if (coloring.spacing == Spacing::percentile) return;
    ImGui::TextUnformatted("Range of the colours");
    if (ImGui::RadioButton("automatic", !overlay.range)) overlay.range.reset();
    ImGui::SameLine();
    if (ImGui::RadioButton("set", overlay.range.has_value()) && !overlay.range) overlay.range = coloring.limits();
    const bool wider = coloring.limits() != std::pair(summary.least, summary.greatest);
    if (summary.least < summary.greatest && wider && ImGui::Button("From the least to the greatest"))
        overlay.range = {summary.least, summary.greatest};
    if (!overlay.range) return faint(frame, std::string(told_range(what)) + ".");

    const ImGuiStyle& style = ImGui::GetStyle();
    const float labels = ImGui::CalcTextSize("from").x + ImGui::CalcTextSize("to").x + 2 * style.ItemInnerSpacing.x;
    const float room = ImGui::GetContentRegionAvail().x, unit = ImGui::CalcTextSize(what.unit.data()).x;
    const float width = std::clamp((room - labels - unit - 3 * style.ItemSpacing.x) / 2,
                                   std::min(4 * ImGui::GetFontSize(), room / 2), 9 * ImGui::GetFontSize());
    auto [low, high] = *overlay.range;
    bool changed = number_field("from", low, width);
    if (labels + 2 * width + style.ItemSpacing.x < room) ImGui::SameLine();
    changed = number_field("to", high, width) || changed;
    if (!what.unit.empty()) {
        if (labels + 2 * width + unit + 2 * style.ItemSpacing.x < room) ImGui::SameLine();
        ImGui::TextUnformatted(what.unit.data(), what.unit.data() + what.unit.size());
    }
    // While a number is being typed, it may temporarily be on the wrong side of the other.
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    const ImGuiID wrong = ImGui::GetID("wrong range");
    if (changed) {
        const bool right = std::isfinite(low) && std::isfinite(high) && low <= high;
        if (right) overlay.range = {low, high};
        storage.SetBool(wrong, !right);
    } else if (!ImGui::IsAnyItemActive()) storage.SetBool(wrong, false);
    if (storage.GetBool(wrong)) {
        ImGui::PushStyleColor(ImGuiCol_Text, frame.palette.failed);
        ImGui::TextWrapped("✗ \"from\" must not be above \"to\": not used yet");
        ImGui::PopStyleColor();
    }
    if (ImGui::Button("Reset to automatic")) overlay.range.reset();
}

}  // namespace

void swatch(Rgb color, const std::string& text) {
    const float size = ImGui::GetFontSize();
    const ImVec2 at = ImGui::GetCursorScreenPos(), end{at.x + size, at.y + size};
    ImGui::GetWindowDrawList()->AddRectFilled(at, end, IM_COL32(color.red, color.green, color.blue, 255));
    ImGui::GetWindowDrawList()->AddRect(at, end, ImGui::GetColorU32(ImGuiCol_TextDisabled));
    ImGui::Dummy({size, size});
    ImGui::SameLine();
    ImGui::TextWrapped("%s", text.c_str());
}

void faint(const Frame& frame, std::string_view text) {
    ImGui::PushStyleColor(ImGuiCol_Text, frame.palette.faint_text);
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
}

void draw_legend(const Frame& frame) {
    ViewerState& state = frame.state;
    opacity(state);
    ImGui::Checkbox("Legend on the picture", &state.overlay.legend_shown);
    const MeasuredChannels* const measured = last_laid_over(state, frame.results);
    const std::vector<Distribution>& distributions = frame.pictures.distributions();
    if (!measured || distributions.empty()) return faint(frame, "… being measured");
    const Measurement& what = *measured->what;
    if (measured->factor > 1) {
        ImGui::PushStyleColor(ImGuiCol_Text, frame.palette.warning);
        ImGui::TextWrapped("… coarse: 1/%d of its width and height so far, being measured", measured->factor);
        ImGui::PopStyleColor();
    }
    const Summary& summary = distributions.front().summary;
    const bool any = summary.any_finite() || summary.negative_infinite + summary.positive_infinite > 0;
    if (!any && summary.missing > 0) {
        ImGui::PushStyleColor(ImGuiCol_Text, frame.palette.warning);
        ImGui::TextWrapped("No pixel has a value (%s).", measured->channels.front().why_no_value.c_str());
        ImGui::PopStyleColor();
        return;
    }
    if (!what.unit.empty())
        ImGui::TextWrapped("%s in %s", std::string(what.name).c_str(), std::string(what.unit).c_str());
    if (what.scale == Scale::direction)
        for (int axis = 0; axis < 3; ++axis) draw_histogram(frame, axis);
    else draw_histogram(frame, -1);
    if (summary.any_finite() && what.scale != Scale::direction && what.words.empty()) ends(summary, what.unit);
    if (what.contour) contour(frame, what);
    counts(frame, what, distributions.front());
    draw_found(frame, *measured);
    range(frame, what, summary, distributions.front().coloring);
}

}  // namespace glassbox
