#include "lost_rays.hpp"

#include <intersect_triangle.hpp>
#include <probe.hpp>

#include <random>

namespace glassbox::test {

int lost_rays(int count) {
    std::mt19937 random(7);
    const auto number = [&] { return static_cast<float>(random() >> 8) * 0x1p-23f - 1; };  // in [−1, 1)
    const auto point = [&] { return Vec3<float>{number(), number(), number()}; };
    const Silent silent;
    int lost = 0;
    for (int i = 0; i < count; ++i) {
        // A and B are the edge; C and E = A + B − C lie on either side of it, far from the ray.
        const Vec3<float> A = point(), B = point(), C = point(), E = A + B - C;
        const Vec3<float> P = 4.0f * point();
        const float along = 0.25f + 0.25f * (1 + number());
        const Ray<float> ray{P, A + along * (B - A) - P};
        const bool met = Pluecker{}(ray, Triangle<float>{A, B, C}, silent).met ||
                         Pluecker{}(ray, Triangle<float>{B, A, E}, silent).met;
        // Behind the start, or seen nearly edge-on, a hit is not certain.
        const Vec3<float> n = cross(B - A, C - A);
        const float slant = dot(n, ray.D);
        const bool is_clear = slant * slant > 0.01f * dot(n, n) * dot(ray.D, ray.D) && dot(n, n) > 0.01f;
        lost += is_clear && !met;
    }
    return lost;
}

}  // namespace glassbox::test
