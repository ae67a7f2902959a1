#include "bench/meshes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "numerics/as_float.hpp"

namespace glassbox {

namespace {

constexpr Rgb grey{200, 200, 200};

/// Adds a grid cell's two triangles, abc and acd.
void add_cell(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    mesh.faces.push_back({a, b, c});
    mesh.faces.push_back({a, c, d});
}

}  // namespace

Mesh trefoil(std::uint32_t around, std::uint32_t across) {
    Mesh mesh{{}, {}, grey};
    constexpr double turn = 2 * std::numbers::pi;
    const auto middle = [](double s) {
        return Vec3<double>{std::sin(s) + 2 * std::sin(2 * s), std::cos(s) - 2 * std::cos(2 * s), -std::sin(3 * s)};
    };
    for (std::uint32_t i = 0; i < around; ++i) {
        const double s = turn * i / around;
        const Vec3<double> forward = unit(middle(s + 1e-4) - middle(s - 1e-4));
        const Vec3<double> side = unit(cross(forward, Vec3<double>{0, 0, 1})), above = cross(side, forward);
        for (std::uint32_t j = 0; j < across; ++j) {
            const double angle = turn * j / across;
            mesh.vertices.push_back(
                as_float(1.0 / 3 * (middle(s) + 0.5 * (std::cos(angle) * side + std::sin(angle) * above))));
            const auto at = [&](std::uint32_t k, std::uint32_t l) { return k % around * across + l % across; };
            add_cell(mesh, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
        }
    }
    return mesh;
}

Mesh icosphere(int splits) {
    const double p = (1 + std::sqrt(5)) / 2;
    Mesh mesh{{{-1, p, 0},
               {1, p, 0},
               {-1, -p, 0},
               {1, -p, 0},
               {0, -1, p},
               {0, 1, p},
               {0, -1, -p},
               {0, 1, -p},
               {p, 0, -1},
               {p, 0, 1},
               {-p, 0, -1},
               {-p, 0, 1}},
              {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
               {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
               {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}},
              grey};
    for (; splits > 0; --splits) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [at, is_new] =
                middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(mesh.vertices.size()));
            if (is_new) mesh.vertices.push_back(unit(unit(mesh.vertices[a]) + unit(mesh.vertices[b])));
            return at->second;
        };
        std::vector<std::array<std::uint32_t, 3>> finer;
        finer.reserve(4 * mesh.faces.size());
        for (const auto& [a, b, c] : mesh.faces) {
            const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
        }
        mesh.faces = std::move(finer);
    }
    for (Vec3<double>& v : mesh.vertices) v = as_float(unit(v));
    return mesh;
}

Mesh terrain(std::uint32_t cells) {
    Mesh mesh{{}, {}, grey};
    const std::uint32_t row = cells + 1;
    mesh.vertices.reserve(std::size_t{row} * row);
    mesh.faces.reserve(std::size_t{2} * cells * cells);
    for (std::uint32_t j = 0; j < row; ++j)
        for (std::uint32_t i = 0; i < row; ++i) {
            const double x = 2.0 * i / cells - 1, y = 2.0 * j / cells - 1;
            const double z = 0.1 * std::sin(7 * x + 1) * std::cos(5 * y) + 0.03 * std::sin(23 * x + 3 * y) +
                             0.01 * std::sin(61 * y + 40 * x);
            mesh.vertices.push_back(as_float(Vec3<double>{x, y, z}));
        }
    for (std::uint32_t j = 0; j < cells; ++j)
        for (std::uint32_t i = 0; i < cells; ++i) {
            const std::uint32_t a = j * row + i;
            add_cell(mesh, a, a + 1, a + row + 1, a + row);
        }
    return mesh;
}

Scene seen(Mesh mesh, const Vec3<double>& eye, const Vec3<double>& look_at) {
    Scene scene;
    scene.width = scene.height = 1024;
    scene.view = PinholeView{eye, look_at};
    scene.meshes.push_back(std::move(mesh));
    return scene;
}

Scene a_million_triangles() { return seen(terrain(708), {-1.2, -1.5, 0.9}, {0, 0, -0.1}); }

}  // namespace glassbox
