// The story as JSON: it parses, and has the fields that docs/explain.md names.
#include "explain/json.hpp"

#include <doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "explain/explain.hpp"
#include "scene/scene_file.hpp"

using namespace glassbox;
using Json = nlohmann::json;

namespace {

Json json(const char* scene, int x, int y, const Options& options = {}) {
    return Json::parse(to_json(explain(read_scene(std::string(SCENES "/") + scene), options, x, y)));
}

void check_has(const Json& object, const std::vector<const char*>& fields) {
    for (const char* field : fields) CHECK_MESSAGE(object.contains(field), field);
    CHECK(object.size() == fields.size());
}

const std::vector<const char*> number_fields{"value", "hex",  "error",     "true", "true_hex",
                                             "off",   "sign", "bits_lost", "known"};

}  // namespace

TEST_CASE("all fields, and no others") {
    const Json story = json("levental-2014.toml", 350, 149);
    check_has(story, {"version", "command", "title", "size",         "pixel",        "column",    "row",
                      "line",    "verdict", "truth", "least_sure",   "shown",        "surface",   "color",
                      "border",  "options", "ray",   "traced_color", "ray_color",    "in_all",    "tested",
                      "nodes",   "met",     "hit",   "surfaces",     "boxes_missed", "not_listed"});
    CHECK(story["version"] == 2);
    CHECK(story["verdict"] == "right");
    CHECK(story["shown"] == "hit");
    check_has(story["truth"],
              {"surface", "shown_is_there", "at_once", "wrongly_met", "wrongly_missed", "by_rule", "turned"});
    CHECK(story["truth"]["surface"] == 0);
    check_has(story["least_sure"],
              {"margin", "proven", "surface", "nearer_than", "name", "row", "step", "worst_step", "worst_bits"});
    CHECK(story["least_sure"]["proven"] == true);
    CHECK(story["pixel"] == Json{350, 149});
    CHECK(story["color"] == Json{72, 255, 41});
    check_has(story["options"], {"stage", "scalar", "steps_in", "sphere", "triangle"});
    CHECK(story["options"]["scalar"] == "certified");
    CHECK(story["options"]["steps_in"] == "double");
    check_has(story["ray"], {"P", "P_hex", "D", "D_hex"});
    CHECK(story["ray"]["P_hex"][0] == "0x1.f4p+8");

    const Json& sphere = story["surfaces"][0];
    check_has(sphere, {"surface", "kind", "color", "met", "fate", "truly_met", "truly_nearest", "decided", "t",
                       "center", "radius", "textbook", "stable"});
    check_has(sphere["stable"], {"discriminant", "t0", "t1"});
    check_has(sphere["stable"]["discriminant"], number_fields);
    const Json& triangle = story["surfaces"][2];
    check_has(triangle, {"surface", "kind", "color", "met", "fate", "truly_met", "truly_nearest", "decided", "t",
                         "vertices", "sides", "sum", "deficit", "tolerance", "tolerance_accepts", "weights"});
    check_has(triangle["sides"], {"a", "b", "c"});

    const Json& hit = story["hit"];
    check_has(hit, {"surface", "t", "t_by_exact_arithmetic", "point", "normal", "shading", "most_bits_lost", "steps"});
    check_has(hit["shading"], {"model", "intensity", "exponent", "L", "l", "r", "n_l", "n_r", "half_vector", "n_h",
                               "ambient", "diffuse", "specular", "sum"});
    check_has(hit["shading"]["diffuse"], {"k", "factor", "color", "product", "bytes"});
    check_has(hit["most_bits_lost"], {"step", "bits"});
}

TEST_CASE("the steps: operands are earlier steps, and each operation has its line") {
    const Json story = json("room.toml", 100, 200);
    const Json& steps = story["hit"]["steps"];
    REQUIRE(steps.size() > 50);
    for (const Json& step : steps) {
        for (const Json& operand : step["operands"]) CHECK(operand < step["step"]);
        if (step["operands"].empty()) continue;
        CHECK(step["line"] > 0);
        CHECK(step["file"].get<std::string>().find("/src/") == std::string::npos);
    }
    const Json& worst = steps[story["hit"]["most_bits_lost"]["step"].get<std::size_t>()];
    CHECK(worst["own_bits_lost"] == story["hit"]["most_bits_lost"]["bits"]);
    const auto is_operation = [](const Json& step) {
        static const std::vector<std::string> others{"input", "constant", "<", ">", "≤", "≥", "=", "≠"};
        return std::find(others.begin(), others.end(), step["operation"].get<std::string>()) == others.end();
    };
    for (const Json& step : steps) {
        CHECK(step.contains("own_bits_lost") == is_operation(step));
        CHECK(step.contains("inherited_bits_lost") == is_operation(step));
    }
}

TEST_CASE("numbers come back to the bit") {
    const Scene scene = read_scene(SCENES "/room.toml");
    const Story story = explain(scene, {}, 100, 200);
    const Json parsed = Json::parse(to_json(story));
    CHECK(parsed["hit"]["t"]["value"].get<double>() == story.hit->t.value);
    CHECK(parsed["hit"]["t"]["error"].get<double>() == story.hit->t.error);
    CHECK(parsed["ray"]["D"][1].get<double>() == story.ray.D.y);
    CHECK(std::strtod(parsed["hit"]["t"]["hex"].get<std::string>().c_str(), nullptr) == story.hit->t.value);
}

TEST_CASE("a long double comes back from its hex to the bit") {
    Options options;
    options.scalar = Scalar::long_double;
    const Scene scene = read_scene(SCENES "/levental-2014.toml");
    const Story story = explain(scene, options, 333, 138);
    const Json parsed = Json::parse(to_json(story));
    CHECK(parsed["options"]["steps_in"] == "long-double");
    const std::string hex = parsed["hit"]["normal"][0]["hex"];
    CHECK(std::strtold(hex.c_str(), nullptr) == story.hit->normal.x.recorded);
    CHECK(parsed["hit"]["normal"][0]["value"].get<double>() == story.hit->normal.x.value);
}

TEST_CASE("background and border") {
    const Json story = json("levental-2014.toml", 0, 7);
    CHECK(story["shown"] == "miss");
    CHECK(story["verdict"] == "right");
    CHECK(story["truth"]["surface"].is_null());
    CHECK(story["border"] == true);
    CHECK(story["hit"].is_null());
    CHECK(story["surface"].is_null());
    CHECK(story["traced_color"] == Json{0, 0, 0});
}

TEST_CASE("Phong's own form has a reflection in the half vector's place") {
    Scene scene = read_scene(SCENES "/levental-2014.toml");
    scene.shading.model = ShadingModel::phong;
    const Json shading = Json::parse(to_json(explain(scene, {}, 350, 149)))["hit"]["shading"];
    CHECK(shading.contains("reflection"));
    CHECK(shading.contains("r_m"));
    CHECK_FALSE(shading.contains("n_h"));
}
