// Asks a mesh for what rays meet: the first hit, all hits in order, each t with its proven error.
#include <cstdio>

#include <library/certified_scene.hpp>

using glassbox::CertifiedHit, glassbox::CertifiedScene, glassbox::Ray, glassbox::Triangle;

int main() {
    // A square of two triangles, and the same square 1e-9 behind it: farther, in doubles hardly.
    const double z = 1e-9;
    const std::vector<Triangle<double>> mesh{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}},
                                             {{0, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                                             {{0, 0, -z}, {1, 0, -z}, {1, 1, -z}},
                                             {{0, 0, -z}, {1, 1, -z}, {0, 1, -z}}};
    const CertifiedScene scene({}, mesh);

    const Ray<double> ray{{0.75, 0.25, 1e6}, {0, 0, -3}};
    if (const auto first = scene.first_hit(ray))
        std::printf("first: triangle %zu at t = %.17g ± %.2g\n", first->surface, first->t, first->t_error);

    const Ray<double> along_the_diagonal{{0.5, 0.5, 1e6}, {0, 0, -3}};  // through an edge of two triangles, twice
    for (const CertifiedHit& hit : scene.all_hits(along_the_diagonal))
        std::printf("then:  triangle %zu at t = %.17g ± %.2g\n", hit.surface, hit.t, hit.t_error);
}
