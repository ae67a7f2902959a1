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

// The engine's hierarchy of boxes, level by level: which boxes there are, what the pinned pixel's ray does in them, and
// which boxes are drawn.

/// A hierarchy and the number of its boxes. Level 0 has one box, around all surfaces; level k has the boxes k steps
/// below it and the leaves reached sooner, so that each level holds every surface.
struct BoxLevels {
    std::shared_ptr<const engine::Engine> engine;
    std::vector<std::size_t> on_level;  ///< how many; empty where there are no surfaces
    std::size_t boxes = 0;              ///< in all: nodes and leaves

    int deepest() const { return static_cast<int>(on_level.size()) - 1; }
};
BoxLevels box_levels(std::shared_ptr<const engine::Engine> engine);

/// What a ray does in a hierarchy, as the search itself reports it. Boxes are codes of engine::Child, sorted; 0 is the
/// root's.
struct RayInBoxes {
    bool walks = false;                  ///< otherwise its numbers do not suit boxes: it is tested against all
    std::vector<std::uint32_t> met;      ///< boxes that it meets, as far as it goes
    std::vector<std::uint32_t> opened;   ///< those that the search looks into: the root, and of the others that are met
                                         ///< none that begins behind the first hit
    std::size_t tested = 0;              ///< surfaces in the opened leaves, and those that are in no box
    std::optional<std::size_t> surface;  ///< that it meets first
};
RayInBoxes ray_in_boxes(const std::shared_ptr<const engine::Engine>& engine, const Ray<double>& ray);

/// How the pinned ray passes a box.
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

/// Returns all boxes of a level, 0 ≤ level ≤ deepest; of more than `most` an even sample, and all that the ray meets.
/// `ray` may be null.
BoxesOnLevel boxes_on_level(const BoxLevels& levels, int level, const RayInBoxes* ray, std::size_t most = 1000);

/// Returns one of a box's twelve edges, 0 ≤ n < 12: four along each axis.
std::pair<Vec3<double>, Vec3<double>> edge(const BoxInSpace& box, int n);

/// What is said of the boxes, for each way of drawing them, and of all levels; empty where there is nothing to say.
struct BoxesInWords {
    std::string boxes, met, opened, whole;
};

/// Keeps what is drawn between frames, as long as it is valid.
class Boxes {
public:
    void update(const ViewerState& state, const Results& results);

    /// Null if none are shown, or none yet.
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

/// Returns the level that is drawn: the chosen one, or the deepest if there are fewer. None while boxes are off, or if
/// there are none.
std::optional<int> shown_level(const ViewerState& state, const Results& results);

/// Goes a level deeper, if there is one; to level 0 if none was shown.
void go_deeper(ViewerState& state, const Results& results);

/// Goes a level back; from level 0 to none.
void go_back(ViewerState& state, const Results& results);

}  // namespace glassbox
