// The learner's renderer: Glassbox's own tracer, compiled with the learner's headers before ours, in double. It draws
// what the sheet says into the sheet, and notes each pixel before it begins it: if it crashes, or never comes back,
// that is where.
//
// It is compiled at every save, so it includes no more than it needs: no certified search, no library but the
// standard's.
#include "learn/picture/prelude.hpp"  // first, and precompiled

#include <not_written.hpp>  // before the learner's headers, which may call it without

#include <intersect_sphere.hpp>
#include <levental_2014.hpp>
#include <moeller_trumbore.hpp>
#include <tolerance.hpp>

#ifdef GLASSBOX_BOUNDED  // lesson 6, whose headers are of no use to plain double
#include "learn/picture/bounded_search.hpp"
#endif
#include "render/pixel.hpp"
#include "render/search/plain_search.hpp"
#include "render/tracer.hpp"
#include "render/view.cpp"  // compiled anew, too: a learner's turn.hpp and viewing_plane.hpp count there
#include "scene/coefficients.hpp"

namespace glassbox::learn::mine {
namespace {

Vec3<double> vector(const double (&from)[3]) {
    Vec3<double> v;
    v.x = from[0], v.y = from[1], v.z = from[2];
    return v;
}

Rgb color(const std::uint8_t (&from)[3]) { return {from[0], from[1], from[2]}; }

/// The scene as far as it is traced.
Scene scene_of(Sheet& sheet) {
    const SheetLists lists = lists_of(sheet);
    Scene scene;
    scene.width = sheet.width;
    scene.height = sheet.height;
    scene.background = color(sheet.background);
    if (sheet.pinhole)
        scene.view =
            PinholeView{vector(sheet.view[0]), vector(sheet.view[1]), vector(sheet.view[2]), sheet.field_of_view};
    else
        scene.view =
            ParallelView{vector(sheet.view[0]), vector(sheet.view[1]), vector(sheet.view[2]), vector(sheet.view[3])};
    scene.pivot = vector(sheet.pivot);
    scene.light_vector = vector(sheet.light);
    scene.light_intensity = sheet.intensity;
    scene.shading.model = static_cast<ShadingModel>(sheet.shading_model);
    for (std::size_t i = 0; i < coefficients<double>.size(); ++i)
        scene.shading.*coefficients<double>[i].member = sheet.coefficients[i];
    for (std::size_t i = 0; i < coefficients<double>.size(); ++i)
        if (const auto color = coefficients<double>[i].color_member) scene.shading.*color = vector(sheet.colors[i]);
    for (std::int64_t i = 0; i < sheet.spheres; ++i) {
        const auto& [center, radius, own] = lists.spheres[i];
        scene.spheres.push_back({vector(center), radius, color(own)});
    }
    for (std::int64_t i = 0; i < sheet.triangles; ++i) {
        const auto& [vertices, own] = lists.triangles[i];
        scene.triangles.push_back({{vector(vertices[0]), vector(vertices[1]), vector(vertices[2])}, color(own)});
    }
    return scene;
}

Options options_of(Sheet& sheet) {
    Options options;
    options.stage = sheet.stage;
    options.accumulated = sheet.accumulated != 0;
    for (std::int64_t i = 0; i < sheet.turns; ++i) {
        const auto& [axis, degrees] = lists_of(sheet).turns[i];
        options.turns.push_back({static_cast<Axis>(axis), degrees});
    }
    return options;
}

/// The probe that notices numbers that are none, and what is left open.
struct Noticing {
    bool not_a_number = false, undecided = false;

    template <class What, class... Values>
    void operator()(What, const Values&... values) {
        (hear(values), ...);
    }

#ifdef GLASSBOX_BOUNDED
    void operator()(LeftOpen) { undecided = true; }
#endif

    template <class Value>
    void hear(const Value& value) {
        if constexpr (std::is_floating_point_v<Value>) not_a_number = not_a_number || value != value;
        else if constexpr (requires { value.x + value.y + value.z; }) hear(value.x), hear(value.y), hear(value.z);
    }

