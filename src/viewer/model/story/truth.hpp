#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "explain/story.hpp"
#include "explain/timeline.hpp"
#include "viewer/model/state/state.hpp"
#include "viewer/model/work/results.hpp"

namespace glassbox {

/// The three numbers of a pixel that are always in sight.
enum class TileKind { search, cosines, margin };

/// Words of a tile, and what they are about, which has a colour.
struct TileLine {
    enum class About { number, words, n_l, n_r, n_h, danger };
    std::string text;
    About about = About::number;
};

struct Tile {
    std::string_view title;
    std::vector<TileLine> lines, brief;  ///< with all words, and with fewer where there is little room
    std::string_view overlay;            ///< the measurement that shows it at every pixel
    std::optional<std::size_t> step;     ///< on the timeline: where it comes from
    std::string_view key, tip;
};

/// What stands above the pages, whichever is open.
struct TruthInSight {
    std::optional<story::Mark> mark;  ///< none: no pixel is judged
    bool is_sure = true;              ///< what is marked as right is proven
    std::string line, short_line;     ///< with all words, and with fewer
    std::array<Tile, 3> tiles;        ///< by TileKind
};

/// Of the pinned pixel; without one, what to do.
TruthInSight truth_in_sight(const ViewerState& state, const Results& results);

/// Opens the step where a tile's number comes from, and lays its measurement over the picture.
void open_tile(ViewerState& state, const Results& results, TileKind kind);

}  // namespace glassbox
