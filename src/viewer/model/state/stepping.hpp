#pragma once
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "explain/nudge.hpp"

namespace glassbox {

/// What stands below a step's numbers: its source, what that says of the formula, the list of the worst losses, or the
/// inputs to be nudged.
enum class StepsPane { source, formula, losses, nudge };

/// How a reader goes through the steps of a story, besides where they are. Places are events of its timeline.
struct Stepping {
    std::shared_ptr<const Story> of;  ///< the story that all but the pane belongs to
    StepsPane pane = StepsPane::source;
    std::optional<std::size_t> fed;  ///< only what feeds this one's number is shown; none: all is
    std::vector<std::size_t> back,
        forth;                            ///< where the reader has jumped from, and returned from; the last one is next
    std::size_t level = 0;                ///< the line of the call stack that is looked at, from the outermost
    std::optional<std::size_t> level_at;  ///< for which event that was chosen; of others it is the innermost, or where
                                          ///< a program ended early its own
    std::vector<Nudge> nudges;            ///< in the order in which they were made
    int nudge_by = 1;                     ///< how far the next one goes
    std::size_t nudged_row = 0;           ///< in Story::surfaces: whose test is nudged
    std::shared_ptr<const Nudged> nudged;  ///< what becomes of it; null: not tested yet
};

}  // namespace glassbox
