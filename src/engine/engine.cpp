#include "engine/engine.hpp"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <limits>

namespace glassbox::engine {

namespace {

/// The largest coordinate whose differences and products with others floats can hold.
constexpr double largest = 0x1p50;

double greatest(const Vec3<double>& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }
double greatest(const Sphere<double>& s) { return greatest(s.C) + s.r; }
double greatest(const Triangle<double>& t) { return std::max({greatest(t.A), greatest(t.B), greatest(t.C)}); }

/// The middle of all coordinates of the surfaces that are not too large.
class Middle {
public:
    void add(const Vec3<double>& lo, const Vec3<double>& hi) {
        lo_ = {std::min(lo_.x, lo.x), std::min(lo_.y, lo.y), std::min(lo_.z, lo.z)};
        hi_ = {std::max(hi_.x, hi.x), std::max(hi_.y, hi.y), std::max(hi_.z, hi.z)};
    }
    void add(const Sphere<double>& s) {
        const Vec3<double> r{s.r, s.r, s.r};
        add(s.C - r, s.C + r);
    }
    void add(const Triangle<double>& t) {
        for (const Vec3<double>& v : {t.A, t.B, t.C}) add(v, v);
    }
    Vec3<double> get() const { return lo_.x > hi_.x ? Vec3<double>{} : 0.5 * (lo_ + hi_); }

private:
    static constexpr double inf = std::numeric_limits<double>::infinity();
    Vec3<double> lo_{inf, inf, inf}, hi_{-inf, -inf, -inf};
};

void put(double (&to)[3][fan_out], std::uint32_t at, const Vec3<double>& v) {
    to[0][at] = v.x;
    to[1][at] = v.y;
    to[2][at] = v.z;
}

}  // namespace

Engine::Engine(std::vector<Sphere<double>> spheres, std::span<const Triangle<double>> triangles, int threads)
    : spheres_(std::move(spheres)), place_(triangles.size()) {
    Middle middle;
    const auto look_at = [&](const auto& surface) {
        if (greatest(surface) < largest) middle.add(surface);
    };
    std::ranges::for_each(spheres_, look_at);
    std::ranges::for_each(triangles, look_at);
    middle_ = middle.get();

    std::vector<Boxed> boxed;
    boxed.reserve(size());
    for (std::size_t i = 0; i < size(); ++i) {
        const auto number = static_cast<std::uint32_t>(i);
        const bool is_sphere = i < spheres_.size();
        const auto take = [&](const auto& surface) {
            if (greatest(surface) < largest) boxed.push_back({box_of(surface, middle_), number, is_sphere});
            else loose_.push_back(number);
        };
        if (is_sphere) take(spheres_[i]);
        else take(triangles[i - spheres_.size()]);
    }
    for (const Boxed& one : boxed) around_.add(one.box);
    hierarchy_ = build(std::move(boxed), threads);

    const auto add_block = [&](std::span<const std::uint32_t> surfaces) {
        Block& block = blocks_.emplace_back();
        block.count = static_cast<std::uint32_t>(surfaces.size());
        Box box;
        for (std::uint32_t at = 0; at < fan_out; ++at) {
            const std::uint32_t surface = surfaces[std::min<std::size_t>(at, surfaces.size() - 1)];
            const std::size_t number = surface - spheres_.size();
            block.surface[at] = surface;
            put(block.A, at, triangles[number].A);
            put(block.B, at, triangles[number].B);
            put(block.C, at, triangles[number].C);
            if (at >= block.count) continue;
            place_[number] = static_cast<std::uint32_t>(blocks_.size() - 1) * fan_out + at;
            box.add(box_of(triangles[number], middle_));
        }
        std::ranges::copy(box.lo, block.lo);
        std::ranges::copy(box.hi, block.hi);
    };
    blocks_.reserve(hierarchy_.triangle_leaves.size() + loose_.size() / fan_out + 1);
    for (const auto& [first, count] : hierarchy_.triangle_leaves)
        add_block(std::span(hierarchy_.surfaces).subspan(first, count));
    std::span<const std::uint32_t> rest = loose_;
    rest = rest.subspan(static_cast<std::size_t>(
        std::ranges::lower_bound(rest, static_cast<std::uint32_t>(spheres_.size())) - rest.begin()));
    for (; !rest.empty(); rest = rest.subspan(std::min<std::size_t>(rest.size(), fan_out)))
        add_block(rest.first(std::min<std::size_t>(rest.size(), fan_out)));
}

std::size_t Engine::bytes() const {
    const auto of = [](const auto& list) { return list.capacity() * sizeof(list[0]); };
    return of(spheres_) + of(place_) + of(blocks_) + of(loose_) + of(hierarchy_.nodes) + of(hierarchy_.surfaces) +
           of(hierarchy_.triangle_leaves) + of(hierarchy_.sphere_leaves);
}

}  // namespace glassbox::engine
