// Lesson 1: vectors, and a ray for every pixel. Six parts, one for each step:
//
//   4 at   5 the parallel view   6 the pinhole view
//   1 dot  2 cross               3 length, unit
#include <cmath>
#include <picture.hpp>
#include <ray_color.hpp>
#include <viewing_plane.hpp>

using namespace glassbox;

constexpr int size = 250;  // each part, in pixels

const Vec3<double> black{0, 0, 0}, white{255, 255, 255}, orange{230, 120, 30}, blue{40, 90, 200};

/// 1 or 0.8 in turn, as x grows by 1.
double band(double x) { return std::fmod(std::floor(x), 2) == 0 ? 1 : 0.8; }

/// The point of column j and row i in parts 1 to 4: y to the right, z up, and x towards you.
Vec3<double> place(double j, double i) { return {0, j, i}; }

/// Whether two places are less than r apart. No function of yours is in it.
bool near(const Vec3<double>& p, const Vec3<double>& q, double r) {
    const auto [x, y, z] = p - q;
    return x * x + y * y + z * z < r * r;
}

/// The colour of a direction of length 1: x, y and z from -1 to 1 are red, green and blue from dark to full.
Vec3<double> direction_color(const Vec3<double>& D) { return 127.5 * (D + Vec3<double>{1, 1, 1}); }

/// The same for a ray's direction, of any length; darker in every other tile of a wall, 50 wide and 25 high. The ray is
/// there at t. The tiles are counted from far outside, so that no number is negative.
Vec3<double> tile_color(const Ray<double>& ray, double t) {
    const Vec3<double> wall = at(ray, t);
    return ray_color(ray, static_cast<int>(wall.y + 2000), static_cast<int>(2 * (wall.z + 2000)));
}

int main(int argc, char** argv) {
    const Vec3<double> b{0, 60, 80}, axis{0, 0, 1};
    // 5 and 6: every second pixel of the paper's plane; the wall is 500 units behind it, the eye 500 before it.
    const ViewingPlane<double> plane{{500, 0, 0}, {0, 2, 0}, {0, 0, 2}};
    const Parallel<double> parallel{plane, {-1, 0, 0}};
    const Pinhole<double> pinhole{plane, {1000, 250, 250}};

    Picture picture(3 * size, 2 * size);
    picture.paint_part(0, 0, size, size, [&](int j, int i) {  // a·b: its sign, and its size in bands of 2500
        const Vec3<double> a = place(j - size / 2, i - size / 2);
        if (near(a, b, 5) || near(a, {}, 5)) return white;
        const double product = dot(a, b);
        return product > 0 ? band(product / 2500) * orange : product < 0 ? band(-product / 2500) * blue : white;
    });
    picture.paint_part(size, 0, size, size, [&](int j, int i) {  // a globe: axis × a, its length in bands of 12
        Vec3<double> a = place(j - size / 2, i - size / 2);
        const double square = 120 * 120 - a.y * a.y - a.z * a.z;
        if (square < 0) return black;
        a.x = std::sqrt(square);
        const Vec3<double> east = cross(axis, a);
        const double how_long = std::sqrt(dot(east, east));
        return band(how_long / 12 + 0.5) * direction_color(east / how_long);
    });
    picture.paint_part(2 * size, 0, size, size, [&](int j, int i) {  // a tile a vector: direction; length, by 3
        const Vec3<double> a = place(j / 10 - 12, i / 10 - 12);
        return band(length(a) / 3) * direction_color(unit(a));
    });
    picture.paint_part(0, size, size, size, [&](int j, int i) {  // five rays, a dot each time that t is whole
        for (int rise = -20; rise <= 20; rise += 10) {
            const Ray<double> ray{place(20, 125), place(40, rise)};
            for (int quarter = 0; quarter <= 5 * 4; ++quarter)
                if (near(place(j, i), at(ray, quarter / 4.0), quarter % 4 == 0 ? 4 : 1))
                    return quarter == 0 ? white : orange;
        }
        return black;
    });
    picture.paint_part(size, size, size, size, [&](int j, int i) {
        return tile_color(pixel_ray(parallel, j, i), 500);  // 500 lengths of D = 500 units
    });
    picture.paint_part(2 * size, size, size, size, [&](int j, int i) {
        return tile_color(pixel_ray(pinhole, j, i), 2);  // the plane is at t = 1
    });
    return picture.write(argc > 1 ? argv[1] : "rays.ppm");
}
