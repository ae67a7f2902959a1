// The inspector's numbers are the renderer's: in every pixel the recorded colour, t and normal equal, to the bit, those
// of render and measure.
#include <doctest.h>

#include <array>
#include <cstring>
#include <vector>

#include "explain/explain.hpp"
#include "render/option_names.hpp"
#include "render/render.hpp"
#include "render/search/build_engine.hpp"
#include "render/view.hpp"
#include "scene/scene_file.hpp"

using namespace glassbox;

namespace {

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0 || (a != a && b != b); }

#ifdef GLASSBOX_SANITIZED
constexpr int stride = 31;  // checked code is slow; 31 divides neither 500 nor the smaller pictures' widths
#else
constexpr int stride = 1;
#endif

struct Different {
    int colors = 0, ts = 0, normals = 0;
    int by_exact = 0;  ///< pixels whose t the steps do not give
};

Different differences(const Scene& scene, const Options& options) {
    const Image image = render(scene, options);
    const std::array wanted{find_measurement("depth"), find_measurement("normal")};
    const std::vector<std::vector<Channel>> channels = measure(scene, options, wanted);
    Different different;
    Job job;
    job.engine = build_engine(scene, options.stage);
    for (int pixels = scene.width * scene.height, i = 0; i < pixels; i += stride) {
        const int x = i % scene.width, y = i / scene.width;
        const Story story = explain(scene, options, x, y, Detail::recorded, job);
        different.colors += !(story.color == image.at(x, y));
        const auto pixel = static_cast<std::size_t>(y * scene.width + x);
        const auto measured = [&](std::size_t m, std::size_t p) { return channels[m][p].values[pixel]; };
        if (!story.hit) {
            different.ts += !same_bits(measured(0, 0), no_value);
            continue;
        }
        const auto& [nx, ny, nz] = story.hit->normal;
        different.ts += !same_bits(story.hit->t.value, measured(0, 0));
        different.normals += !(same_bits(nx.value, measured(1, 0)) && same_bits(ny.value, measured(1, 1)) &&
                               same_bits(nz.value, measured(1, 2)));
        different.by_exact += story.hit->t_by_exact;
    }
    return different;
}

void check_none(const Scene& scene, const Options& options) {
    const Different different = differences(scene, options);
    CHECK(different.colors == 0);
    CHECK(different.ts == 0);
    CHECK(different.normals == 0);
    if (!is_proven(options.scalar)) CHECK(different.by_exact == 0);
}

}  // namespace

TEST_CASE("every pixel of the paper's scene, certified") {
    Options options;
    options.scalar = Scalar::certified;
    check_none(read_scene(SCENES "/levental-2014.toml"), options);
}

TEST_CASE("every pixel of the paper's scene, in float: the steps are float's own") {
    Options options;
    options.scalar = Scalar::float_;
    check_none(read_scene(SCENES "/levental-2014.toml"), options);
}

TEST_CASE("every pixel of a smaller picture of the paper's scene, turned, by all rules, in each scalar") {
    const Scene scene = resized(read_scene(SCENES "/levental-2014.toml"), 80, 80);
    for (const Named<Scalar>& scalar : scalars)
        for (const TriangleRule& triangle_rule : {TriangleRule(Pluecker{}), TriangleRule(Tolerance{})})
            for (const SphereRule& sphere_rule :
                 {SphereRule(Stable{}), SphereRule(Textbook{}), SphereRule(Levental2014{})}) {
                CAPTURE(scalar.name);
                CAPTURE(triangle_rule.index());
                CAPTURE(sphere_rule.index());
                check_none(scene, {.turns = {{Axis::z, 10}, {Axis::y, 20}},
                                   .scalar = scalar.value,
                                   .sphere_rule = sphere_rule,
                                   .triangle_rule = triangle_rule});
            }
}

TEST_CASE("every pixel of a small picture of the room, in each shading model") {
    Scene scene = resized(read_scene(SCENES "/room.toml"), 48, 36);
    for (const ShadingModel model : {ShadingModel::blinn_phong, ShadingModel::phong, ShadingModel::levental_2014})
        for (const Scalar scalar : {Scalar::float_, Scalar::double_, Scalar::long_double, Scalar::certified}) {
            scene.shading.model = model;
            Options options;
            options.scalar = scalar;
            check_none(scene, options);
        }
}

TEST_CASE("every stage") {
    const Scene scene = resized(read_scene(SCENES "/levental-2014.toml"), 50, 50);
    for (int stage = 1; stage <= 5; ++stage)
        for (const Scalar scalar : {Scalar::float_, Scalar::long_double, Scalar::certified}) {
            CAPTURE(stage);
            check_none(scene, {.stage = stage, .turns = {}, .scalar = scalar, .sphere_rule = {}, .triangle_rule = {}});
        }
}

TEST_CASE("the fan, whose rays meet edges and a vertex that many triangles share") {
    Options options;
    options.scalar = Scalar::certified;
    check_none(resized(read_scene(SCENES "/fan.toml"), 100, 100), options);
}
