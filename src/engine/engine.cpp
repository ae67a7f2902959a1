#include "engine/engine.hpp"

#include <algorithm>
#include <limits>

#include "engine/with_threads.hpp"

namespace glassbox::engine {

namespace {

/// The largest coordinate whose differences and products with others floats can hold.
constexpr double largest = 0x1p55;

/// Of so many surfaces it is asked where most of them are.
constexpr std::size_t samples = 1000;

Vec3<double> centre(const Sphere<double>& s) { return s.C; }
Vec3<double> centre(const Triangle<double>& t) { return 1.0 / 3 * t.A + 1.0 / 3 * t.B + 1.0 / 3 * t.C; }

/// About the middle one of these points along each axis: floats relative to it are finest where most surfaces are,
/// however far away a few others lie.
Vec3<double> median(std::vector<Vec3<double>> points) {
    if (points.empty()) return {};
    const auto along = [&](double Vec3<double>::*k) {
        const auto middle = points.begin() + static_cast<std::ptrdiff_t>(points.size() / 2);
        std::ranges::nth_element(points, middle, {}, k);
        return (*middle).*k;
    };
    return {along(&Vec3<double>::x), along(&Vec3<double>::y), along(&Vec3<double>::z)};
}

/// What nine in ten of these sizes do not exceed.
template <class Real>
Real nine_in_ten_reach(std::vector<Real> sizes) {
    const auto at = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() * 9 / 10);
    std::ranges::nth_element(sizes, at);
    return *at;
}

/// Sixteen times what nine in ten of the boxes reach, or what all do, if that is less.
float reach_of_most(std::span<const Boxed> boxed, float reach_of_all) {
    if (boxed.empty()) return 0;
    std::vector<float> some;
    for (std::size_t i = 0; i < boxed.size(); i += boxed.size() / samples + 1) some.push_back(boxed[i].box.reach());
    return std::min(16 * nine_in_ten_reach(std::move(some)), reach_of_all);
}

/// About how far most surfaces reach from the median of their middles.
double usual_size(const std::vector<Sphere<double>>& spheres, std::span<const Triangle<double>> triangles,
                  const Vec3<double>& middle) {
    std::vector<double> sizes;
    const std::size_t count = spheres.size() + triangles.size();
    for (std::size_t i = 0; i < count; i += count / samples + 1) {
        if (i < spheres.size()) {
            sizes.push_back(greatest_coordinate(Sphere<double>{spheres[i].C - middle, spheres[i].r}));
        } else {
            const auto& [A, B, C] = triangles[i - spheres.size()];
            sizes.push_back(greatest_coordinate(Triangle<double>{A - middle, B - middle, C - middle}));
        }
    }
    if (sizes.empty()) return 1;
    return nine_in_ten_reach(std::move(sizes));
}

/// See Engine::scale.
double scale_for(const std::vector<Sphere<double>>& spheres, std::span<const Triangle<double>> triangles,
                 double usual) {
    if (!(usual < 0x1p-10 || usual > 0x1p20) || !(usual > 0x1p-1000 && usual < 0x1p1000)) return 1;
    const double by = std::ldexp(1, -std::ilogb(usual));
    const auto kept = [&](const auto& surface) { return keeps_digits(surface, by); };
    return std::ranges::all_of(spheres, kept) && std::ranges::all_of(triangles, kept) ? by : 1;
}

/// The median of some surfaces' middles.
Vec3<double> middle_of(const std::vector<Sphere<double>>& spheres, std::span<const Triangle<double>> triangles) {
    std::vector<Vec3<double>> some;
    const std::size_t count = spheres.size() + triangles.size();
    for (std::size_t i = 0; i < count; i += count / samples + 1)
        some.push_back(i < spheres.size() ? centre(spheres[i]) : centre(triangles[i - spheres.size()]));
    return median(std::move(some));
}

}  // namespace

Engine::Engine(std::vector<Sphere<double>> spheres, std::span<const Triangle<double>> given, int threads)
    : spheres_(std::move(spheres)), place_(given.size()) {
    middle_ = middle_of(spheres_, given);
    scale_ = scale_for(spheres_, given, usual_size(spheres_, given, middle_));
    std::vector<Triangle<double>> at_scale;
    std::span<const Triangle<double>> triangles = given;
    if (scale_ != 1) {
        for (Sphere<double>& sphere : spheres_) sphere = scaled(sphere, scale_);
        for (const Triangle<double>& triangle : given) at_scale.push_back(scaled(triangle, scale_));
        triangles = at_scale;
        middle_ = scale_ * middle_;
    }
    if (!(greatest_coordinate(middle_) < largest)) middle_ = {};  // most are loose, then

    std::vector<Boxed> boxed;
    boxed.reserve(size());
    for (std::size_t i = 0; i < size(); ++i) {
        const auto number = static_cast<std::uint32_t>(i);
        const bool is_sphere = i < spheres_.size();
        const auto take = [&](const auto& surface) {
            if (greatest_coordinate(surface) < largest) boxed.push_back({box_of(surface, middle_), number, is_sphere});
            else loose_.push_back(number);
        };
        if (is_sphere) take(spheres_[i]);
        else take(triangles[i - spheres_.size()]);
    }
    copies_ = take_out_copies(boxed, spheres_, triangles);
    for (const Boxed& one : boxed) around_.add(one.box);
    reach_ = static_cast<double>(around_.reach());
    near_reach_ = reach_of_most(boxed, around_.reach());
    hierarchy_ = build(std::move(boxed), threads);

    const NumberedTriangles numbered{triangles, spheres_.size()};
    with_threads(threads, [&] { blocks_ = Blocks(hierarchy_.triangle_leaves, hierarchy_.surfaces, numbered); });
    std::vector<std::uint32_t> in_no_leaf;
    const auto add = [&](std::uint32_t surface) {
        if (surface >= spheres_.size()) in_no_leaf.push_back(surface);
    };
    for (const std::uint32_t surface : loose_) add(surface);
    for (const Copy& copy : copies_) add(copy.surface);
    blocks_.add_unseen(in_no_leaf, numbered);
    for (std::size_t number = 0; number < blocks_.size(); ++number)
        for (std::uint32_t at = 0; at < blocks_[number].count; ++at)
            place_[blocks_[number].surface[at] - spheres_.size()] = static_cast<std::uint32_t>(number) * fan_out + at;
}

std::size_t Engine::bytes() const {
    const auto of = [](const auto& list) { return list.capacity() * sizeof(list[0]); };
    return of(spheres_) + of(place_) + blocks_.bytes() + of(loose_) + of(copies_) + of(hierarchy_.nodes) +
           of(hierarchy_.surfaces) + of(hierarchy_.triangle_leaves) + of(hierarchy_.sphere_leaves);
}

}  // namespace glassbox::engine
