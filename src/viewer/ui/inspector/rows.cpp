#include "viewer/ui/inspector/rows.hpp"

#include <algorithm>

#include "explain/verdict_phrases.hpp"
#include "viewer/ui/inspector/drawings.hpp"
#include "viewer/ui/widgets/wrapped.hpp"

namespace glassbox {

namespace {

/// Places items side by side as long as they fit, then below.
class Flow {
public:
    Flow() : right_(ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x) {}

    void item(ImU32 color, const std::string& text) { place(color, text, ImGui::CalcTextSize(text.c_str()).x); }

    /// Words, which may be wrapped beside what stands before them.
    void words(ImU32 color, const std::string& text) {
        constexpr float least = 10;  // letters' heights
        place(color, text, std::min(ImGui::CalcTextSize(text.c_str()).x, least * ImGui::GetFontSize()));
    }
    /// Lets further items follow on this line.
    void begun() { first_ = false; }

private:
    void place(ImU32 color, const std::string& text, float least_width) {
        const float gap = ImGui::GetFontSize() * .5f;
        if (!first_ && ImGui::GetItemRectMax().x + gap + least_width <= right_) ImGui::SameLine(0, gap);
        first_ = false;
        draw_wrapped(color, text);
    }

    float right_;
    bool first_ = true;
};

void draw_facts(const InspectedNumber& number) {
    if (!ImGui::IsItemHovered()) return;
    ImGui::BeginTooltip();
    if (ImGui::BeginTable("facts", 2, ImGuiTableFlags_SizingFixedFit)) {
        for (const NumberFact& fact : facts(number)) {
            ImGui::TableNextRow();
            ImGui::TableNextColumn();
            ImGui::TextDisabled("%s", fact.name.c_str());
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(fact.text.c_str());
        }
        ImGui::EndTable();
    }
    ImGui::EndTooltip();
}

/// Unlike ==, counts two NaNs as equal.
bool same(const InspectedNumber& a, const InspectedNumber& b) {
    return written(a, NumberForm::hex) == written(b, NumberForm::hex);
}

bool same(const InspectorRow& a, const InspectorRow& b) {
    return a.note == b.note && a.mark == b.mark &&
           std::equal(a.numbers.begin(), a.numbers.end(), b.numbers.begin(), b.numbers.end(),
                      [](const auto& x, const auto& y) { return same(x, y); });
}

ImU32 color_of(const Palette& palette, const std::string& label) {
    if (label == "a") return palette.a;
    if (label == "b") return palette.b;
    if (label == "c") return palette.c;
    if (label == "n·l") return palette.n_l;
    if (label == "n·r") return palette.n_r;
    if (label == "n·h" || label == "r·m") return palette.n_h;
    return palette.faint_text;
}

void draw_value(const Frame& frame, const InspectorRow& row, bool different) {
    const Palette& palette = frame.palette;
    const NumberForm form = frame.state.number_form;
    if (different) {
        ImGui::PushStyleColor(ImGuiCol_Text, palette.warning);
        ImGui::TextUnformatted("≠");
        ImGui::PopStyleColor();
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("differs from the first pixel's");
        ImGui::SameLine(0, ImGui::GetFontSize() * .3f);
    }
    if (row.mark) draw_mark(palette, *row.mark);
    if (row.color) draw_swatch(palette, *row.color);
    ImGui::BeginGroup();
    Flow flow;
    ImGui::PushFont(frame.fonts.mono);
    if (row.numbers.size() == 1) {
        const InspectedNumber& number = row.numbers.front();
        const auto [value, its_bound] = written_with_bound(number, form);
        flow.item(palette.text, value);
        draw_facts(number);
        if (!its_bound.empty()) {
            flow.item(number.checked->error == 0 ? palette.faint_text : palette.text, its_bound);
            draw_facts(number);
        }
    } else {
        for (const InspectedNumber& number : row.numbers) {
            flow.item(palette.text, written(number, form) + (&number == &row.numbers.back() ? "" : ","));
            draw_facts(number);
        }
    }
    ImGui::PopFont();
    if (!row.note.empty()) flow.words(row.numbers.empty() ? palette.text : palette.faint_text, row.note);
    ImGui::EndGroup();
    if (row.with_bar && row.numbers.front().checked)
        draw_error_bar(frame, *row.numbers.front().checked, ImGui::GetContentRegionAvail().x);
}

void draw_cell(const Frame& frame, const InspectorRow* row, bool different) {
    if (!row) {
        ImGui::TextDisabled("–");
        return;
    }
    draw_value(frame, *row, different);
}

/// Draws by how much the second pixel's numbers are greater, in the column of its own that there is, or below.
void draw_differences(const Frame& frame, const std::string& text, bool below) {
    if (!below) ImGui::TableNextColumn();
    if (text.empty()) return;
    draw_wrapped(frame.palette.faint_text, (below ? "◆ − ● = " : "") + text);
}

/// Labels take as much width as they need, but less than half.
float label_width(std::span<const Pair<InspectorRow>> rows) {
    float width = 0;
    for (const auto& [first, second] : rows)
        width = std::max(width, ImGui::CalcTextSize((first ? first : second)->label.c_str()).x);
    return std::min(width, ImGui::GetContentRegionAvail().x * .4f);
}

}  // namespace

void draw_mark(const Palette& palette, story::Mark mark) {
    ImGui::PushStyleColor(ImGuiCol_Text, color_of(palette, mark));
    const std::string_view its_sign = sign(mark);
    ImGui::TextUnformatted(its_sign.data(), its_sign.data() + its_sign.size());
    ImGui::PopStyleColor();
    ImGui::SameLine(0, ImGui::GetFontSize() * .3f);
}

void draw_swatch(const Palette& palette, Rgb color) {
    const float side = ImGui::GetFontSize();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::Dummy({side, side});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({low.x, low.y + side * .08f}, {low.x + side * .92f, low.y + side}, to_color(color));
    list.AddRect({low.x, low.y + side * .08f}, {low.x + side * .92f, low.y + side}, palette.line);
    ImGui::SameLine(0, side * .3f);
}

namespace {

/// Which column is which pixel's.
void draw_headings(const Frame& frame) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    for (const auto& [title, color] :
         {std::pair("●", frame.palette.accent), {"◆", frame.palette.second}, {"◆ − ●", frame.palette.faint_text}}) {
        ImGui::TableNextColumn();
        draw_wrapped(color, title);
    }
}

}  // namespace

