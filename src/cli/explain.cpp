#include "explain/explain.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <memory>
#include <optional>

#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/notes.hpp"
#include "cli/tell.hpp"
#include "explain/json.hpp"
#include "explain/predict.hpp"
#include "explain/text.hpp"
#include "render/typed.hpp"

namespace glassbox {

namespace {

struct ExplainRequest : Request {
    std::string pixel, ray;
    bool json = false, predict = false;
};

/// The scene seen as one pixel, whose ray this is, to the bit; nothing turns it, and no border hides it.
Scene seen_along(Scene scene, const Ray<double>& ray) {
    scene.width = scene.height = 1;
    scene.border.reset();
    scene.view = ParallelView{.corner = ray.P, .right = {}, .up = {}, .direction = ray.D};
    return scene;
}

/// What was typed about how pixels become rays.
std::vector<std::string> of_no_use_to_a_ray(const CLI::App& command) {
    std::vector<std::string> names;
    for (const std::string_view name : pixels_to_rays)
        if (const std::string option = fmt::format("--{}", name); command.get_option(option)->count() > 0)
            names.push_back(option + " (only for pixels)");
    return names;
}

/// Asks a reader at the terminal. Answers that come from elsewhere are shown, as a terminal shows what is typed.
void ask(const Story& story) {
    const bool is_typed = ::isatty(STDIN_FILENO) == 1;
    const auto read = [&]() -> std::optional<std::string> {
        check_printed();
        std::string line;
        const bool is_there = static_cast<bool>(std::getline(std::cin, line));
        if (!is_typed || !is_there) print_text(line + '\n');
        return is_there ? std::optional(line) : std::nullopt;
    };
    predict(story, print_text, read);
}

void run(const CLI::App& command, const ExplainRequest& request) {
    const bool has_pixel = command.get_option("--pixel")->count() > 0,
               is_own = command.get_option("--ray")->count() > 0;
    if (!has_pixel && !is_own)
        throw WrongWord("--pixel is missing: X,Y, x to the right, y down; or --ray, with a ray of your own");
    if (has_pixel && is_own) throw wrong("--pixel", "a pixel has a ray of its own; leave out this or --ray");
    const auto own = is_own ? std::optional(ray("--ray", request.ray)) : std::nullopt;
    const Scene scene = own ? seen_along(load(request), *own) : load(request);
    const auto [x, y] = own ? Pixel{} : pixel("--pixel", request.pixel, scene);
    Options options = request.setup.options;
    note(command, "not used", own ? of_no_use_to_a_ray(command) : unused_options(command, Rays::of_a_picture, options));
    if (own) options.turns.clear();
    Story story = explain(scene, options, x, y);
    if (request.predict) return ask(story);
    story.command =
        own ? explain_ray_command(words_of_own_rays(request), *own) : explain_command(scene_words(request), {x, y});
    print_text(request.json ? to_json(story) : to_text(story));
}

}  // namespace

void add_explain(CLI::App& program) {
    const auto request = std::make_shared<ExplainRequest>();
    CLI::App* command = program.add_subcommand("explain", "Tell how one pixel came about, number by number");
    add_scene_options(*command, *request);
    command->add_option("--pixel", request->pixel, "the pixel: x to the right, y down, (0,0) is the top-left one")
        ->type_name("X,Y");
    command->add_option("--ray", request->ray, "or a ray of your own: its origin and its direction")
        ->type_name("OX,OY,OZ,DX,DY,DZ");
    CLI::Option* json =
        command->add_flag("--json", request->json, "as JSON, with all digits and each operation (docs/explain.md)");
    command
        ->add_flag("--predict", request->predict,
                   "ask first: hit or miss, which sign, how many bits are lost; then tell, and keep the score")
        ->excludes(json);
    command->footer("Example: glassbox explain levental-2014 --pixel 350,149");
    command->callback([request, command] { run(*command, *request); });
}

}  // namespace glassbox
