#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "explain/json.hpp"
#include "explain/phrases.hpp"
#include "explain/text.hpp"
#include "explain/verdict_phrases.hpp"
#include "viewer/model/story/cursor.hpp"
#include "viewer/model/story/inspector.hpp"
#include "viewer/ui/inspector/drawings.hpp"
#include "viewer/ui/inspector/rows.hpp"
#include "viewer/ui/mine/mine.hpp"
#include "viewer/ui/panels.hpp"
#include "viewer/ui/widgets/wrapped.hpp"

namespace glassbox {

namespace {

/// The story of the pinned pixel, and of the second one; null if there is none.
struct Told {
    const Frame& frame;
    const Story *first, *second;

    bool comparing() const { return second != nullptr; }
};

/// Continues to the right of the last item, if there is room for this width; else below.
void beside_if_it_fits(float width) {
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    if (ImGui::GetItemRectMax().x + gap + width <= right) ImGui::SameLine(0, gap);
}

float button_width(const char* label) { return ImGui::CalcTextSize(label).x + 2 * ImGui::GetStyle().FramePadding.x; }

/// A button that copies the result of `make`, and tells what that is.
template <class Make>
void copy_button(const Frame& frame, const char* label, const char* what, const std::string& told, const Make& make) {
    if (ImGui::Button(label)) copy(frame.state, make(), told);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", what);
}

void draw_tools(const Frame& frame, const Story& story) {
    const std::string whose = fmt::format("the story of pixel ({}, {})", story.x, story.y);
    copy_button(frame, "Copy as text", "All of this, as `glassbox explain` prints it", whose + ", as text",
                [&] { return to_text(story); });
    beside_if_it_fits(button_width("Copy as JSON"));
    copy_button(frame, "Copy as JSON", "All of this, as `glassbox explain --json` prints it", whose + ", as JSON",
                [&] { return to_json(story); });
    beside_if_it_fits(button_width("Copy command"));
    copy_button(frame, "Copy command", story.command.c_str(), story.command, [&] { return story.command; });

    struct Choice {
        NumberForm form;
        const char *label, *what;
    };
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Numbers");
    for (const auto& [form, label, what] :
         {Choice{NumberForm::brief, "short", "six digits; the rest where the mouse points"},
          Choice{NumberForm::full, "full", "as many digits as tell a number from its neighbours"},
          Choice{NumberForm::hex, "hex", "to the bit, as C writes hexadecimal floats"}}) {
        beside_if_it_fits(ImGui::GetFrameHeight() + ImGui::CalcTextSize(label).x +
                          ImGui::GetStyle().ItemInnerSpacing.x);
        if (ImGui::RadioButton(label, frame.state.number_form == form)) frame.state.number_form = form;
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", what);
    }
}

void draw_one(const Frame& frame, const Story& story, const InspectorPart& part, ImU32 color) {
    const float width = ImGui::GetContentRegionAvail().x;
    switch (part.drawing) {
        case Diagram::none:
            return;
        case Diagram::sphere:
            return draw_sphere(frame, story.ray, story.surfaces[*part.surface], width, color);
        case Diagram::triangle:
            return draw_triangle(frame, story.ray, story.surfaces[*part.surface], width, color);
        case Diagram::weights:
            return draw_weights(frame, std::get<story::TriangleTest>(story.surfaces[*part.surface].test), width);
        case Diagram::angles:
            return draw_angles(frame, *story.hit->shade, width);
        case Diagram::terms:
            return draw_terms(frame, story, *story.hit->shade, width);
        case Diagram::bits:
            return draw_bits(frame, story.options, *story.hit, width);
    }
}

void draw_drawings(const Told& told, const Pair<InspectorPart>& part) {
    const auto is_drawn = [](const InspectorPart* p) { return p && p->drawing != Diagram::none; };
    if (!is_drawn(part.first) && !is_drawn(part.second)) return;
    const Palette& palette = told.frame.palette;
    const bool beside = told.comparing() && !one_below_the_other();
    if (beside &&
        !ImGui::BeginTable("drawings", 2, ImGuiTableFlags_SizingStretchSame | ImGuiTableFlags_NoSavedSettings))
        return;
    if (beside) ImGui::TableNextColumn();
    if (is_drawn(part.first)) draw_one(told.frame, *told.first, *part.first, palette.accent);
    if (beside) ImGui::TableNextColumn();
    if (is_drawn(part.second)) draw_one(told.frame, *told.second, *part.second, palette.second);
    if (beside) ImGui::EndTable();
}

void draw_parts(const Told& told, std::span<const Pair<InspectorPart>> parts);

void draw_inside(const Told& told, const Pair<InspectorPart>& part) {
    static const InspectorPart nothing{};
    const InspectorPart& first = part.first ? *part.first : nothing;
    const InspectorPart& second = part.second ? *part.second : nothing;
    draw_drawings(told, part);
    draw_rows(told.frame, paired<InspectorRow>(first.rows, second.rows, &InspectorRow::label), told.comparing());
    draw_parts(told, paired<InspectorPart>(first.parts, second.parts, &InspectorPart::title));
}

/// Draws a heading such as "✓ ■ sphere 0  met, nearest: t = 441.716", after the arrow that opens it.
void draw_heading(const Told& told, const Pair<InspectorPart>& part) {
    const Palette& palette = told.frame.palette;
    const InspectorPart& any = part.first ? *part.first : *part.second;
    if (!told.comparing()) {
        if (any.mark) draw_mark(palette, *any.mark);
        if (any.color) draw_swatch(palette, *any.color);
        const std::string its_note = note(any, told.frame.state.number_form);
        draw_wrapped(palette.text, any.title + (its_note.empty() ? "" : ": " + its_note));
        return;
    }
    ImGui::BeginGroup();
    draw_wrapped(palette.text, any.title);
    for (const auto& [one, color, digit] :
         {std::tuple(part.first, palette.accent, "●"), {part.second, palette.second, "◆"}}) {
        ImGui::PushStyleColor(ImGuiCol_Text, color);
        ImGui::TextUnformatted(digit);
        ImGui::PopStyleColor();
        ImGui::SameLine(0, ImGui::GetFontSize() * .3f);
        if (!one) {
            draw_wrapped(palette.faint_text, "not listed");
            continue;
        }
        if (one->mark) draw_mark(palette, *one->mark);
        draw_wrapped(palette.text, note(*one, told.frame.state.number_form));
    }
    ImGui::EndGroup();
}

/// Which surface a part is about, if it is about one.
std::optional<std::size_t> number_of_surface(const Told& told, const Pair<InspectorPart>& part) {
    if (part.first && part.first->surface) return told.first->surfaces[*part.first->surface].number;
    if (part.second && part.second->surface) return told.second->surfaces[*part.second->surface].number;
    return {};
}

void draw_parts(const Told& told, std::span<const Pair<InspectorPart>> parts) {
    for (const Pair<InspectorPart>& part : parts) {
        const bool open = (part.first && part.first->open) || (part.second && part.second->open);
        const InspectorPart& any = part.first ? *part.first : *part.second;
        // What is open at first has an id of its own, so that the surface met now opens, whatever was closed before.
        const std::string id = fmt::format("##{}{}", any.title, open ? "" : " closed");
        constexpr ImGuiTreeNodeFlags flags = ImGuiTreeNodeFlags_SpanAvailWidth;
        const std::optional<std::size_t> number = number_of_surface(told, part);
        const bool is_lit = number && number == lit_surface(told.frame.state, told.frame.results);
        const bool is_open = ImGui::TreeNodeEx(id.c_str(), flags | (open ? ImGuiTreeNodeFlags_DefaultOpen : 0) |
                                                               (is_lit ? ImGuiTreeNodeFlags_Selected : 0));
        if (number && ImGui::IsItemHovered()) told.frame.state.pointing_at = number;
        ImGui::SameLine();
        draw_heading(told, part);
        if (!is_open) continue;
        draw_inside(told, part);
        ImGui::TreePop();
        ImGui::Spacing();
    }
}

void draw_section(const Told& told, const Pair<InspectorPart>& part) {
    const InspectorPart& any = part.first ? *part.first : *part.second;
    const std::string with_note = fmt::format("{}   {}", any.title, any.note);
    const bool fits = !told.comparing() && ImGui::CalcTextSize(with_note.c_str()).x + 2 * ImGui::GetFrameHeight() <
                                               ImGui::GetContentRegionAvail().x;
    const std::string label = fmt::format("{}###{}", fits ? with_note : any.title, any.title);
    if (!ImGui::CollapsingHeader(label.c_str(), any.open ? ImGuiTreeNodeFlags_DefaultOpen : 0)) return;
    ImGui::PushID(any.title.c_str());
    if (!fits && !told.comparing() && !any.note.empty()) draw_wrapped(told.frame.palette.faint_text, any.note);
    draw_inside(told, part);
    ImGui::PopID();
    ImGui::Spacing();
}

/// A large swatch and its description. The verdict on the only pixel stands above the pages.
void draw_title(const Story& story, const Palette& palette, ImU32 color, const char* digit) {
    const bool of_two = *digit != '\0';
    const float side = 2.2f * ImGui::GetFontSize();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::Dummy({side, side});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, {low.x + side, low.y + side}, to_color(story.color));
    list.AddRect(low, {low.x + side, low.y + side}, color, 0.f, 0, std::max(2.f, side / 18));
    ImGui::SameLine();
    ImGui::BeginGroup();
    draw_wrapped(color, fmt::format("{}Pixel ({}, {})", digit, story.x, story.y));
    draw_mark(palette, mark_of(story));
    draw_wrapped(palette.text, (of_two ? verdict_line(story) + "; " : "") + shown_phrase(story));
    ImGui::EndGroup();
}

}  // namespace

