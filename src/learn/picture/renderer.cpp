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
#include "learn/picture/from_sheet.hpp"
#include "render/pixel.hpp"
#include "render/search/plain_search.hpp"
#include "render/tracer.hpp"
#include "render/view.cpp"  // compiled anew, too: a learner's turn.hpp and viewing_plane.hpp count there

namespace glassbox::learn::mine {
namespace {

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
