#include "learn/picture/to_sheet.hpp"

#include <variant>

#include "scene/coefficients.hpp"

namespace glassbox::learn::mine {
namespace {

void copy(const Vec3<double>& from, double (&to)[3]) { to[0] = from.x, to[1] = from.y, to[2] = from.z; }
void copy(Rgb from, std::uint8_t (&to)[3]) { to[0] = from.red, to[1] = from.green, to[2] = from.blue; }

}  // namespace

std::size_t triangles_of(const Scene& scene) {
    std::size_t count = scene.triangles.size();
    for (const Mesh& mesh : scene.meshes) count += mesh.faces.size();
    return count;
}

void write(const Scene& scene, const Options& options, Sheet& sheet) {
    sheet.width = scene.width;
    sheet.height = scene.height;
    sheet.stage = options.stage;
    if (const auto* rule = std::get_if<Tolerance>(&options.triangle_rule)) sheet.tolerance = rule->tolerance;
    sheet.accumulated = options.accumulated;
    if (const auto* seen = std::get_if<PinholeView>(&scene.view)) {
        sheet.pinhole = 1;
        copy(seen->eye, sheet.view[0]), copy(seen->look_at, sheet.view[1]), copy(seen->up, sheet.view[2]);
        sheet.field_of_view = seen->field_of_view;
    } else {
        const auto& [corner, right, up, direction] = std::get<ParallelView>(scene.view);
        copy(corner, sheet.view[0]), copy(right, sheet.view[1]);
        copy(up, sheet.view[2]), copy(direction, sheet.view[3]);
    }
    copy(scene.pivot, sheet.pivot);
    copy(scene.light_vector, sheet.light);
    sheet.intensity = scene.light_intensity;
    sheet.shading_model = static_cast<std::int32_t>(scene.shading.model);
    static_assert(coefficients<double>.size() <= most_coefficients);
    for (std::size_t i = 0; i < coefficients<double>.size(); ++i)
        sheet.coefficients[i] = scene.shading.*coefficients<double>[i].member;
    for (std::size_t i = 0; i < coefficients<double>.size(); ++i)
        if (const auto color = coefficients<double>[i].color_member) copy(scene.shading.*color, sheet.colors[i]);
    copy(scene.background, sheet.background);
    sheet.turns = static_cast<std::int64_t>(options.turns.size());
    sheet.spheres = static_cast<std::int64_t>(scene.spheres.size());
    sheet.triangles = static_cast<std::int64_t>(triangles_of(scene));

    const SheetLists lists = lists_of(sheet);
    for (std::size_t i = 0; i < options.turns.size(); ++i)
        lists.turns[i] = {static_cast<std::int32_t>(options.turns[i].axis), options.turns[i].degrees};
    for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
        copy(scene.spheres[i].center, lists.spheres[i].center);
        lists.spheres[i].radius = scene.spheres[i].radius;
        copy(scene.spheres[i].color, lists.spheres[i].color);
    }
    SheetTriangle* next = lists.triangles;
    const auto add = [&](const Vec3<double>& a, const Vec3<double>& b, const Vec3<double>& c, Rgb color) {
        copy(a, next->vertices[0]), copy(b, next->vertices[1]), copy(c, next->vertices[2]);
        copy(color, next->color);
        ++next;
    };
    for (const auto& [vertices, color] : scene.triangles) add(vertices[0], vertices[1], vertices[2], color);
    for (const Mesh& mesh : scene.meshes)
        for (const auto& [a, b, c] : mesh.faces) add(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c], mesh.color);
}

}  // namespace glassbox::learn::mine