void draw_inspector(const Frame& frame) {
    draw_looked_at(frame);
    const Story* const first = frame.results.story.get();
    const Story* const second = frame.results.compared.get();
    if (!first) {
        ImGui::PushTextWrapPos(0);
        ImGui::TextUnformatted(frame.state.pinned ? "This pixel is being computed …" : "No pixel is pinned.");
        if (!frame.state.pinned) {
            ImGui::Spacing();
            ImGui::TextUnformatted(
                "Click a pixel of the picture: every number that made it stands here, in the order in "
                "which it was computed.");
            ImGui::Spacing();
            ImGui::TextUnformatted(
                "The arrow keys then move the pin by a pixel. Shift+click pins a second pixel, to "
                "compare the two.");
        }
        ImGui::PopTextWrapPos();
        return;
    }
    draw_title(*first, frame.palette, frame.palette.accent, second ? "● " : "");
    if (second) draw_title(*second, frame.palette, frame.palette.second, "◆ ");
    ImGui::Spacing();
    draw_tools(frame, *first);
    ImGui::Spacing();
    InspectorParts& told = frame.inspector;
    told.update(frame.results.story, frame.results.compared);
    for (const Pair<InspectorPart>& part : paired<InspectorPart>(told.first(), told.second(), &InspectorPart::title))
        draw_section({frame, first, second}, part);
}

}  // namespace glassbox
