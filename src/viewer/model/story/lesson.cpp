#include "viewer/model/story/lesson.hpp"

#include <string_view>

namespace glassbox {

namespace {

/// The function that computes a named number whose last operation is one of vectors and does not say so.
struct Formula {
    std::string_view name, file, function;
};

constexpr Formula formulas[] = {
    {"a", "/pluecker.hpp", "side"},
    {"b", "/pluecker.hpp", "side"},
    {"c", "/pluecker.hpp", "side"},
    {"(A − P)", "/sides.hpp", "seen_from"},
    {"(B − P)", "/sides.hpp", "seen_from"},
    {"(C − P)", "/sides.hpp", "seen_from"},
    {"point", "/ray.hpp", "at"},
    {"l", "/vec3.hpp", "unit"},
    {"r", "/vec3.hpp", "unit"},
    {"h", "/reflection.hpp", "halfway"},
    {"m", "/reflection.hpp", "reflected"},
    {"r·m", "/shade.hpp", "highlight_phong"},
    {"n·h", "/shade.hpp", "highlight_blinn"},
    {"n·l", "/shade.hpp", "terms"},
    {"n·r", "/shade.hpp", "terms"},
    {"ambient", "/shade.hpp", "terms"},
    {"diffuse", "/reflection.hpp", "diffuse"},
    {"specular", "/reflection.hpp", "specular"},
    {"sum", "/shade.hpp", "to_rgb"},
    {"colour", "/ray_color.hpp", "ray_color"},
};

/// Strips the axis: "point.x" becomes "point".
std::string_view without_axis(std::string_view name) {
    const bool has_axis = name.size() > 2 && name[name.size() - 2] == '.';
    return has_axis ? name.substr(0, name.size() - 2) : name;
}

Described described_by_name(const Story& story, std::string_view name) {
    if (name == "n") {
        const bool sphere = [&] {
            for (const story::Surface& surface : story.surfaces)
                if (story.hit && surface.number == story.hit->surface) return surface.kind == story::Kind::sphere;
            return false;
        }();
        return described_function(story, sphere ? "/sphere.hpp" : "/triangle.hpp", "normal");
    }
    for (const Formula& formula : formulas)
        if (formula.name == name) return described_function(story, formula.file, formula.function);
    return {};
}

}  // namespace

Described lesson_of(const Story& story, const Event& event) {
    if (!event.place)
        return event.function.empty() ? Described{} : described_function(story, event.file, event.function);
    const StepPlace& place = event.serves ? *event.serves : *event.place;
    const story::StoryStep& told = tape_of(story, place)[place.step];
    const Described by_name = described_by_name(story, without_axis(told.name));
    if (!by_name.text.empty()) return by_name;
    const SourceFile* const file = find_source(story, told.step.file);
    return file ? described_at(*file, static_cast<std::size_t>(told.step.line)) : Described{};
}

SourceLine source_of(const Story& story, const Event& event) {
    if (!event.place) {
        const Described described = lesson_of(story, event);
        return {described.file, 0};
    }
    const Step& step = tape_of(story, *event.place)[event.place->step].step;
    return {find_source(story, step.file), static_cast<std::size_t>(step.line)};
}

}  // namespace glassbox
