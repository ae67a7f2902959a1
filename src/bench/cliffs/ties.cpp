#include <array>

#include "bench/cliffs/cliff.hpp"
#include "bench/cliffs/shapes.hpp"

namespace glassbox {

namespace {

using namespace shape;

constexpr std::uint32_t thousand = 1000;

/// A thousand triangles that fill the picture, each `apart` behind the one before.
Traced layers(double apart, int side) {
    const Vec3<double> corners[3]{{-3, -2, 0.25}, {3, -2, 0}, {0, 4, 0}};
    const auto corner = [&](std::uint32_t i, std::uint32_t k) { return corners[k] - Vec3<double>{0, 0, apart * i}; };
    return {with(seen_from({0, 0, 2}, {0, 0, 0}, side), separate_triangles(thousand, corner))};
}

Traced thousand_hills(int side) { return {hills(thousand, side)}; }

Traced listed_twice(int side) {
    Scene scene = knot(128, side);
    scene.meshes.push_back(scene.meshes.front());
    return {scene};
}

/// A field of triangles with a vertex below every pixel's ray, moved aside by `shift` pixels.
Traced field(double shift, int side) {
    Mesh mesh = terrain(static_cast<std::uint32_t>(side));
    // The terrain's square from −1 to 1 becomes one from 0 to 1: its vertices' x and y are multiples of 1/side.
    for (Vec3<double>& v : mesh.vertices) v = {(v.x + 1) / 2, (v.y + 1) / 2, v.z};
    return {with(seen_from_above(1, side, shift / side), std::move(mesh))};
}

/// Ten by ten by ten unit cubes, 12,000 triangles, one beside the other, and rays through their corners if `shift` is
/// 0.
Traced cubes(double shift, int side) {
    Mesh cube{{}, {}, grey};
    for (const double x : {0., 1.})
        for (const double y : {0., 1.})
            for (const double z : {0., 1.}) cube.vertices.push_back({x, y, z});
    for (const auto& [a, b, c, d] : {std::array<std::uint32_t, 4>{0, 1, 3, 2},
                                     {4, 6, 7, 5},
                                     {0, 4, 5, 1},
                                     {2, 3, 7, 6},
                                     {0, 2, 6, 4},
                                     {1, 5, 7, 3}}) {
        cube.faces.push_back({a, b, c});
        cube.faces.push_back({a, c, d});
    }
    Scene scene = seen_from_above(16, side, shift);
    for (int x = 0; x < 10; ++x)
        for (int y = 0; y < 10; ++y)
            for (int z = 0; z < 10; ++z) scene.meshes.push_back(moved(cube, 1, {1.0 * x, 1.0 * y, 1.0 * z}));
    return {scene};
}

/// A thousand spheres of radius 1/2 in a lattice, each touching six others; half of the rays of a grid pass exactly
/// through points where they touch, if `shift` is 0.
Traced touching_balls(double shift, int side) {
    Scene scene = seen_from_above(16, side, shift);
    for (int x = 0; x < 10; ++x)
        for (int y = 0; y < 10; ++y)
            for (int z = 0; z < 10; ++z) scene.spheres.push_back({{1.0 * x, 1.0 * y, 1.0 * z}, 0.5, grey});
    return {scene};
}

}  // namespace

std::vector<Cliff> cliffs_of_ties() {
    return {
        {"1,000 coincident triangles", 5, "hills of 968 triangles", [](int side) { return layers(0, side); },
         thousand_hills},
        {"a mesh listed twice", 3, "a knot of 6,144 triangles", listed_twice,
         [](int side) { return Traced{knot(256, side)}; }},
        {"vertices exactly on the rays of a grid", 10, "the same, beside the rays",
         [](int side) { return field(0, side); }, [](int side) { return field(0.37, side); }},
        {"rays in the faces of 1,000 cubes", 10, "rays beside them", [](int side) { return cubes(0, side); },
         [](int side) { return cubes(0.037, side); }},
        {"rays through the points where 1,000 balls touch", 10, "rays beside them",
         [](int side) { return touching_balls(0, side); }, [](int side) { return touching_balls(0.037, side); }},
    };
}

}  // namespace glassbox
