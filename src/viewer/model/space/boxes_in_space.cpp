#include "viewer/model/space/boxes_in_space.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "engine/box_ray.hpp"
#include "engine/kernels.hpp"
#include "render/search/build_engine.hpp"
#include "render/search/fast_search.hpp"

namespace glassbox {

namespace {

using engine::Child;
using engine::Node;

/// Calls `use(code, box, level)` for each child of each node down to `last`, and for the root.
template <class Use>
void for_each_box(const engine::Engine& engine, int last, const Use& use) {
    const engine::Hierarchy& hierarchy = engine.hierarchy();
    if (hierarchy.nodes.empty()) return;
    use(std::uint32_t{0}, engine.around(), 0);
    std::vector<std::pair<std::uint32_t, int>> waiting{{0, 0}};  // nodes, and their levels
    while (!waiting.empty()) {
        const auto [number, level] = waiting.back();
        waiting.pop_back();
        if (level == last) continue;
        const Node& node = hierarchy.nodes[number];
        for (int i = 0; i < engine::fan_out; ++i) {
            const std::uint32_t code = node.child[i];
            if (code == Child::nothing) continue;
            engine::Box box;
            for (int k = 0; k < 3; ++k) {
                box.lo[k] = node.side[engine::Node::lo][k][i];
                box.hi[k] = node.side[engine::Node::hi][k][i];
            }
            use(code, box, level + 1);
            if (!Child::is_leaf(code)) waiting.emplace_back(code, level + 1);
        }
    }
}

/// A probe that records which boxes a search looks into: those that the ray meets, all of them or up to its first hit.
struct OpenedBoxes {
    static constexpr bool only_verdicts = true, hears_boxes = true;

    std::vector<std::uint32_t> codes;

