#include "engine/hierarchy.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>
#include <tbb/task_group.h>

#include <atomic>
#include <memory>
#include <span>
#include <tuple>
#include <utility>

#include "engine/with_threads.hpp"

namespace glassbox::engine {

namespace {

constexpr int bins = 16;
constexpr std::size_t worth_a_task = 4096;
/// From this level on parts are halved: there are at most 32 more, and `most_levels` holds.
constexpr int deep = 64;

/// What is known about some surfaces before they are cut in two: the box around them, and the one around their middles
/// (twice those).
struct Extent {
    Box around, middles;

    void add(const Boxed& one) {
        around.add(one.box);
        for (int k = 0; k < 3; ++k) {
            middles.lo[k] = std::min(middles.lo[k], one.box.middle2(k));
            middles.hi[k] = std::max(middles.hi[k], one.box.middle2(k));
        }
    }
    void add(const Extent& other) {
        around.add(other.around);
        middles.add(other.middles);
    }
};

/// Some surfaces, on the way to become a child.
struct Part {
    std::span<Boxed> surfaces;
    Extent extent;
};

/// `of(range)` for the parts of a range, put together by add.
template <class Sum, class Of>
Sum summed(std::span<Boxed> surfaces, const Of& of) {
    const auto add = [&](const tbb::blocked_range<std::size_t>& range, Sum sum) {
        of(surfaces.subspan(range.begin(), range.size()), sum);
        return sum;
    };
    const tbb::blocked_range<std::size_t> all(0, surfaces.size(), 4 * worth_a_task);
    if (surfaces.size() <= 8 * worth_a_task) return add(all, Sum{});
    return tbb::parallel_reduce(all, Sum{}, add, [](Sum a, const Sum& b) {
        a.add(b);
        return a;
    });
}

Extent extent_of(std::span<Boxed> surfaces) {
    return summed<Extent>(surfaces, [](std::span<Boxed> some, Extent& extent) {
        for (const Boxed& one : some) extent.add(one);
    });
}

/// Which bin a surface belongs to, along each axis.
class Binning {
public:
    explicit Binning(const Box& middles) {
        for (int k = 0; k < 3; ++k) {
            const float length = middles.hi[k] - middles.lo[k];
            lo_[k] = middles.lo[k];
            // Just under 16 bins, so that the last middle falls into the last one; 0 where all lie on one point, or so
            // near that a float cannot cut between.
            scale_[k] = length > 0 && std::isfinite(bins / length) ? 0.999f * bins / length : 0;
        }
    }

    bool can_cut(int axis) const { return scale_[axis] > 0; }
    int operator()(const Boxed& one, int axis) const {
        const auto bin = static_cast<int>((one.box.middle2(axis) - lo_[axis]) * scale_[axis]);
        return std::clamp(bin, 0, bins - 1);
    }

private:
    float lo_[3], scale_[3];
};

/// The surfaces in each bin.
struct Bins {
    Box box[3][bins];
    std::uint32_t count[3][bins] = {};

