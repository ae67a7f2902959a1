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

Vec3<double> centre(const Sphere<double>& s) { return s.C; }
Vec3<double> centre(const Triangle<double>& t) { return 1.0 / 3 * t.A + 1.0 / 3 * t.B + 1.0 / 3 * t.C; }

/// About the middle one of these points along each axis: floats relative to it are finest where most surfaces are,
/// however far away a few others lie.
Vec3<double> median(std::vector<Vec3<double>> points) {
    if (points.empty()) return {};
    const auto along = [&](double Vec3<double>::* k) {
        const auto middle = points.begin() + static_cast<std::ptrdiff_t>(points.size() / 2);
        std::ranges::nth_element(points, middle, {}, k);
        return (*middle).*k;
    };
    return {along(&Vec3<double>::x), along(&Vec3<double>::y), along(&Vec3<double>::z)};
}

void put(double (&to)[3][fan_out], std::uint32_t at, const Vec3<double>& v) {
    to[0][at] = v.x;
    to[1][at] = v.y;
    to[2][at] = v.z;
}

}  // namespace

Engine::Engine(std::vector<Sphere<double>> spheres, std::span<const Triangle<double>> triangles, int threads)
    : spheres_(std::move(spheres)), place_(triangles.size()) {
    constexpr std::size_t samples = 1000;
    std::vector<Vec3<double>> some;
    for (std::size_t i = 0; i < size(); i += size() / samples + 1) {
        const auto take = [&](const auto& surface) {
            if (greatest(surface) < largest) some.push_back(centre(surface));
        };
        if (i < spheres_.size()) take(spheres_[i]);
        else take(triangles[i - spheres_.size()]);
    }
    middle_ = median(std::move(some));

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
