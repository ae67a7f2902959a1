#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <ray.hpp>

#include "engine/engine.hpp"
#include "viewer/model/state/state.hpp"
#include "viewer/model/work/results.hpp"

namespace glassbox {

// The engine's hierarchy of boxes, level by level: what there is, what the pinned pixel's ray does in it, and which
// boxes are drawn.

/// A hierarchy, its boxes counted. On level 0 there is one, around all surfaces; on level k are those k steps below it,
/// and the leaves that were reached sooner: together they hold every surface, on each level.
struct BoxLevels {
    std::shared_ptr<const engine::Engine> engine;
    std::vector<std::size_t> on_level;  ///< how many; empty where there are no surfaces
    std::size_t boxes = 0;              ///< in all: nodes and leaves

    int deepest() const { return static_cast<int>(on_level.size()) - 1; }
};
BoxLevels box_levels(std::shared_ptr<const engine::Engine> engine);

/// What a ray does in a hierarchy: heard from the search itself. Boxes are codes of engine::Child, sorted; 0 is the
/// root's.
struct RayInBoxes {
    bool walks = false;                  ///< otherwise its numbers are not fit for boxes, and it is tested against all
    std::vector<std::uint32_t> met;      ///< boxes that it meets, as far as it goes
    std::vector<std::uint32_t> opened;   ///< those that the search looks into: the root, and of the others that are met
                                         ///< none that begins behind the first hit
    std::size_t tested = 0;              ///< surfaces in the opened leaves, and those that are in no box
    std::optional<std::size_t> surface;  ///< that it meets first
};
RayInBoxes ray_in_boxes(const std::shared_ptr<const engine::Engine>& engine, const Ray<double>& ray);

/// What the pinned ray has to do with a box.
enum class Passage { missed, met, opened };

/// A box in the world's coordinates.
struct BoxInSpace {
    Vec3<double> least, greatest;
    std::uint32_t code = 0;  ///< of engine::Child
    Passage passage = Passage::missed;
    bool ended = false;  ///< a leaf that was reached sooner: it stays on all levels below
};

/// The boxes of a level that are drawn, and how many there are.
struct BoxesOnLevel {
    int level = 0;
    std::vector<BoxInSpace> drawn;
    std::size_t all = 0, met = 0, opened = 0;
};

/// All boxes of a level, 0 ≤ level ≤ deepest; of more than `most` an even sample, and all that the ray meets. `ray` may
/// be null.
BoxesOnLevel boxes_on_level(const BoxLevels& levels, int level, const RayInBoxes* ray, std::size_t most = 1000);

/// One of a box's twelve edges, 0 ≤ n < 12: four along each axis.
std::pair<Vec3<double>, Vec3<double>> edge(const BoxInSpace& box, int n);

/// What is said of them, for each way of drawing them, and of all levels; empty where there is nothing to say.
struct BoxesInWords {
    std::string boxes, met, opened, whole;
};

/// Keeps what is drawn between frames, for as long as it holds.
class Boxes {
public:
    void update(const ViewerState& state, const Results& results);

    /// Null if none are shown, or not yet.
    const BoxesOnLevel* shown() const { return shown_ ? &*shown_ : nullptr; }
    const BoxesInWords& words() const { return words_; }

private:
    std::shared_ptr<const BoxLevels> levels_;
    std::shared_ptr<const Story> pinned_;
    std::optional<int> level_;
    bool engine_draws_ = true;
    std::optional<RayInBoxes> ray_;
    std::optional<BoxesOnLevel> shown_;
    BoxesInWords words_;
};

/// The level that is drawn: the one that was chosen, or the deepest if there are fewer. None while boxes are off, or
/// where there are none.
std::optional<int> shown_level(const ViewerState& state, const Results& results);

/// A level deeper, if there is one; level 0 if none was shown.
void go_deeper(ViewerState& state, const Results& results);

/// A level back; from level 0 none is shown.
void go_back(ViewerState& state, const Results& results);

}  // namespace glassbox
