#include "cli/arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "render/failing.hpp"
#include "render/parameters.hpp"
#include "render/typed.hpp"
#include "render/view.hpp"
#include "scene/scene_file.hpp"
#include "scene/scene_path.hpp"
#include "scene/suggestion.hpp"

namespace glassbox {

namespace {

template <class Value, std::size_t count>
std::string either(const NameTable<Value, count>& table) {
    std::vector<std::string> words;
    for (const auto& [name, value, help] : table) {
        words.emplace_back(name);
        if constexpr (std::is_same_v<Value, TriangleRule>)
            if (const auto* rule = std::get_if<Tolerance>(&value))
                words.back() += fmt::format("[:{:.1f}]", rule->tolerance);
    }
    return glassbox::either(words);
}

/// Adds options under one heading of the help page.
struct Heading {
    CLI::App& command;
    const char* title;

    /// An option whose word is read by a function of its own: `read("--size", "800x600")`.
    template <class Read>
    void add(const std::string& name, const char* value, const std::string& help, const Read& read) const {
        const auto callback = [name, read](const std::string& typed) { read(name, typed); };
        command.add_option_function<std::string>(name, callback, help)->type_name(value)->group(title);
    }
};

constexpr const char* what_is_seen = "What is seen";
constexpr const char* how_shaded = "How it is shaded (defaults: as the scene says)";
constexpr const char* how_computed = "How it is computed";

using Typed = const std::string&;

/// What the words that a value is chosen by are, and which is the default where no scene says it.
template <class Value>
std::string help_of_choice(const Parameter& parameter, const Value& by_default) {
    const std::string words = either(choices<Value>);
    if (parameter.subject == Subject::shading) return words;
    return fmt::format("{}: {} (default: {})", parameter.help, words, name_of(by_default));
}

std::string help_of(const Parameter& parameter) {
    const Setup defaults;
    return with_value(parameter, defaults, [&](const auto& value) -> std::string {
        if constexpr (is_choice<std::remove_cvref_t<decltype(value)>>) return help_of_choice(parameter, value);
        else return parameter.help;
    });
}

void add_subject(const Heading& heading, Subject subject, Request& request) {
    for (const Parameter& parameter : parameters()) {
        if (parameter.subject != subject) continue;
        const std::string option = fmt::format("--{}", parameter.name);
        if (const auto* flag = std::get_if<bool Options::*>(&parameter.member)) {
            heading.command.add_flag(option, part(request.setup, *flag), parameter.help)->group(heading.title);
            continue;
        }
        heading.add(option, parameter.unit, help_of(parameter), [&](const std::string& name, Typed typed) {
            request.setup = with_typed(request.setup, parameter, name, typed);
            request.typed.push_back(&parameter);
        });
    }
}

void add_picture_options(CLI::App& command, Request& request) {
    const Heading picture{command, what_is_seen};
    picture.add("--size", "WxH", "pixels of the picture (default: as the scene says)",
                [&](const std::string& name, Typed typed) { request.size = size(name, typed); });
    add_subject(picture, Subject::view, request);
}

void add_computing_options(CLI::App& command, Request& request) {
    const Heading computing{command, how_computed};
    add_subject(computing, Subject::computing, request);
    computing.add("--threads", "N", "how many threads (default: as many as there are cores)",
                  [&](const std::string& name, Typed typed) { request.threads = whole_number(name, typed, 1, 1024); });
}

/// The parameters that were typed, flags too, in the order of the table.
std::vector<const Parameter*> all_typed(const Request& request) {
    std::vector<const Parameter*> all;
    for (const Parameter& parameter : parameters()) {
        const auto* const flag = std::get_if<bool Options::*>(&parameter.member);
        const bool is_on = flag && part(request.setup, *flag);
        if (is_on || std::count(request.typed.begin(), request.typed.end(), &parameter) > 0) all.push_back(&parameter);
    }
    return all;
}

}  // namespace

void add_scene_options(CLI::App& command, Request& request) {
    command
        .add_option("SCENE", request.scene, "a scene file, or the name of one that comes with Glassbox, such as room")
        ->type_name(" ")
        ->required();
    add_picture_options(command, request);
    add_subject({command, how_shaded}, Subject::shading, request);
    add_computing_options(command, request);
}

void add_parameters(CLI::App& command, Request& request) {
    add_subject({command, what_is_seen}, Subject::view, request);
    add_subject({command, how_shaded}, Subject::shading, request);
    add_subject({command, how_computed}, Subject::computing, request);
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
    const Setup own = setup_of(scene);
    failing_setup(scene, own);  // so that whoever writes a scene hears of a mistake in it, whatever reads it
    const Setup setup = typed_setup(request, own);
    return applied(std::move(scene), setup);
}

Setup typed_setup(const Request& request, Setup setup) {
    for (const Parameter* parameter : all_typed(request))
        setup = taken_over(std::move(setup), *parameter, request.setup);
    return setup;
}

SceneWords scene_words(const Request& request) {
    return {scene_path(request.scene), request.size, request.setup, all_typed(request)};
}

SceneWords words_of_own_rays(const Request& request) {
    SceneWords words = scene_words(request);
    words.size.reset();
    std::erase_if(words.told,
                  [](const Parameter* parameter) { return std::ranges::count(pixels_to_rays, parameter->name) > 0; });
    return words;
}

}  // namespace glassbox
