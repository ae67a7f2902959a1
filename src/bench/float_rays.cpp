#include "bench/float_rays.hpp"

#include <cmath>

#include "bench/random.hpp"
#include "engine/tile.hpp"
#include "numerics/as_float.hpp"

namespace glassbox {

namespace {

/// Puts a zero bit between each two of the lower 16.
std::uint32_t spread_bits(std::uint32_t bits) {
    bits = (bits | bits << 8) & 0x00FF00FF;
    bits = (bits | bits << 4) & 0x0F0F0F0F;
    bits = (bits | bits << 2) & 0x33333333;
    return (bits | bits << 1) & 0x55555555;
}

Vec3<float> random_direction(Random& random) {
    for (;;) {
        const Vec3<double> v{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
        const double v2 = dot(v, v);
        if (v2 > 0.01 && v2 < 1) return convert<float>(1 / std::sqrt(v2) * v);
    }
}

}  // namespace

FromEye view_in_floats(const Scene& scene) {
    // Sums of multiples of 2⁻²³ below 2 are floats: a direction's coordinates are, for pictures up to 1,024 wide.
    const auto coarse = [](const Vec3<double>& v) {
        const auto multiple = [](double a) { return std::round(a * 0x1p23) * 0x1p-23; };
        return Vec3<double>{multiple(v.x), multiple(v.y), multiple(v.z)};
    };
    const auto seen = std::get<FromEye>(view(scene, {}));
    return {{coarse(seen.plane.corner), coarse(seen.plane.right), coarse(seen.plane.up)}, as_float(seen.eye)};
}

std::uint32_t place_of_pixel(std::uint32_t x, std::uint32_t y) { return spread_bits(x) | spread_bits(y) << 1; }

std::vector<Ray<float>> camera_rays(const FromEye& view, int side) {
    const auto count = static_cast<std::uint32_t>(side);
    std::vector<Ray<float>> rays(std::size_t{count} * count);
    for (std::uint32_t y = 0; y < count; ++y)
        for (std::uint32_t x = 0; x < count; ++x)
            rays[place_of_pixel(x, y)] = convert<float>(pixel_ray(view, x, count - 1 - y));
    return rays;
}

RaysFromSurfaces rays_from_surfaces(const Scene& scene, std::span<const Ray<float>> rays,
                                    std::span<const std::uint32_t> met, const Vec3<float>& towards_light) {
    // Exactly on the surface, rounding alone would decide whether a ray meets where it starts, and differently in each
    // tracer. So far off it, as a renderer would start, the question has one answer.
    constexpr double off_the_surface = 0x1p-12;
    const Mesh& mesh = scene.meshes.front();
    Random random(1);
    RaysFromSurfaces result;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (met[i] == engine::no_surface) continue;
        const auto& [a, b, c] = mesh.faces[met[i]];
        const Vec3<double> A = mesh.vertices[a];
        const Vec3<double> n = unit(cross(mesh.vertices[b] - A, mesh.vertices[c] - A));
        const Ray<double> ray = convert<double>(rays[i]);
        const double ahead = dot(n, ray.D);
        if (ahead == 0) continue;
        const Vec3<double> point = at(ray, dot(n, A - ray.P) / ahead);
        const auto start = convert<float>(point + (ahead < 0 ? off_the_surface : -off_the_surface) * n);
        result.all_ways.push_back({start, random_direction(random)});
        result.towards_light.push_back({start, towards_light});
    }
    return result;
}

}  // namespace glassbox
