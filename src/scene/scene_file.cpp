#include "scene/scene_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "scene/coefficients.hpp"
#include "scene/error.hpp"
#include "scene/obj_file.hpp"
#include "scene/shading_models.hpp"
#include "scene/suggestion.hpp"
#include "scene/text_file.hpp"
#include "scene/toml_value.hpp"

namespace glassbox {
namespace {

constexpr Rgb light_grey{200, 200, 200};

int side(const Value& value) { return whole_number(value, 1, max_side); }

Vec3<double> light_color(const Value& value) { return to_vec3<double>(color(value)); }

/// Whether two directions are parallel, or so nearly that rounding hides the difference.
bool parallel(const Vec3<double>& a, const Vec3<double>& b) { return length(cross(unit(a), unit(b))) < 1e-12; }

ParallelView parallel_view(const Section& view) {
    ParallelView read;
    read.corner = view.get("corner", vector, read.corner);
    read.right = view.get("right", direction, read.right);
    read.up = view.get("up", direction, read.up);
    read.direction = view.get("direction", direction, read.direction);
    if (parallel(read.right, read.up)) {
        const auto up = view.find("up");
        throw error_at(place(up ? *up : view.at("right", "")),
                       "right and up are parallel; they must span the viewing plane, like [0, 1, 0] and [0, 0, 1]");
    }
    return read;
}

PinholeView pinhole_view(const Section& view) {
    const Value eye = view.at("eye", "eye = [10, 0, 0]");
    const Value look_at = view.at("look_at", "look_at = [0, 0, 0]");
    PinholeView read{vector(eye), vector(look_at)};
    read.up = view.get("up", direction, read.up);
    read.field_of_view = view.get("field_of_view", number, read.field_of_view);
    if (read.eye == read.look_at) throw wrong(look_at, "is where the eye is; it must be another point");
    expect_direction(read.look_at - read.eye, look_at, "the way from eye to look_at");
    if (parallel(read.look_at - read.eye, read.up)) {
        if (const auto up = view.find("up"))
            throw wrong(*up, "is parallel to the way from eye to look_at; it must point to the picture's upper edge");
        throw wrong(look_at,
                    "is right above or below the eye; then up, [0, 0, 1] by default, must be another direction");
    }
    if (!(read.field_of_view > 0 && read.field_of_view < 180))
        throw wrong(*view.find("field_of_view"),
                    fmt::format("is {} degrees; it must be between 0 and 180, both excluded", read.field_of_view));
    constexpr double least = 1e-8;  // with 32768 rows, directions still differ by 20 units in the last place
    if (read.field_of_view < least)
        throw wrong(
            *view.find("field_of_view"),
            fmt::format("is {} degrees: the rays of neighbouring pixels cannot be told apart; it must be {} or more",
                        read.field_of_view, least));
    return read;
}

std::variant<ParallelView, PinholeView> read_view(const Section& view) {
    constexpr std::array<std::string_view, 2> kinds{"parallel", "pinhole"};
    const auto kind_value = view.find("kind");
    const std::string kind = kind_value ? text(*kind_value) : "parallel";
    if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end())
        throw error_at(place(*kind_value),
                       fmt::format("unknown kind of view {}; {}", in_quotes(kind), suggestion(kind, kinds)));