bool one_below_the_other() { return ImGui::GetContentRegionAvail().x < 30 * ImGui::GetFontSize(); }

void draw_rows(const Frame& frame, std::span<const Pair<InspectorRow>> rows, bool comparing) {
    if (rows.empty()) return;
    const bool below = comparing && one_below_the_other();
    const float labels = label_width(rows);
    constexpr ImGuiTableFlags flags = ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_NoSavedSettings |
                                      ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_PadOuterX;
    if (!ImGui::BeginTable("rows", below ? 1 : comparing ? 4 : 2, flags)) return;
    if (!below) ImGui::TableSetupColumn("label", ImGuiTableColumnFlags_WidthFixed, labels);
    ImGui::TableSetupColumn("first", ImGuiTableColumnFlags_WidthStretch);
    if (comparing && !below) {
        ImGui::TableSetupColumn("second", ImGuiTableColumnFlags_WidthStretch);
        ImGui::TableSetupColumn("◆ − ●", ImGuiTableColumnFlags_WidthStretch, .7f);
        draw_headings(frame);
    }
    for (const auto& [first, second] : rows) {
        const std::string& label = (first ? first : second)->label;
        const bool different = comparing && !(first && second && same(*first, *second));
        ImGui::PushID(label.c_str());
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        draw_wrapped(color_of(frame.palette, label), label);
        if (!below) {
            ImGui::TableNextColumn();
            draw_cell(frame, first, false);
            if (comparing) {
                ImGui::TableNextColumn();
                draw_cell(frame, second, different);
            }
        } else {
            for (const auto& [row, color] : {std::pair(first, frame.palette.accent), {second, frame.palette.second}}) {
                if (row == second && !different) break;
                ImGui::PushStyleColor(ImGuiCol_Text, color);
                ImGui::TextUnformatted(row == first ? "●" : "◆");
                ImGui::PopStyleColor();
                ImGui::SameLine(0, ImGui::GetFontSize() * .3f);
                draw_cell(frame, row, different && row == second);
            }
        }
        if (different && first && second) draw_differences(frame, differences(*first, *second), below);
        ImGui::PopID();
    }
    ImGui::EndTable();
}

}  // namespace glassbox