    void add(const Bins& other) {
        for (int k = 0; k < 3; ++k)
            for (int b = 0; b < bins; ++b) {
                box[k][b].add(other.box[k][b]);
                count[k][b] += other.count[k][b];
            }
    }
};

/// Where to cut: surfaces whose bin along the axis is below `bin` go to the left. No axis: there is no good place.
struct Cut {
    int axis = -1, bin = 0;
};

/// How many tests of a whole leaf some surfaces take.
float leaves(std::uint32_t count) { return static_cast<float>((count + fan_out - 1) / fan_out); }

Cut best_cut(const Bins& all, const Binning& binning) {
    Cut best;
    float least = std::numeric_limits<float>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        if (!binning.can_cut(axis)) continue;
        float right_cost[bins] = {};
        Box box;
        std::uint32_t count = 0;
        for (int b = bins - 1; b > 0; --b) {
            box.add(all.box[axis][b]);
            count += all.count[axis][b];
            right_cost[b] = count > 0 ? box.half_area() * leaves(count) : -1;
        }
        box = {};
        count = 0;
        for (int b = 1; b < bins; ++b) {
            box.add(all.box[axis][b - 1]);
            count += all.count[axis][b - 1];
            if (count == 0 || right_cost[b] < 0) continue;
            const float cost = box.half_area() * leaves(count) + right_cost[b];
            if (!(cost < least)) continue;
            least = cost;
            best = {axis, b};
        }
    }
    return best;
}

bool all_of_one_kind(std::span<Boxed> surfaces) {
    return std::all_of(surfaces.begin(), surfaces.end(),
                       [&](const Boxed& one) { return one.is_sphere == surfaces.front().is_sphere; });
}

/// The longest edge of a box.
float length(const Box& box) { return std::max({box.hi[0] - box.lo[0], box.hi[1] - box.lo[1], box.hi[2] - box.lo[2]}); }

/// Whether each is not much smaller than all of them together: the floats of a Block tell little of one that is.
bool fill_their_box(const Part& part) {
    constexpr float most = 256;
    return std::all_of(part.surfaces.begin(), part.surfaces.end(), [&](const Boxed& one) {
        return one.is_sphere || length(one.box) * most >= length(part.extent.around);
    });
}

/// Whether they make a leaf.
bool fits_a_leaf(const Part& part) {
    if (part.surfaces.size() == 1) return true;
    return part.surfaces.size() <= fan_out && all_of_one_kind(part.surfaces) && fill_their_box(part);
}

/// How many surfaces come first after those that go to the left are moved there. Few of two kinds are parted by kind,
/// and then large ones from small ones; those that no plane parts, and those so deep down that no heuristic helps, in
/// the middle.
std::size_t arranged(const Part& part, int depth) {
    const auto moved = [&](const auto& goes_left) {
        const auto middle = std::partition(part.surfaces.begin(), part.surfaces.end(), goes_left);
        return static_cast<std::size_t>(middle - part.surfaces.begin());
    };
    if (part.surfaces.size() <= fan_out) {
        if (!all_of_one_kind(part.surfaces)) return moved([](const Boxed& one) { return one.is_sphere; });
        const float half = length(part.extent.around) / 2;
        const std::size_t large = moved([&](const Boxed& one) { return length(one.box) > half; });
        if (large > 0 && large < part.surfaces.size()) return large;
    }
    if (depth > deep) return part.surfaces.size() / 2;
    const Binning binning(part.extent.middles);
    const Bins all = summed<Bins>(part.surfaces, [&](std::span<Boxed> some, Bins& result) {
        for (const Boxed& one : some)
            for (int k = 0; k < 3; ++k) {
                const int bin = binning(one, k);
                result.box[k][bin].add(one.box);
                ++result.count[k][bin];
            }
    });
    const Cut cut = best_cut(all, binning);
    if (cut.axis < 0) return part.surfaces.size() / 2;
    return moved([&](const Boxed& one) { return binning(one, cut.axis) < cut.bin; });
}

std::pair<Part, Part> cut_in_two(const Part& part, int depth) {
    const std::size_t left = arranged(part, depth);
    const std::span<Boxed> first = part.surfaces.first(left), second = part.surfaces.subspan(left);
    return {{first, extent_of(first)}, {second, extent_of(second)}};
}

void set_child(Node& node, int at, const Box& box, std::uint32_t child) {
    for (int k = 0; k < 3; ++k) {
        node.side[Node::lo][k][at] = box.lo[k];
        node.side[Node::hi][k][at] = box.hi[k];
    }
    node.child[at] = child;
}

/// Makes the nodes, in any order, and puts them in order at the end.
class Builder {
public:
    /// A node has two children at least, but for a root above one leaf: there are no more nodes than surfaces.
    explicit Builder(std::span<Boxed> surfaces)
        : surfaces_(surfaces), nodes_(new Node[surfaces.size()]), leaf_sizes_(new std::uint8_t[surfaces.size()]) {}