    SheetPixel::State state() const {
        return not_a_number ? SheetPixel::not_a_number : undecided ? SheetPixel::undecided : SheetPixel::drawn;
    }
};

#ifdef GLASSBOX_BOUNDED
template <class SphereRoots, class TriangleTest>
BoundedSearch<SphereRoots, TriangleTest> search(const Sheet& sheet, Surfaces<double> surfaces, const View& seen,
                                                const SphereRoots& roots, const TriangleTest& test) {
    return {std::move(surfaces), roots, test, reach(seen, sheet.width, sheet.height)};
}
#else
template <class SphereRoots, class TriangleTest>
PlainSearch<double, SphereRoots, TriangleTest> search(const Sheet&, Surfaces<double> surfaces, const View&,
                                                      const SphereRoots& roots, const TriangleTest& test) {
    return {std::move(surfaces), roots, test};
}
#endif

/// The rule, with its tolerance if it has one.
template <class TriangleTest>
TriangleTest triangle_rule(const Sheet& sheet) {
    TriangleTest test{};
    if constexpr (requires { test.tolerance; }) test.tolerance = sheet.tolerance;
    return test;
}

template <class SphereRoots, class TriangleTest>
void draw(Sheet& sheet, const SphereRoots& roots, const TriangleTest& test) {
    const auto at = [&](Stage stage) { sheet.at.store(stage, std::memory_order_release); };
    const Scene scene = scene_of(sheet);
    const Options options = options_of(sheet);
    at(Stage::view);
    const View seen = view(scene, options);
    at(Stage::light);
    const Light<double> light = directional_light(scene.light_vector, scene.light_intensity);
    using Search = decltype(search(sheet, {}, seen, roots, test));
    const Tracer<Search> tracer{search(sheet, surfaces<double>(scene, options.stage), seen, roots, test),
                                surface_colors(scene),
                                scene.background,
                                light,
                                scene.shading,
                                options.stage};
    at(Stage::pixels);
    SheetPixel* const pixels = lists_of(sheet).pixels;
    coarse_first(sheet.width, sheet.height, [&](int x, int y) {
        sheet.x.store(x, std::memory_order_relaxed);
        sheet.y.store(y, std::memory_order_relaxed);
        Noticing probe;
        const Ray<double> ray = pixel_ray(seen, x, y, sheet.height);
        const Rgb made = tracer.color(ray, x, sheet.height - 1 - y, probe);
        probe.hear(ray.P), probe.hear(ray.D);
        pixels[index_of({x, y}, sheet.width)] = {made.red, made.green, made.blue, probe.state()};
        sheet.pixels_done.fetch_add(1, std::memory_order_release);
    });
    at(Stage::done);
}

}  // namespace
}  // namespace glassbox::learn::mine

int main(int argc, char** argv) {
    using namespace glassbox::learn;
    using namespace glassbox::learn::mine;
    listen_for_the_end();
    const std::size_t bytes = argc == 2 ? std::strtoull(argv[1], nullptr, 10) : 0;
    auto* const sheet = static_cast<Sheet*>(bytes ? handed_down(shared_memory_variable, bytes) : nullptr);
    if (!sheet) {
        std::fputs("error: this is no program to be run by hand; glassbox view --mine runs it\n", stderr);
        return 2;
    }
    try {
        // One rule of each kind: to compile those that are not chosen would take as long again.
        using glassbox::GLASSBOX_SPHERE_RULE, glassbox::GLASSBOX_TRIANGLE_RULE;
        draw(*sheet, GLASSBOX_SPHERE_RULE{}, triangle_rule<GLASSBOX_TRIANGLE_RULE>(*sheet));
    } catch (const glassbox::NotWritten&) {
        sheet->not_written = 1;
        throw;
    }
    work_is_done();
    return 0;
}
