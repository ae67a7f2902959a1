#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "explain/verdict_phrases.hpp"
#include "viewer/model/story/truth.hpp"
#include "viewer/ui/panels.hpp"
#include "viewer/ui/widgets/wrapped.hpp"

namespace glassbox {

namespace {

ImU32 color_of(const Palette& palette, TileLine::About about) {
    switch (about) {
        case TileLine::About::number:
            return palette.text;
        case TileLine::About::words:
            return palette.faint_text;
        case TileLine::About::n_l:
            return palette.n_l;
        case TileLine::About::n_r:
            return palette.n_r;
        case TileLine::About::n_h:
            return palette.n_h;
        case TileLine::About::danger:
            return palette.failed;
    }
    return palette.text;
}

/// How much the tiles say: all; less, and that one after the other; or of that only the first.
enum class Words { all, brief, first };

/// The tiles, side by side or below each other, each with its words wrapped.
class TileRows {
public:
    TileRows(const Frame& frame, const std::array<Tile, 3>& tiles, float room, std::size_t in_a_row, Words words)
        : in_a_row_(in_a_row), brief_(words != Words::all) {
        const float gaps = gap() * static_cast<float>(in_a_row - 1);
        const float width = std::floor((room - gaps) / static_cast<float>(in_a_row));
        for (std::size_t i = 0; i < 3; ++i) {
            const bool is_alone = i % in_a_row == 0 && i == 2;
            boxes_[i].width = is_alone ? room : width;
            add(boxes_[i], frame.palette.accent, tiles[i].title);
            for (const TileLine& line : brief_ ? tiles[i].brief : tiles[i].lines) {
                add(boxes_[i], color_of(frame.palette, line.about), line.text);
                if (words == Words::first) break;
            }
        }
        for (std::size_t first = 0; first < 3; first += in_a_row) {
            const std::span row = std::span(boxes_).subspan(first, std::min(in_a_row, 3 - first));
            float highest = 0;
            for (const Box& box : row) highest = std::max(highest, box.bottom);
            for (Box& box : row) box.bottom = highest;
        }
    }

    bool begins_row(std::size_t tile) const { return tile % in_a_row_ == 0; }
    float height() const {
        float all = -gap();
        for (std::size_t i = 0; i < 3; i += in_a_row_) all += boxes_[i].bottom + 2 * pad() + gap();
        return all;
    }
    ImVec2 size(std::size_t tile) const { return {boxes_[tile].width, boxes_[tile].bottom + 2 * pad()}; }

    /// Whether no word is wider than its tile.
    bool fits() const {
        for (const Box& box : boxes_)
            for (const Text& words : box.words)
                if (words.at.x + words.width > inner(box)) return false;
        return true;
    }

    void draw(ImDrawList& list, std::size_t tile, ImVec2 corner) const {
        for (const Text& words : boxes_[tile].words)
            list.AddText({corner.x + pad() + words.at.x, corner.y + pad() + words.at.y}, words.color,
                         words.text.c_str());
    }

    static float gap() { return std::floor(ImGui::GetFontSize() * .3f); }
    static float pad() { return std::floor(ImGui::GetFontSize() * .3f); }

private:
    struct Text {
        ImU32 color;
        std::string text;  ///< with its line breaks
        ImVec2 at;
        float width;
    };
    struct Box {
        float width = 0, bottom = 0;
        std::vector<Text> words = {};
    };

    static float inner(const Box& box) { return box.width - 2 * pad(); }

    void add(Box& box, ImU32 color, std::string_view text) const {
        const float space = ImGui::GetFontSize() * .5f;
        const float whole = ImGui::CalcTextSize(text.data(), text.data() + text.size()).x;
        if (brief_ && !box.words.empty()) {
            const Text& last = box.words.back();
            const float after = last.at.x + last.width + space;
            const bool is_one_line = last.text.find('\n') == std::string::npos;
            if (is_one_line && after + whole <= inner(box)) {
                box.words.push_back({color, std::string(text), {after, last.at.y}, whole});
                return;
            }
        }
        std::string lines = wrapped(text, inner(box));
        const ImVec2 size = ImGui::CalcTextSize(lines.c_str());
        box.words.push_back({color, std::move(lines), {0, box.bottom}, size.x});
        box.bottom += size.y;
    }

    std::size_t in_a_row_;
    bool brief_;
    std::array<Box, 3> boxes_;
};

/// With all words if they take little height, side by side if they are not too wide for that; else as low as can be.
TileRows laid_out(const Frame& frame, const std::array<Tile, 3>& tiles, float room, float most_height) {
    const TileRows whole(frame, tiles, room, 3, Words::all);
    if (whole.fits() && whole.height() <= most_height) return whole;
    std::optional<TileRows> lowest;
    for (const Words words : {Words::brief, Words::first}) {
        for (std::size_t in_a_row = 3; in_a_row > 0; --in_a_row) {
            const TileRows rows(frame, tiles, room, in_a_row, words);
            if (in_a_row > 1 && !rows.fits()) continue;
            if (!lowest || rows.height() < lowest->height()) lowest = rows;
        }
        if (lowest->height() <= most_height) break;
    }
    return *lowest;
}

void draw_tile(const Frame& frame, const TileRows& rows, const Tile& tile, std::size_t number) {
    const float round = TileRows::pad();
    const ImVec2 low = ImGui::GetCursorScreenPos(), size = rows.size(number), high{low.x + size.x, low.y + size.y};
    ImGui::PushID(static_cast<int>(number));
    if (ImGui::InvisibleButton("tile", size)) open_tile(frame.state, frame.results, static_cast<TileKind>(number));
    ImGui::PopID();
    const bool hovered = ImGui::IsItemHovered();
    if (hovered) ImGui::SetTooltip("%s", wrapped(tile.tip, 24 * ImGui::GetFontSize()).c_str());
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool laid = frame.state.overlay.measurement == tile.overlay;
    list.AddRectFilled(low, high, ImGui::GetColorU32(hovered ? ImGuiCol_FrameBgHovered : ImGuiCol_FrameBg), round);
    list.AddRect(low, high, laid || hovered ? frame.palette.accent : frame.palette.line, round);
    rows.draw(list, number, low);
}

/// The line as it is written: with its sign.
std::string signed_line(const TruthInSight& seen, bool brief) {
    const std::string& line = brief ? seen.short_line : seen.line;
    return seen.mark ? std::string(sign(*seen.mark)) + ' ' + line : line;
}

ImU32 line_color(const Palette& palette, const TruthInSight& seen) {
    if (!seen.mark) return palette.text;
    return *seen.mark == story::Mark::right && !seen.is_sure ? palette.warning : color_of(palette, *seen.mark);
}

}  // namespace

void draw_truth(const Frame& frame) {
    const TruthInSight seen = truth_in_sight(frame.state, frame.results);
    const ImVec2 all = ImGui::GetContentRegionAvail();
    constexpr float most = .4f;  // the pages keep the rest
    std::string line = wrapped(signed_line(seen, false));
    const float left = most * all.y - ImGui::CalcTextSize(line.c_str()).y - TileRows::gap();
    const TileRows rows = laid_out(frame, seen.tiles, all.x, left);
    if (rows.height() > left) line = wrapped(signed_line(seen, true));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(TileRows::gap(), TileRows::gap()));
    draw_wrapped(line_color(frame.palette, seen), line);
    for (std::size_t i = 0; i < 3; ++i) {
        if (!rows.begins_row(i)) ImGui::SameLine(0, TileRows::gap());
        draw_tile(frame, rows, seen.tiles[i], i);
    }
    ImGui::PopStyleVar();
}

}  // namespace glassbox
