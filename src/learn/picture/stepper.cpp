// The learner's program that records one pixel's steps: the formulas of renderer.cpp in recorded numbers, written into
// memory that outlives it. If it crashes, all steps until then are there.
#include "learn/picture/prelude.hpp"  // first, and precompiled

#include <not_written.hpp>  // before the learner's headers, which may call it without

#include <intersect_sphere.hpp>
#include <levental_2014.hpp>
#include <moeller_trumbore.hpp>
#include <tolerance.hpp>

#include "explain/recorded_hit.hpp"
#include "explain/recorded_test.hpp"
#include "learn/picture/from_sheet.hpp"
#include "learn/picture/reel.hpp"
#include "render/search/surfaces.hpp"
#include "render/view.cpp"  // compiled anew, too: a learner's turn.hpp and viewing_plane.hpp count there

namespace glassbox::learn::mine {
namespace {

/// Ends the program: nothing needs so many steps.
[[noreturn]] void end_as_endless(Reel& reel) {
    reel.endless = 1;
    ::_exit(0);
}

/// Copies a text, or as much of it as there is room for.
template <std::size_t size>
void copy(std::string_view from, char (&to)[size]) {
    const std::size_t length = std::min(from.size(), size - 1);
    std::copy_n(from.data(), length, to);
    to[length] = '\0';
}

/// The names of files and functions, each once.
class Texts {
public:
    explicit Texts(Reel& reel) : reel_(reel) {}

    /// The text's number, from 1; 0 is an empty one.
    std::uint8_t number_of(const char* text) {
        if (*text == '\0') return 0;
        for (const auto& [known, number] : known_)
            if (known == text) return number;
        const std::uint32_t number = reel_.texts + 1;
        if (number >= most_texts) return 0;
        copy(text, reel_.text[number].text);
        reel_.texts.store(number, std::memory_order_release);
        known_.emplace_back(text, static_cast<std::uint8_t>(number));
        return static_cast<std::uint8_t>(number);
    }

private:
    Reel& reel_;
    std::vector<std::pair<const char*, std::uint8_t>> known_;
};

/// Copies a tape into the shared memory, as it is recorded.
class Reeling : public TapeListener {
public:
    /// Begins the next tape; there must be one left.
    Reeling(Reel& reel, Texts& texts, std::size_t surface) : reel_(reel), texts_(texts), tape_(reel.tape[reel.tapes]) {
        tape_.surface = static_cast<std::int64_t>(surface);
        tape_.steps = tape_.calls = tape_.names = 0;
        tape_.finished = tape_.met = 0;
        tape_.open_call = 0;
        tape_.t_step = -1;
        tape_.t = 0;
        tape_.test_steps = 0;
        reel_.tapes.fetch_add(1, std::memory_order_release);
    }

    void on_step(const Step& step) override {
        const std::uint32_t at = tape_.steps;
        if (at >= most_steps) end_as_endless(reel_);
        const std::uint8_t file = texts_.number_of(step.file);
        tape_.step[at] = {static_cast<double>(step.value),          step.left, step.right, step.call, step.line, file,
                          static_cast<std::uint8_t>(step.operation)};
        tape_.steps.store(at + 1, std::memory_order_release);
    }
    void on_name(StepNumber step, std::string_view name) override {
        const std::uint32_t at = tape_.names;
        if (at >= most_names) return;
        tape_.name[at].step = step;
        copy(name, tape_.name[at].text);
        tape_.names.store(at + 1, std::memory_order_release);
    }
    void on_call(const Call& call) override {
        const std::uint32_t at = tape_.calls + 1;
        if (at >= most_calls) end_as_endless(reel_);
        tape_.call[at] = {call.caller, call.line, texts_.number_of(call.header), texts_.number_of(call.function),
                          texts_.number_of(call.file)};
        tape_.calls.store(at, std::memory_order_release);
        tape_.open_call = at;
    }
    void on_return(CallNumber to) override { tape_.open_call = to; }

    template <class Test>
    void finish_test(const Test& test) {
        tape_.test_steps = static_cast<std::uint32_t>(test.step_count);
        tape_.met = test.crossing.met;
        tape_.t = test.crossing.t.value();
        if (test.crossing.t.tape()) tape_.t_step = test.crossing.t.step();
    }
    const ReelTape& finished() {
        tape_.finished = 1;
        return tape_;
    }

private:
    Reel& reel_;
    Texts& texts_;
    ReelTape& tape_;
};

/// Calls `use(surface, rules)` with a surface and a variant of the rule that tests it.
template <class SphereRoots, class TriangleTest>
struct Rules {
    std::variant<SphereRoots> spheres;
    std::variant<TriangleTest> triangles;

