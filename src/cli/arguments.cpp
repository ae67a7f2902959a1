#include "cli/arguments.hpp"

#include <fmt/format.h>

#include <type_traits>
#include <vector>

#include "cli/scene_path.hpp"
#include "cli/typed.hpp"
#include "render/option_names.hpp"
#include "render/view.hpp"
#include "scene/scene_file.hpp"
#include "scene/shading_models.hpp"

namespace glassbox {

namespace {

/// "a, b or c".
std::string either(const std::vector<std::string>& words) {
    std::string text = words.front();
    for (std::size_t i = 1; i < words.size(); ++i) text += (i + 1 < words.size() ? ", " : " or ") + words[i];
    return text;
}

template <class Value, std::size_t count>
std::string either(const NameTable<Value, count>& table) {
    std::vector<std::string> words;
    for (const auto& [name, value, help] : table) {
        words.emplace_back(name);
        if constexpr (std::is_same_v<Value, TriangleRule>)
            if (const auto* rule = std::get_if<Tolerance>(&value))
                words.back() += fmt::format("[:{:.1f}]", rule->tolerance);
    }
    return either(words);
}

/// Adds options under one heading of the help page.
struct Heading {
    CLI::App& command;
    const char* title;

    /// An option whose word is read by a function of its own: `read("--size", "800x600")`.
    template <class Read>
    void add(const char* name, const char* value, const std::string& help, const Read& read) const {
        const auto callback = [name, read](const std::string& typed) { read(name, typed); };
        command.add_option_function<std::string>(name, callback, help)->type_name(value)->group(title);
    }
};

using Typed = const std::string&;

void add_picture_options(CLI::App& command, Request& request) {
    const Heading picture{command, "What is seen"};
    picture.add("--size", "WxH", "pixels of the picture (default: as the scene says)",
                [&](auto name, Typed typed) { request.size = size(name, typed); });
    picture.add("--stage", "1..5", "what is used: 1 rays, 2 spheres, 3 triangles, 4 shading, 5 turns (default: 5)",
                [&](auto name, Typed typed) { request.options.stage = whole_number(name, typed, 1, 5); });
    picture.add("--turn", "AXIS:DEGREES,...", "turn the view about the world's axes, in this order: z:10,y:-20",
                [&](auto name, Typed typed) { request.options.turns = turns(name, typed); });
    command
        .add_flag("--accumulated", request.options.accumulated,
                  "add the turns one to another, each rounded, instead of turning once by all of them")
        ->group(picture.title);
}

void add_shading_options(CLI::App& command, Request& request) {
    const Heading shading{command, "How it is shaded (defaults: as the scene says)"};
    const auto add_factor = [&](const char* option, const char* value, const char* help,
                                std::optional<double>& target) {
        shading.add(option, value, help, [&target](auto name, Typed typed) { target = factor(name, typed); });
    };
    add_factor("--ambient", "K", "factor of the ambient term, usually 0 to 1", request.ambient);
    add_factor("--diffuse", "K", "factor of the diffuse term, usually 0 to 1", request.diffuse);
    add_factor("--specular", "K", "factor of the specular term, usually 0 to 1", request.specular);
    add_factor("--exponent", "E", "exponent of the specular term: the larger, the smaller the highlight",
               request.exponent);
    shading.add("--shading", "MODEL", either(shading_models),
                [&](auto name, Typed typed) { request.model = chosen(name, typed, shading_models); });
    shading.add("--light", "X,Y,Z", "towards the light, from the world's origin",
                [&](auto name, Typed typed) { request.light = direction(name, typed); });
    add_factor("--intensity", "I", "of the light, 1 for full", request.intensity);
}

void add_computing_options(CLI::App& command, Request& request) {
    const Heading computing{command, "How it is computed"};
    const auto add_choice = [&](const char* option, const char* value, const char* help, const auto& table,
                                const auto& by_default, const auto& read) {
        computing.add(option, value, fmt::format("{}: {} (default: {})", help, either(table), name_of(by_default)),
                      read);
    };
    const Options defaults;
    add_choice("--scalar", "S", "what the formulas run in", scalars, defaults.scalar,
               [&](auto name, Typed typed) { request.options.scalar = chosen(name, typed, scalars); });
    add_choice("--triangle", "RULE", "when a triangle is hit", triangle_rules, defaults.triangle_rule,
               [&](auto name, Typed typed) { request.options.triangle_rule = triangle_rule(name, typed); });
    add_choice("--sphere", "RULE", "how a sphere's roots are found", sphere_rules, defaults.sphere_rule,
               [&](auto name, Typed typed) { request.options.sphere_rule = chosen(name, typed, sphere_rules); });
    add_choice("--engine", "E", "which surfaces a ray is tested against", engines, defaults.engine,
               [&](auto name, Typed typed) { request.options.engine = chosen(name, typed, engines); });
    computing.add("--threads", "N", "how many threads (default: as many as there are cores)",
                  [&](auto name, Typed typed) { request.threads = whole_number(name, typed, 1, 1024); });
}

}  // namespace

void add_scene_options(CLI::App& command, Request& request) {
    command
        .add_option("SCENE", request.scene, "a scene file, or the name of one that comes with Glassbox, such as room")
        ->type_name(" ")
        ->required();
    add_picture_options(command, request);
    add_shading_options(command, request);
    add_computing_options(command, request);
}

CLI::Option* add_file(CLI::App& command, const char* option, const char* value, const char* help, std::string& file) {
    const auto read = [name = between_commas(option).back(), &file](const std::string& typed) {
        if (typed.empty()) throw wrong(name, "'' must be the name of a file");
        file = typed;
    };
    return command.add_option_function<std::string>(option, read, help)->type_name(value);
}

Scene load(const Request& request) {
    Scene scene = read_scene(scene_path(request.scene));
    if (request.size) scene = resized(std::move(scene), request.size->first, request.size->second);
    Shading<double>& shading = scene.shading;
    shading.model = request.model.value_or(shading.model);
    shading.k_a = request.ambient.value_or(shading.k_a);
    shading.k_d = request.diffuse.value_or(shading.k_d);
    shading.k_s = request.specular.value_or(shading.k_s);
    shading.exponent = request.exponent.value_or(shading.exponent);
    scene.light_vector = request.light.value_or(scene.light_vector);
    scene.light_intensity = request.intensity.value_or(scene.light_intensity);
    return scene;
}

}  // namespace glassbox
