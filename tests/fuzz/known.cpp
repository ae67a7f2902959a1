#include "drawn.hpp"

namespace glassbox::fuzz {

namespace {

using oracle::Parallel, oracle::Pinhole;

/// All three weights of the first triangle are as large as the bound on their rounding, to 2⁻⁴⁵ of it; the sphere in
/// front of it is tested later. Truth: the sphere, at t = 4.
Drawn weights_at_their_bound() {
    Drawn drawn{"known", {}, {}, 1, 1, {}};
    const double y = 1048576, z = 1398101.2968749956, s = 0.0625, far = 1e7;
    drawn.view = Parallel{{100, y, z}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}};
    drawn.surfaces.spheres = {{{95, y, z}, 1}};
    drawn.surfaces.triangles = {{{99, y - s, z - s}, {90, y + 2 * s, z - s}, {90, y - s, z + 2 * s}},
                                {{-far, y - far, z - far}, {-far, y + far, z - far}, {-far, y, z + far}}};
    return drawn;
}

/// The squares of the sphere's numbers have few bits left, or none.
Drawn squares_of_few_bits() {
    Drawn drawn{"known", {}, {}, 97, 97, {}};
    drawn.view = Pinhole{{0, 0, 0}, {-1, 0, 0}, {0, 0, 1}, 90};
    drawn.surfaces.spheres = {{{-3e-161, 0, 0}, 1.5e-161}};
    drawn.surfaces.triangles = {{{-1, -5, -5}, {-1, 5, -5}, {-1, 0, 5}}};
    return drawn;
}

/// Far from the origin: the rays' directions must not lose digits because of that. The same when nearer.
Drawn far_eye(double scale) {
    Drawn drawn{"known", {}, {}, 13, 13, {}};
    drawn.view = Pinhole{{3 * scale, scale, 2 * scale}, {0, 0, 0}, {0, 0, 1}, 45};
    drawn.surfaces.spheres = {{{0, 0, 0}, scale}};
    drawn.surfaces.triangles = {{{scale, -scale, 0}, {scale, scale, 0}, {0, 0, 2 * scale}}};
    return drawn;
}

/// The ray starts on the second sphere and meets the first one before it leaves that.
Drawn starts_on_a_sphere() {
    Drawn drawn{"known", {}, {}, 1, 1, {}};
    drawn.view = Parallel{{-20, -4, -2}, {1, 0, 0}, {0, 1, 0}, {2, 1, -2}};
    drawn.surfaces.spheres = {{{-16, 0, -8}, 4}, {{-14, -4, -10}, 10}};
    return drawn;
}

/// t overflows where the direction is short, and is subnormal where all is.
Drawn sphere_of_size(double size, double length_of_D) {
    Drawn drawn{"known", {}, {}, 1, 1, {}};
    drawn.view = Parallel{{size / 2, 0, 4 * size}, {size, 0, 0}, {0, size, 0}, {0, 0, -length_of_D}};
    drawn.surfaces.spheres = {{{0, 0, 0}, size}};
    return drawn;
}

}  // namespace

std::vector<Drawn> known() {
    return {weights_at_their_bound(),
            squares_of_few_bits(),
            far_eye(1e12),
            far_eye(1e15),
            far_eye(1e80),
            far_eye(1e-90),
            starts_on_a_sphere(),
            sphere_of_size(1e180, 1e-150),
            sphere_of_size(1e-314, 1e-90),
            sphere_of_size(1e-314, 1)};
}

}  // namespace glassbox::fuzz
