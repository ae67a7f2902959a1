#include <algorithm>
#include <array>
#include <cmath>
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

/// Tiles side by side, each with its words wrapped.
struct TileRows {
    struct Words {
        ImU32 color;
        std::string text;  ///< with its line breaks
        float height;
    };
    int in_a_row = 3;
    float width = 0;  ///< of a tile
    std::array<std::vector<Words>, 3> words;
    std::array<float, 3> heights{};  ///< of each tile's row

    float height() const {
        float all = 0;
        for (int i = 0; i < 3; i += in_a_row) all += heights[static_cast<std::size_t>(i)] + gap();
        return all - gap();
    }
    static float gap() { return std::floor(ImGui::GetFontSize() * .3f); }
    static float pad() { return std::floor(ImGui::GetFontSize() * .3f); }
};

TileRows rows_of(const Frame& frame, const std::array<Tile, 3>& tiles, float room, int in_a_row, bool brief) {
    TileRows rows;
    rows.in_a_row = in_a_row;
    const float gaps = TileRows::gap() * static_cast<float>(in_a_row - 1);
    rows.width = std::floor((room - gaps) / static_cast<float>(in_a_row));
    for (std::size_t i = 0; i < 3; ++i) {
        const auto add = [&](ImU32 color, std::string_view text) {
            std::string lines = wrapped(text, rows.width - 2 * TileRows::pad());
            const float height = ImGui::CalcTextSize(lines.c_str()).y;
            rows.words[i].push_back({color, std::move(lines), height});
            rows.heights[i] += height;
        };
        rows.heights[i] = 2 * TileRows::pad();
        add(frame.palette.accent, tiles[i].title);
        for (const TileLine& line : brief ? tiles[i].brief : tiles[i].lines)
            add(color_of(frame.palette, line.about), line.text);
    }
    for (std::size_t first = 0; first < 3; first += static_cast<std::size_t>(in_a_row)) {
        const std::size_t end = std::min<std::size_t>(3, first + static_cast<std::size_t>(in_a_row));
        const float highest = *std::max_element(rows.heights.begin() + first, rows.heights.begin() + end);
        std::fill(rows.heights.begin() + first, rows.heights.begin() + end, highest);
    }
    return rows;
}

/// Whether no word is wider than its tile.
bool fits(const TileRows& rows) {
    for (const auto& tile : rows.words)
        for (const TileRows::Words& words : tile)
            if (ImGui::CalcTextSize(words.text.c_str()).x > rows.width - 2 * TileRows::pad()) return false;
    return true;
}

/// With all words if they take little height, side by side if they are not too wide for that.
TileRows laid_out(const Frame& frame, const std::array<Tile, 3>& tiles, float room, float most_height) {
    const std::array<TileRows, 4> ways{rows_of(frame, tiles, room, 3, false), rows_of(frame, tiles, room, 3, true),
                                       rows_of(frame, tiles, room, 2, true), rows_of(frame, tiles, room, 1, true)};
    for (const TileRows& way : ways)
        if (fits(way) && way.height() <= most_height) return way;
    for (const TileRows& way : std::span(ways).subspan(1))
        if (fits(way)) return way;
    return ways.back();
}

void draw_tile(const Frame& frame, const TileRows& rows, const Tile& tile, std::size_t number) {
    const float pad = TileRows::pad(), height = rows.heights[number];
    const ImVec2 low = ImGui::GetCursorScreenPos(), high{low.x + rows.width, low.y + height};
    ImGui::PushID(static_cast<int>(number));
    if (ImGui::InvisibleButton("tile", {rows.width, height}))
        open_tile(frame.state, frame.results, static_cast<TileKind>(number));
    ImGui::PopID();
    const bool hovered = ImGui::IsItemHovered();
    if (hovered) ImGui::SetTooltip("%s", wrapped(tile.tip, 24 * ImGui::GetFontSize()).c_str());
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool laid = frame.state.overlay.measurement == tile.overlay;
    list.AddRectFilled(low, high, ImGui::GetColorU32(hovered ? ImGuiCol_FrameBgHovered : ImGuiCol_FrameBg), pad);
    list.AddRect(low, high, laid || hovered ? frame.palette.accent : frame.palette.line, pad);
    float y = low.y + pad;
    for (const TileRows::Words& words : rows.words[number]) {
        list.AddText({low.x + pad, y}, words.color, words.text.c_str());
        y += words.height;
    }
}

void draw_line(const Frame& frame, const TruthInSight& seen) {
    if (!seen.mark) return draw_wrapped(frame.palette.text, seen.line);
    const std::string line = std::string(sign(*seen.mark)) + ' ' + seen.line;
    draw_wrapped(color_of(frame.palette, *seen.mark), line);
}

}  // namespace

void draw_truth(const Frame& frame) {
    const TruthInSight seen = truth_in_sight(frame.state, frame.results);
    const float top = ImGui::GetCursorPosY(), all = ImGui::GetContentRegionAvail().y;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(TileRows::gap(), TileRows::gap()));
    draw_line(frame, seen);
    constexpr float most = .4f;  // the pages keep the rest
    const float room = ImGui::GetContentRegionAvail().x, left = most * all - (ImGui::GetCursorPosY() - top);
    const TileRows rows = laid_out(frame, seen.tiles, room, left);
    for (std::size_t i = 0; i < 3; ++i) {
        if (i % static_cast<std::size_t>(rows.in_a_row) != 0) ImGui::SameLine(0, TileRows::gap());
        draw_tile(frame, rows, seen.tiles[i], i);
    }
    ImGui::PopStyleVar();
}

}  // namespace glassbox
