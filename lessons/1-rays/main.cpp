// Lesson 1: a ray for every pixel. All that there is to see is a wall of tiles, 50 wide and 25 high, 500 units behind
// the viewing plane: on the left in the paper's view, where all rays run one way; on the right through the same plane,
// from an eye 500 units before it. Each ray has the colour of its direction, darker in every other tile.
#include <picture.hpp>
#include <ray_color.hpp>
#include <viewing_plane.hpp>

using namespace glassbox;

/// The colour of the ray where it is at t. The tiles are counted from far outside, so that no number is negative.
Vec3<double> tile_color(const Ray<double>& ray, double t) {
    const Vec3<double> wall = at(ray, t);
    return ray_color(ray, static_cast<int>(wall.y + 2000), static_cast<int>(2 * (wall.z + 2000)));
}

int main(int argc, char** argv) {
    constexpr int width = 250, height = 250;
    const ViewingPlane<double> plane{{500, 0, 0}, {0, 2, 0}, {0, 0, 2}};  // every second pixel of the paper's
    const Parallel<double> parallel{plane, {-1, 0, 0}};
    const Pinhole<double> pinhole{plane, {1000, 250, 250}};

    Picture picture(2 * width, height);
    for (int i = 0; i < height; ++i) {
        for (int j = 0; j < width; ++j) {
            picture.paint(j, i, tile_color(pixel_ray(parallel, j, i), 500));       // 500 lengths of D = 500 units
            picture.paint(width + j, i, tile_color(pixel_ray(pinhole, j, i), 2));  // the plane is at t = 1
        }
    }
    return picture.write(argc > 1 ? argv[1] : "rays.ppm");
}
