// Lesson 1: a ray for every pixel. Nothing to hit yet, so each ray is painted in the colour of its direction: on the
// left the paper's view, where all run one way; on the right the same plane, seen from an eye 500 units before it.
#include <picture.hpp>
#include <ray_color.hpp>
#include <viewing_plane.hpp>

using namespace glassbox;

int main(int argc, char** argv) {
    constexpr int width = 500, height = 500;
    const ViewingPlane<double> plane{{500, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const Parallel<double> parallel{plane, {-1, 0, 0}};
    const Pinhole<double> pinhole{plane, {1000, 250, 250}};

    Picture picture(2 * width, height);
    for (int i = 0; i < height; ++i) {
        for (int j = 0; j < width; ++j) {
            picture.paint(j, i, ray_color(pixel_ray(parallel, j, i), j, i));
            picture.paint(width + j, i, ray_color(pixel_ray(pinhole, j, i), j, i));
        }
    }
    return picture.write(argc > 1 ? argv[1] : "rays.ppm");
}
