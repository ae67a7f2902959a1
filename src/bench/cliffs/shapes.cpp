#include "bench/cliffs/shapes.hpp"

#include <cmath>

#include "render/view.hpp"

namespace glassbox::shape {

Scene seen_from(const Vec3<double>& eye, const Vec3<double>& look_at, int side) {
    Scene scene;
    scene.width = scene.height = side;
    scene.view = PinholeView{eye, look_at, {0, 1, 0}};
    if (eye.x == look_at.x && eye.z == look_at.z) std::get<PinholeView>(scene.view).up = {0, 0, 1};
    return scene;
}

Scene seen_from_above(double width, int side, double shift) {
    Scene scene;
    scene.width = scene.height = side;
    const double pixel = width / side;
    scene.view = ParallelView{{shift, shift / 2, 1024}, {pixel, 0, 0}, {0, pixel, 0}, {0, 0, -1}};
    return scene;
}

std::vector<Ray<double>> picture_rays(const Scene& scene) {
    const View seen = view(scene, {});
    std::vector<Ray<double>> rays;
    for (int y = 0; y < scene.height; ++y)
        for (int x = 0; x < scene.width; ++x) rays.push_back(pixel_ray(seen, x, y, scene.height));
    return rays;
}

Scene with(Scene scene, Mesh mesh) {
    scene.meshes.push_back(std::move(mesh));
    return scene;
}
Scene with(Scene scene, const ColoredSphere& sphere) {
    scene.spheres.push_back(sphere);
    return scene;
}
Scene with(Scene scene, const ColoredTriangle& triangle) {
    scene.triangles.push_back(triangle);
    return scene;
}

Scene hills(double triangles, int side) {
    return with(seen_from({0, 0, 1.6}, {0, 0, 0}, side), terrain(static_cast<std::uint32_t>(std::sqrt(triangles / 2))));
}

Scene knot(std::uint32_t around, int side, double scale, const Vec3<double>& by) {
    const Vec3<double> eye{0, 0, 4}, look_at{0, 0.1, 0};
    return with(seen_from(scale * eye + by, scale * look_at + by, side), moved(trefoil(around, 12), scale, by));
}

Scene loose_balls(int many, Scene scene) {
    Random random(3);
    for (int x = 0; x < many; ++x)
        for (int y = 0; y < many; ++y)
            for (int z = 0; z < many; ++z)
                scene.spheres.push_back(
                    {Vec3<double>{1.0 * x, 1.0 * y, 1.0 * z} + random_point(random, -0.1, 0.1), 0.4, grey});
    return scene;
}

Mesh moved(Mesh mesh, double scale, const Vec3<double>& by) {
    for (Vec3<double>& v : mesh.vertices) v = scale * v + by;
    return mesh;
}

}  // namespace glassbox::shape
