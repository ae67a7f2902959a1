#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <sphere.hpp>
#include <triangle.hpp>

#include "engine/hierarchy.hpp"

namespace glassbox::engine {

/// A surface that is the same as another one, which is listed after it: of equally near surfaces the last listed is the
/// one that is seen, so nobody ever sees the copy.
struct Copy {
    std::uint32_t of, surface;

    friend bool operator<(const Copy& a, const Copy& b) { return a.of != b.of ? a.of < b.of : a.surface < b.surface; }
};

/// Takes the copies out of a list of all surfaces in their order. Ordered by what they are copies of. Triangles are the
/// same if they have the same three corners, in whatever order.
std::vector<Copy> take_out_copies(std::vector<Boxed>& surfaces, std::span<const Sphere<double>> spheres,
                                  std::span<const Triangle<double>> triangles);

}  // namespace glassbox::engine