    template <class What, class... Values>
    void operator()(What, const Values&...) {}
    void operator()(told::BoxOpened, std::uint32_t code) { codes.push_back(code); }
};
struct BoxesToFirstHit : OpenedBoxes {
    static constexpr bool only_nearest = true;
};

std::vector<std::uint32_t> sorted(std::vector<std::uint32_t> codes) {
    std::sort(codes.begin(), codes.end());
    return codes;
}

bool holds(const std::vector<std::uint32_t>& codes, std::uint32_t code) {
    return std::binary_search(codes.begin(), codes.end(), code);
}

/// Whether a ray meets the box around all surfaces, by the test that a traversal applies to a node's children: it
/// starts with the root's children and need not test the root's own box.
bool meets_all(const engine::Engine& engine, const engine::BoxRay& ray) {
    engine::Hierarchy above;  // one node, whose only child is that box
    Node& node = above.nodes.emplace_back();
    constexpr engine::Box empty;
    for (int i = 0; i < engine::fan_out; ++i) {
        const engine::Box& box = i == 0 ? engine.around() : empty;
        for (int k = 0; k < 3; ++k) {
            node.side[engine::Node::lo][k][i] = box.lo[k];
            node.side[engine::Node::hi][k][i] = box.hi[k];
        }
        node.child[i] = i == 0 ? Child::leaf : Child::nothing;
    }
    bool met = false;
    engine::traverse(above, ray, engine::Box::inf, [&](std::uint32_t, float t_max) {
        met = true;
        return t_max;
    });
    return met;
}

/// Rounding is monotonic: what lies in a box, and is a double itself, still lies in it afterwards.
Vec3<double> in_world(const engine::Engine& engine, const float (&corner)[3]) {
    return 1 / engine.scale() * (engine.middle() + Vec3<double>{corner[0], corner[1], corner[2]});
}

Passage passage(const RayInBoxes* ray, std::uint32_t code) {
    if (!ray) return Passage::missed;
    if (holds(ray->opened, code)) return Passage::opened;
    return holds(ray->met, code) ? Passage::met : Passage::missed;
}

const char* plural(std::size_t count, const char* one, const char* many) { return count == 1 ? one : many; }

std::string words_of_met(const BoxesOnLevel& shown) {
    if (shown.met == 0) return "the pinned ray meets none";
    return fmt::format("the pinned ray meets {}", shown.met);
}

std::string words_of_opened(const BoxesOnLevel& shown) {
    if (shown.opened > shown.met) return "but it is opened, untested: the boxes in it are tested at once";
    if (shown.met == 0) return {};
    if (shown.opened < shown.met)
        return fmt::format("{} opened; the {} behind its first hit", shown.opened,
                           shown.met - shown.opened == 1 ? "other begins" : "others begin");
    return shown.met == 1 ? "and it is opened" : "all of them opened";
}

BoxesInWords in_words(const BoxLevels& levels, const BoxesOnLevel& shown, const RayInBoxes* ray, bool engine_draws) {
    BoxesInWords words;
    words.boxes = fmt::format("{} {}", shown.all, plural(shown.all, "box", "boxes"));
    if (shown.drawn.size() < shown.all) words.boxes += fmt::format(", {} of them drawn", shown.drawn.size());
    if (!ray) {
        words.whole = "Pin a pixel: which boxes does its ray meet?";
    } else if (!ray->walks) {
        words.whole = "The pinned ray's numbers are not fit for boxes: it is tested against all surfaces.";
    } else {
        words.met = words_of_met(shown);
        words.opened = words_of_opened(shown);
        words.whole = fmt::format("On all levels {} of {} boxes opened, {} of {} surfaces tested.", ray->opened.size(),
                                  levels.boxes, ray->tested, levels.engine->size());
    }
    const std::size_t loose = levels.engine->loose().size();
    if (loose > 0)
        words.whole += fmt::format(" {} {} too large for a box, and always tested.", loose,
                                   plural(loose, "surface is", "surfaces are"));
    if (const std::size_t copies = levels.engine->copies().size(); copies > 0)
        words.whole += fmt::format(" {} {} the same as another one, and never seen.", copies,
                                   plural(copies, "surface is", "surfaces are"));
    if (!engine_draws)
        words.whole += " This picture is drawn without boxes: its scalar or rule has only the plain loop.";
    return words;
}

BoxesInWords words_of_none(const BoxLevels& levels) {
    const std::size_t loose = levels.engine->loose().size();
    BoxesInWords words;
    words.boxes = loose == 0   ? "no boxes: there are no surfaces"
                  : loose == 1 ? "no boxes: the one surface is too large for one, and always tested"
                               : "no boxes: all surfaces are too large for one, and always tested";
    return words;
}

}  // namespace

BoxLevels box_levels(std::shared_ptr<const engine::Engine> engine) {
    BoxLevels result;
    std::vector<std::size_t> ended;  // leaves, by level
    for_each_box(*engine, engine::most_levels, [&](std::uint32_t code, const engine::Box&, int level) {
        const auto at = static_cast<std::size_t>(level);
        if (result.on_level.size() <= at) {
            result.on_level.resize(at + 1);
            ended.resize(at + 1);
        }
        ++result.on_level[at];
        ++result.boxes;
        if (Child::is_leaf(code)) ++ended[at];
    });
    std::size_t sooner = 0;
    for (std::size_t k = 0; k < ended.size(); ++k) {
        result.on_level[k] += sooner;
        sooner += ended[k];
    }
    result.engine = std::move(engine);
    return result;
}

RayInBoxes ray_in_boxes(const std::shared_ptr<const engine::Engine>& engine, const Ray<double>& ray) {
    RayInBoxes result;
    const std::optional<engine::BoxRay> boxes = is_valid(ray) ? engine::box_ray(ray, *engine) : std::nullopt;
    result.walks = boxes.has_value();
    if (!result.walks) return result;
    const FastSearch search(engine, {}, {});
    OpenedBoxes all;
    search.trace_proven(ray, all);
    if (!meets_all(*engine, *boxes)) std::erase(all.codes, 0u);
    BoxesToFirstHit first;
    if (const std::optional<ProvenHit> hit = search.trace_proven(ray, first)) result.surface = hit->surface;
    result.met = sorted(std::move(all.codes));
    result.opened = sorted(std::move(first.codes));
    result.tested = engine->loose().size();
    for (const std::uint32_t code : result.opened) {
        if (!Child::is_leaf(code)) continue;
        const engine::Hierarchy& hierarchy = engine->hierarchy();
        const auto& leaves = Child::is_of_spheres(code) ? hierarchy.sphere_leaves : hierarchy.triangle_leaves;
        result.tested += leaves[Child::index(code)].count;
    }
    return result;
}

BoxesOnLevel boxes_on_level(const BoxLevels& levels, int level, const RayInBoxes* ray, std::size_t most) {
    BoxesOnLevel result;
    result.level = level;
    if (levels.on_level.empty()) return result;
    result.all = levels.on_level[static_cast<std::size_t>(level)];
    const std::size_t step = (result.all - 1) / std::max<std::size_t>(most, 1) + 1;
    std::size_t count = 0;
    for_each_box(*levels.engine, level, [&](std::uint32_t code, const engine::Box& box, int its_level) {
        if (its_level < level && !Child::is_leaf(code)) return;
        const Passage how = passage(ray, code);
        result.met += ray && holds(ray->met, code);
        result.opened += how == Passage::opened;
        if (count++ % step != 0 && how == Passage::missed) return;
        result.drawn.push_back(
            {in_world(*levels.engine, box.lo), in_world(*levels.engine, box.hi), code, how, its_level < level});
    });
    return result;
}

std::pair<Vec3<double>, Vec3<double>> edge(const BoxInSpace& box, int n) {
    // A corner is three bits, one per axis, which say which end it is at. An edge's two corners differ in one bit.
    const int axis = n / 4, one = n & 1, other = n >> 1 & 1;
    const int from = one << (axis + 1) % 3 | other << (axis + 2) % 3;
    const auto corner = [&](int bits) {
        return Vec3<double>{bits & 1 ? box.greatest.x : box.least.x, bits & 2 ? box.greatest.y : box.least.y,
                            bits & 4 ? box.greatest.z : box.least.z};
    };
    return {corner(from), corner(from | 1 << axis)};
}

void Boxes::update(const ViewerState& state, const Results& results) {
    const bool engine_draws = engine_can(state.setup.now().options);
    const std::optional<int> level = shown_level(state, results);
    const auto levels = state.box_level ? results.boxes : nullptr;
    const bool other_ray = levels_ != levels || pinned_ != results.story;
    if (!other_ray && level_ == level && engine_draws_ == engine_draws) return;
    levels_ = levels;
    pinned_ = results.story;
    level_ = level;
    engine_draws_ = engine_draws;
    if (other_ray) ray_.reset();
    shown_.reset();
    words_ = {};
    if (!levels_) return;
    if (!level_) {
        words_ = words_of_none(*levels_);
        return;
    }
    if (pinned_ && !ray_) ray_ = ray_in_boxes(levels_->engine, pinned_->ray);
    const RayInBoxes* const ray = ray_ ? &*ray_ : nullptr;
    shown_ = boxes_on_level(*levels_, *level_, ray);
    words_ = in_words(*levels_, *shown_, ray, engine_draws_);
}

std::optional<int> shown_level(const ViewerState& state, const Results& results) {
    if (!state.box_level || !results.boxes || results.boxes->deepest() < 0) return {};
    return std::min(*state.box_level, results.boxes->deepest());
}

void go_deeper(ViewerState& state, const Results& results) {
    state.space_shown = true;
    if (!state.box_level) {
        state.box_level = 0;
        return;
    }
    const int now = shown_level(state, results).value_or(*state.box_level);
    const bool known = results.boxes && results.boxes->deepest() >= 0;
    state.box_level = std::min(now + 1, known ? results.boxes->deepest() : engine::most_levels);
}

void go_back(ViewerState& state, const Results& results) {
    if (!state.box_level) return;
    const int now = shown_level(state, results).value_or(*state.box_level);
    if (now == 0) state.box_level.reset();
    else state.box_level = now - 1;
}

}  // namespace glassbox