    const auto refuse = [&](std::string_view other_kind, std::initializer_list<std::string_view> keys) {
        for (const auto key : keys)
            view.refuse_key(key, fmt::format("{} belongs to a view of kind '{}', and this one is of kind '{}'{}", key,
                                             other_kind, kind, kind_value ? "" : ", the default"));
    };
    if (kind == "parallel") {
        refuse("pinhole", {"eye", "look_at", "field_of_view"});
        return parallel_view(view);
    }
    refuse("parallel", {"corner", "right", "direction"});
    return pinhole_view(view);
}

ShadingModel shading_model(const Value& value) {
    const std::string name = text(value);
    if (const auto model = find_named(shading_models, name)) return *model;
    throw error_at(place(value), fmt::format("unknown shading model {}; {}", in_quotes(name),
                                             suggestion(name, names(shading_models))));
}

Shading<double> read_shading(const Section& shading, Shading<double> read) {
    std::vector<std::string_view> keys{"model"};
    for (const Coefficient<double>& coefficient : coefficients<double>) {
        keys.push_back(coefficient.name);
        if (coefficient.color_member) keys.push_back(coefficient.color_name);
    }
    shading.expect_keys(keys);
    read.model = shading.get("model", shading_model, read.model);
    for (const Coefficient<double>& coefficient : coefficients<double>)
        read.*coefficient.member = shading.get(coefficient.name, number_from_0, read.*coefficient.member);
    for (const Coefficient<double>& coefficient : coefficients<double>)
        if (const auto color = coefficient.color_member)
            read.*color = shading.get(coefficient.color_name, light_color, read.*color);
    return read;
}

ColoredSphere read_sphere(const Section& sphere) {
    sphere.expect_keys({"center", "radius", "color"});
    return {vector(sphere.at("center", "center = [0, 0, 0]")), number_above_0(sphere.at("radius", "radius = 50")),
            sphere.get("color", color, light_grey)};
}

ColoredTriangle read_triangle(const Section& triangle) {
    triangle.expect_keys({"vertices", "color"});
    const auto vertices =
        members(triangle.at("vertices", "vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]"),
                {"vertex 1", "vertex 2", "vertex 3"}, "three points, [[x, y, z], [x, y, z], [x, y, z]]");
    return {{vector(vertices[0]), vector(vertices[1]), vector(vertices[2])}, triangle.get("color", color, light_grey)};
}

Mesh read_mesh(const Section& mesh, const std::filesystem::path& folder) {
    mesh.expect_keys({"file", "color"});
    const Value file = mesh.at("file", "file = \"bunny.obj\"");
    const std::filesystem::path path = folder / text(file);
    if (const auto reason = why_unreadable(path))
        throw error_at(place(file),
                       fmt::format("cannot read the mesh {}: {} (file is relative to the scene file's folder)",
                                   in_quotes(path.string()), *reason));
    return read_obj(path, mesh.get("color", color, light_grey));
}

std::vector<FailingOption> read_failing(const Section& failing) {
    const std::vector<std::string_view> options{"scalar", "triangle", "sphere", "turn", "accumulated"};
    failing.expect_keys(options);
    std::vector<FailingOption> read;
    for (const std::string_view option : options) {
        const auto value = failing.find(option);
        if (!value) continue;
        if (option == "accumulated" && !value->node->is_string())
            throw error_at(place(*value), "accumulated must be \"on\" or \"off\", in quotes");
        read.push_back({std::string(option), text(*value), place(*value)});
    }
    return read;
}

}  // namespace

Scene read_scene(const std::filesystem::path& path) {
    const std::string file = path.string();
    const toml::table document = parse_toml(read_lines(path), file, "a scene");
    const Section top(document, "the scene", file);
    top.expect_keys({"title", "image", "view", "light", "shading", "sphere", "triangle", "mesh", "failing"});

    Scene scene;
    scene.title = top.get("title", text, scene.title);

    const Section image = top.section("image");
    image.expect_keys({"width", "height", "background", "border"});
    scene.width = image.get("width", side, scene.width);
    scene.height = image.get("height", side, scene.height);
    if (const std::int64_t pixels = std::int64_t{scene.width} * scene.height; pixels > max_pixels)
        throw error_at(place(*image.find("width")),
                       fmt::format("width times height is {} times {}, {} pixels; it must be at most {}", scene.width,
                                   scene.height, pixels, max_pixels));
    scene.background = image.get("background", color, scene.background);
    scene.border = image.get("border", color, scene.border);

    const Section view = top.section("view");
    view.expect_keys({"kind", "corner", "right", "up", "direction", "pivot", "eye", "look_at", "field_of_view"});
    scene.view = read_view(view);
    scene.pivot = view.get("pivot", vector, scene.pivot);

    const Section light = top.section("light");
    light.expect_keys({"position", "intensity"});
    scene.light_vector = light.get("position", direction, scene.light_vector);
    scene.light_intensity = light.get("intensity", number_from_0, scene.light_intensity);

    scene.shading = read_shading(top.section("shading"), scene.shading);

    for (const Section& sphere : top.sections("sphere")) scene.spheres.push_back(read_sphere(sphere));
    for (const Section& triangle : top.sections("triangle")) scene.triangles.push_back(read_triangle(triangle));
    for (const Section& mesh : top.sections("mesh")) scene.meshes.push_back(read_mesh(mesh, path.parent_path()));
    scene.failing = read_failing(top.section("failing"));
    return scene;
}

}  // namespace glassbox