    Hierarchy build() {
        const std::uint32_t root = next_++;
        make_node(root, {surfaces_, extent_of(surfaces_)}, 0);
        Hierarchy result;
        result.nodes.reserve(next_);
        result.surfaces.reserve(surfaces_.size());
        add_copy(root, result);
        return result;
    }

private:
    void make_node(std::uint32_t number, const Part& part, int depth) {
        Part parts[fan_out] = {part};
        int count = 1;
        while (count < fan_out) {
            Part* largest = nullptr;
            for (Part& one : std::span(parts, static_cast<std::size_t>(count)))
                if (!fits_a_leaf(one) &&
                    (!largest || one.extent.around.half_area() > largest->extent.around.half_area()))
                    largest = &one;
            if (!largest) break;
            std::tie(*largest, parts[count]) = cut_in_two(*largest, depth);
            ++count;
        }
        Node& node = nodes_[number];
        tbb::task_group others;
        for (int i = 0; i < fan_out; ++i) {
            if (i >= count) {
                set_child(node, i, {}, Child::nothing);
                continue;
            }
            const auto [surfaces, extent] = parts[i];
            if (fits_a_leaf(parts[i])) {
                set_child(node, i, extent.around, leaf_of(surfaces));
                continue;
            }
            const std::uint32_t child = next_++;
            set_child(node, i, extent.around, child);
            if (surfaces.size() < worth_a_task) make_node(child, parts[i], depth + 1);
            else others.run([this, child, its = parts[i], depth] { make_node(child, its, depth + 1); });
        }
        others.wait();
    }

    /// A leaf's code is, while building, where its surfaces begin.
    std::uint32_t leaf_of(std::span<Boxed> surfaces) {
        const auto first = surfaces.data() - surfaces_.data();
        leaf_sizes_[static_cast<std::size_t>(first)] = static_cast<std::uint8_t>(surfaces.size());
        return Child::leaf | static_cast<std::uint32_t>(first);
    }

    /// Appends a node and all below it: depth first, so that what is visited together lies together.
    std::uint32_t add_copy(std::uint32_t number, Hierarchy& result) {
        const auto here = static_cast<std::uint32_t>(result.nodes.size());
        result.nodes.push_back(nodes_[number]);
        for (int i = 0; i < fan_out; ++i) {
            const std::uint32_t child = result.nodes[here].child[i];
            if (child == Child::nothing) continue;
            const std::uint32_t copied =
                Child::is_leaf(child) ? add_leaf(Child::index(child), result) : add_copy(child, result);
            result.nodes[here].child[i] = copied;
        }
        return here;
    }

    std::uint32_t add_leaf(std::uint32_t first, Hierarchy& result) const {
        const std::span<const Boxed> surfaces = surfaces_.subspan(first, leaf_sizes_[first]);
        const bool of_spheres = surfaces.front().is_sphere;
        std::vector<Leaf>& leaves = of_spheres ? result.sphere_leaves : result.triangle_leaves;
        const auto number = static_cast<std::uint32_t>(leaves.size());
        leaves.push_back(
            {static_cast<std::uint32_t>(result.surfaces.size()), static_cast<std::uint32_t>(surfaces.size())});
        for (const Boxed& one : surfaces) result.surfaces.push_back(one.surface);
        return Child::leaf | (of_spheres ? Child::spheres : 0) | number;
    }

    std::span<Boxed> surfaces_;
    std::unique_ptr<Node[]> nodes_;
    std::unique_ptr<std::uint8_t[]> leaf_sizes_;
    std::atomic<std::uint32_t> next_ = 0;
};

}  // namespace

Hierarchy build(std::vector<Boxed> surfaces, int threads) {
    if (surfaces.empty()) return {};
    Hierarchy result;
    with_threads(threads, [&] { result = Builder(surfaces).build(); });
    return result;
}

}  // namespace glassbox::engine