    template <class Use>
    auto operator()(const Surfaces<double>& surfaces, std::size_t number, const Use& use) const {
        return with_surface(surfaces, number, [&]<class Shape>(const Shape& shape) {
            if constexpr (std::is_same_v<Shape, Sphere<double>>) return use(shape, spheres);
            else return use(shape, triangles);
        });
    }
};

/// Tests a surface; keeps the tape if it is worth it.
template <class Shape, class Rule>
Crossing<double> record_test(Reel& reel, Texts& texts, const Ray<double>& ray, std::size_t number, const Shape& shape,
                             const Rule& rule) {
    Reeling to(reel, texts, number);
    const RecordedTest<double, Shape> test(ray, shape, rule, &to);
    to.finish_test(test);
    const ReelTape& tape = to.finished();
    Crossing<double> crossing;
    crossing.met = tape.met != 0, crossing.t = tape.t;
    const auto end = reel.listed + reel.listed_count;
    const bool is_kept = crossing.met || std::find(reel.listed, end, tape.surface) != end;
    // One is left for the next test, and one for the hit.
    if (!is_kept || reel.tapes > most_tapes - 2) --reel.tapes;
    return crossing;
}

template <class SphereRoots, class TriangleTest>
void record(Sheet& sheet, Reel& reel, const SphereRoots& roots, const TriangleTest& triangle_test) {
    const auto at = [&](ReelStage stage) { reel.at.store(stage, std::memory_order_release); };
    const Scene scene = scene_of(sheet);
    const Options options = options_of(sheet);
    at(ReelStage::view);
    const Ray<double> ray = pixel_ray(view(scene, options), reel.x, reel.y, sheet.height);
    const Vec3<double>* const parts[] = {&ray.P, &ray.D};
    for (int i = 0; i < 2; ++i)
        reel.ray[i][0] = parts[i]->x, reel.ray[i][1] = parts[i]->y, reel.ray[i][2] = parts[i]->z;
    at(ReelStage::ray_color);
    Texts texts(reel);
    const auto show = [&](Rgb color) {
        reel.color[0] = color.red, reel.color[1] = color.green, reel.color[2] = color.blue;
        at(ReelStage::done);
    };
    if (options.stage == 1) {
        Reeling to(reel, texts, 0);
        Tape recorded(Precision::of<double>(), &to);
        return show(record_ray_color<double>(recorded, ray, reel.x, sheet.height - 1 - reel.y).bytes);
    }
    at(ReelStage::tests);
    const Surfaces<double> all = surfaces<double>(scene, options.stage);
    const Rules<SphereRoots, TriangleTest> rules{{roots}, {triangle_test}};
    std::optional<Hit<double>> best;
    for (std::size_t i = 0; i < all.spheres.size() + all.triangles.size(); ++i) {
        const Crossing<double> crossing = rules(
            all, i, [&](const auto& shape, const auto& rule) { return record_test(reel, texts, ray, i, shape, rule); });
        at(ReelStage::choice);
        if (crossing.met) {
            ++reel.met;
            best = nearest(best, i, crossing);
        }
        at(ReelStage::tests);
        reel.tested.fetch_add(1, std::memory_order_release);
    }
    if (!best) return show(scene.background);
    at(ReelStage::hit);
    const Rgb own = surface_colors(scene)[best->surface];
    show(rules(all, best->surface, [&]<class Shape>(const Shape& shape, const auto& rule) {
        Reeling to(reel, texts, best->surface);
        reel.has_hit = 1;
        RecordedTest<double, Shape> test(ray, shape, rule, &to);
        to.finish_test(test);
        const RecordedHit<double> hit = record_hit(test, scene, options.stage, own);
        to.finished();
        return hit.shade ? hit.shade->color : own;
    }));
}

}  // namespace
}  // namespace glassbox::learn::mine

int main(int argc, char** argv) {
    using namespace glassbox::learn;
    using namespace glassbox::learn::mine;
    listen_for_the_end();
    const std::size_t sheet_size = argc == 2 ? std::strtoull(argv[1], nullptr, 10) : 0;
    auto* const memory =
        static_cast<std::byte*>(sheet_size ? handed_down(shared_memory_variable, sheet_size + sizeof(Reel)) : nullptr);
    if (!memory) {
        std::fputs("error: this is no program to be run by hand; glassbox view --mine runs it\n", stderr);
        return 2;
    }
    auto& sheet = *reinterpret_cast<Sheet*>(memory);
    auto& reel = *reinterpret_cast<Reel*>(memory + sheet_size);
    try {
        using glassbox::GLASSBOX_SPHERE_RULE, glassbox::GLASSBOX_TRIANGLE_RULE;
        record(sheet, reel, GLASSBOX_SPHERE_RULE{}, triangle_rule<GLASSBOX_TRIANGLE_RULE>(sheet));
    } catch (const glassbox::NotWritten&) {
        reel.not_written = 1;
        throw;
    }
    work_is_done();
    return 0;
}
