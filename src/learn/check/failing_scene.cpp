#include "learn/check/failing_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <viewing_plane.hpp>

#include "scene/direction.hpp"

namespace glassbox::learn {
namespace {

constexpr int side = 256;  // pixels

Vec3<double> vector_at(const std::vector<double>& numbers, std::size_t at) {
    return {numbers[at], numbers[at + 1], numbers[at + 2]};
}

/// Returns a number with all its digits, and a point or an exponent, as TOML has it.
std::string number(double x) {
    const std::string text = fmt::format("{}", x);
    return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

std::string vector(const Vec3<double>& v) { return fmt::format("[{}, {}, {}]", number(v.x), number(v.y), number(v.z)); }

/// How large the surface is, as a power of two, so that steps from pixel to pixel round little.
double size_of(const std::vector<double>& surface) {
    double size = 0;
    if (surface.size() == 4) size = surface[3];
    for (std::size_t i = 3; i < surface.size() && surface.size() == 9; ++i)
        size = std::max(size, std::abs(surface[i] - surface[i % 3]));
    return std::exp2(std::ceil(std::log2(size)));
}

/// Returns the plane whose pixels lie along the two axes on which the ray's direction is smallest, `step` apart, with
/// the ray's start at the pixel (j, i).
ViewingPlane<double> plane_about(const Vec3<double>& P, const Vec3<double>& D, double step, int j, int i) {
    const Vec3<double> x{step, 0, 0}, y{0, step, 0}, z{0, 0, step};
    const double along_x = std::abs(D.x), along_y = std::abs(D.y), along_z = std::abs(D.z);
    ViewingPlane<double> plane;
    if (along_z >= along_x && along_z >= along_y) plane.right = x, plane.up = y;
    else if (along_x >= along_y) plane.right = y, plane.up = z;
    else plane.right = x, plane.up = z;
    plane.corner = P - j * plane.right - i * plane.up;
    return plane;
}

}  // namespace

std::optional<FailingScene> failing_scene(const std::string& test, const Failure& failure) {
    const std::vector<double>& surface = failure.surface;
    if (failure.ray.size() != 6 || (surface.size() != 4 && surface.size() != 9)) return {};
    const Vec3<double> P = vector_at(failure.ray, 0), D = vector_at(failure.ray, 3);
    const double step = size_of(surface) * 4 / side;
    if (!why_no_direction(D).empty() || !(step > 1e-100 && step < 1e100)) return {};
    if (surface.size() == 4 && !(surface[3] > 0)) return {};

    int at = side / 2;
    ViewingPlane<double> plane = plane_about(P, D, step, at, at);
    if (point(plane, at, at) != P) {
        at = 0;
        plane = plane_about(P, D, step, at, at);
    }
    std::string title(name_and_scalar(test).first);
    std::replace_if(
        title.begin(), title.end(), [](char c) { return c == '"' || c == '\\' || static_cast<unsigned char>(c) < ' '; },
        '\'');
    FailingScene scene;
    scene.pixel = {at, side - 1 - at};
    scene.toml = fmt::format(
        "# Made by 'glassbox learn': the ray of a test that fails is that of pixel {},{}.\n"
        "title = \"{}\"\n[image]\nwidth = {}\nheight = {}\n"
        "[view]\nkind = \"parallel\"\ncorner = {}\nright = {}\nup = {}\ndirection = {}\n",
        scene.pixel.first, scene.pixel.second, title, side, side, vector(plane.corner), vector(plane.right),
        vector(plane.up), vector(D));
    if (surface.size() == 4)
        scene.toml +=
            fmt::format("[[sphere]]\ncenter = {}\nradius = {}\n", vector(vector_at(surface, 0)), number(surface[3]));
    else
        scene.toml += fmt::format("[[triangle]]\nvertices = [{}, {}, {}]\n", vector(vector_at(surface, 0)),
                                  vector(vector_at(surface, 3)), vector(vector_at(surface, 6)));
    return scene;
}

}  // namespace glassbox::learn
