#include <fmt/format.h>

#include "drawn.hpp"

namespace glassbox::fuzz {

namespace {

using oracle::Point;

/// Returns the shortest text that reads back as the same number, but never as a TOML integer: these end at 2⁶³.
std::string written(double x) {
    std::string text = fmt::format("{}", x);
    if (text.find_first_of(".en") == text.npos) text += ".0";
    return text;
}

std::string written(const Point& p) { return fmt::format("[{}, {}, {}]", written(p.x), written(p.y), written(p.z)); }

std::string color(std::size_t surface) {
    const std::size_t n = surface + 1;
    return fmt::format("[{}, {}, {}]", n >> 16 & 255, n >> 8 & 255, n & 255);
}

std::string written(const oracle::Parallel& view) {
    return fmt::format("kind = \"parallel\"\ncorner = {}\nright = {}\nup = {}\ndirection = {}\n", written(view.corner),
                       written(view.right), written(view.up), written(view.direction));
}

std::string written(const oracle::Pinhole& view) {
    return fmt::format("kind = \"pinhole\"\neye = {}\nlook_at = {}\nup = {}\nfield_of_view = {}\n", written(view.eye),
                       written(view.look_at), written(view.up), written(view.field_of_view));
}

}  // namespace

std::string to_toml(const Drawn& drawn) {
    std::string text = fmt::format("[image]\nwidth = {}\nheight = {}\n\n[view]\n{}", drawn.width, drawn.height,
                                   std::visit([](const auto& view) { return written(view); }, drawn.view));
    std::size_t surface = 0;
    for (const auto& [c, r] : drawn.surfaces.spheres)
        text += fmt::format("\n[[sphere]]\ncenter = {}\nradius = {}\ncolor = {}\n", written(c), written(r),
                            color(surface++));
    for (const auto& [A, B, C] : drawn.surfaces.triangles)
        text += fmt::format("\n[[triangle]]\nvertices = [{}, {}, {}]\ncolor = {}\n", written(A), written(B), written(C),
                            color(surface++));
    return text;
}

std::string to_csv(const std::vector<oracle::Ray>& rays) {
    std::string text = "ox,oy,oz,dx,dy,dz\n";
    for (const auto& [P, D] : rays) text += fmt::format("{},{},{},{},{},{}\n", P.x, P.y, P.z, D.x, D.y, D.z);
    return text;
}

}  // namespace glassbox::fuzz
