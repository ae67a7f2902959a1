#include "viewer/ui/picture/picture_legend.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "output/legend_bar.hpp"
#include "output/legend_number.hpp"
#include "viewer/model/overlay/laid_over.hpp"
#include "viewer/model/overlay/subtracted.hpp"

namespace glassbox {

namespace {

ImU32 opaque(Rgb c) { return IM_COL32(c.red, c.green, c.blue, 255); }

/// Text and colours one below the other; measured first, then drawn.
class Card {
public:
    Card(const Frame& frame, ImVec2 at, float width, float font, bool draws)
        : frame_(frame), at_(at), width_(width), font_(font), draws_(draws) {}

    float height() const { return y_; }
    float widest() const { return widest_; }

    void text(const std::string& words, ImU32 color, float indent = 0) {
        const float room = width_ - indent;
        const ImVec2 extent = ImGui::GetFont()->CalcTextSizeA(font_, 1e9f, room, words.c_str());
        if (draws_)
            list().AddText(ImGui::GetFont(), font_, {at_.x + indent, at_.y + y_}, color, words.c_str(), nullptr, room);
        y_ += extent.y;
        widest_ = std::max(widest_, indent + extent.x);
    }

    void swatch(const ColorWord& word) {
        const ImVec2 from{at_.x, at_.y + y_ + font_ * .1f}, to{from.x + font_ * .8f, from.y + font_ * .8f};
        if (draws_) {
            list().AddRectFilled(from, to, opaque(word.color));
            list().AddRect(from, to, frame_.palette.faint_text);
        }
        text(fmt::format("{}: {}", word.text, word.pixels), frame_.palette.text, font_ * 1.2f);
    }

    void bar(const Coloring& coloring) {
        widest_ = std::max(widest_, std::min(width_, 14 * font_));
        const int columns = static_cast<int>(width_);
        const float top = at_.y + y_, thick = font_ * .7f;
        const auto measure = [&](const std::string& label) {
            return static_cast<int>(std::ceil(ImGui::GetFont()->CalcTextSizeA(font_, 1e9f, 0, label.c_str()).x));
        };
        const std::vector<PlacedTick> labels = placed_ticks(coloring, columns, static_cast<int>(font_), measure);
        if (draws_) {
            for (int x = 0, from = 0; x <= columns; ++x) {
                if (x < columns && color_on_bar(coloring, x, columns) == color_on_bar(coloring, from, columns))
                    continue;
                list().AddRectFilled({at_.x + static_cast<float>(from), top},
                                     {at_.x + static_cast<float>(x), top + thick},
                                     opaque(color_on_bar(coloring, from, columns)));
                from = x;
            }
            list().AddRect({at_.x, top}, {at_.x + width_, top + thick}, frame_.palette.faint_text);
            for (const PlacedTick& label : labels) {
                const float mark = at_.x + static_cast<float>(label.mark);
                list().AddLine({mark, top + thick}, {mark, top + thick + font_ * .2f}, frame_.palette.text);
                list().AddText(ImGui::GetFont(), font_,
                               {at_.x + static_cast<float>(label.left), top + thick + font_ * .2f}, frame_.palette.text,
                               label.label.c_str());
            }
        }
        y_ += thick + font_ * (labels.empty() ? .2f : 1.25f);
    }

private:
    static ImDrawList& list() { return *ImGui::GetWindowDrawList(); }

    const Frame& frame_;
    ImVec2 at_;
    float width_, font_, y_ = 0, widest_ = 0;
    bool draws_;
};

/// "margin in digits", "coarse: 1/8 of the pixels a side so far".
void fill(Card& card, const Frame& frame, float close_button, float least_room) {
    const ViewerState& state = frame.state;
    const MeasuredChannels* const overlay = last_laid_over(state, frame.results);
    const Measurement& what = *find_measurement(state.overlay.measurement);
    const std::string unit = what.unit.empty() ? "" : fmt::format(" in {}", what.unit);
    const bool is_old = overlay && !laid_over(state, frame.results);
    card.text(name_of(state.overlay) + unit + (is_old ? " …" : ""), frame.palette.accent, close_button);
    if (!overlay || frame.pictures.distributions().empty()) return card.text("… being measured", frame.palette.warning);
    if (overlay->factor > 1) card.text(fmt::format("… coarse: 1/{}", overlay->factor), frame.palette.warning);
    if (const std::string& why = overlay->channels.front().why_no_value; !why.empty())
        return card.text(fmt::format("no pixel has a value ({})", why), frame.palette.warning);
    const Distribution& of = frame.pictures.distributions().front();
    if (what.scale == Scale::direction) {
        card.text("x red, y green, z blue, from −1, dark, to 1", frame.palette.text);
    } else {
        if (overlay->what->words.empty() && of.summary.any_finite()) card.bar(of.coloring);
        if (of.coloring.spacing != Spacing::linear)
            card.text(spacing_in_words(of.coloring.spacing), frame.palette.faint_text);
    }
    for (const ColorWord& word : of.words) {
        if (word.pixels == 0) continue;
        if (card.height() > least_room) return card.text("…", frame.palette.text);
        card.swatch(word);
    }
}

}  // namespace

void draw_picture_legend(const Frame& frame, ImVec2 corner, ImVec2 size) {
    ViewerState& state = frame.state;
    const bool on_picture = state.beside == Beside::nothing || state.beside == Beside::overlay;
    if (!on_picture || !state.overlay.legend_shown || !find_measurement(state.overlay.measurement)) return;
    // Where large text leaves no room, it is a little smaller here; where there is none at all, the page has it.
    const float font = std::min(ImGui::GetFontSize(), std::max(12.f, size.y / 14)), pad = std::floor(font / 3);
    float width = std::floor(std::min(17 * font, size.x * .6f));
    const float most = size.y * .5f;
    if (width < 6 * font || most < 3 * font) return;
    const float button = std::floor(font * 1.2f);
    Card measured(frame, {}, width, font, false);
    fill(measured, frame, button, most);
    width = std::ceil(measured.widest());
    const ImVec2 extent{width + 2 * pad, measured.height() + 2 * pad};

    // On the left, or on the right where it would cover the pinned pixel.
    ImVec2 from{corner.x + pad, corner.y + size.y - pad - extent.y};
    if (state.pinned) {
        const Point pin = state.view.on_screen({state.pinned->x + .5, state.pinned->y + .5});
        const bool covered = corner.x + pin.x < from.x + extent.x + font && corner.y + pin.y > from.y - font;
        if (covered) from.x = corner.x + size.x - pad - extent.x;
    }
    const ImVec2 to{from.x + extent.x, from.y + extent.y};
    // Clicks on it do not reach the picture.
    ImGui::SetCursorScreenPos(from);
    ImGui::InvisibleButton("legend", extent);
    ImGui::SetItemAllowOverlap();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(from, to, (frame.palette.canvas & ~IM_COL32_A_MASK) | IM_COL32(0, 0, 0, 235), pad);
    list.AddRect(from, to, frame.palette.line, pad);
    Card card(frame, {from.x + pad, from.y + pad}, width, font, true);
    fill(card, frame, button, most);
    ImGui::SetCursorScreenPos({from.x + pad / 2, from.y + pad});
    if (ImGui::InvisibleButton("hide", {button, button})) state.overlay.legend_shown = false;
    const ImU32 color = ImGui::IsItemHovered() ? frame.palette.accent : frame.palette.text;
    list.AddText(ImGui::GetFont(), font, {from.x + pad, from.y + pad}, color, "×");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Hide the legend; the page Overlay brings it back");
}

}  // namespace glassbox
