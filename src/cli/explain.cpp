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
    std::string pixel;
    bool json = false, predict = false;
};

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
    const Scene scene = load(request);
    const auto [x, y] = pixel("--pixel", request.pixel, scene);
    note(command, "not used", unused_options(command, Rays::of_a_picture, request.setup.options));
    Story story = explain(scene, request.setup.options, x, y);
    if (request.predict) return ask(story);
    story.command = explain_command(scene_words(request), {x, y});
    print_text(request.json ? to_json(story) : to_text(story));
}

}  // namespace

void add_explain(CLI::App& program) {
    const auto request = std::make_shared<ExplainRequest>();
    CLI::App* command = program.add_subcommand("explain", "Tell how one pixel came about, number by number");
    add_scene_options(*command, *request);
    command->add_option("--pixel", request->pixel, "the pixel: x to the right, y down, (0,0) is the top-left one")
        ->type_name("X,Y")
        ->required();
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
