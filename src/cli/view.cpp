#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "bench/meshes.hpp"
#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "output/output_file.hpp"
#include "render/typed.hpp"
#include "scene/scene_path.hpp"
#include "scene/text_file.hpp"
#include "viewer/bench.hpp"
#include "viewer/model/overlay/subtracted.hpp"
#include "viewer/script/script.hpp"
#include "viewer/view.hpp"

namespace glassbox {

namespace {

/// The value of --mine without a number.
constexpr const char* present_lesson = "true";

struct ViewRequest : Request {  ///< without a scene: the paper's, or that of the learner's lesson
    std::string pixel, overlay, minus, script, screenshot, window, mine, folder;
    bool bench = false;
};

std::optional<WindowSize> window_size(const ViewRequest& request) {
    if (request.window.empty()) return {};
    const auto [width, height] = size("--size", request.window);
    return WindowSize{width, height};
}

/// Returns what --mine chooses. Throws Error if there is no such lesson.
MineChoice chosen(MineChoice mine, const std::string& typed) {
    if (typed == present_lesson) return chosen_mine(std::move(mine), {});
    const std::optional<LessonChoice> lessons = read_lesson_choice(typed);
    mine = chosen_mine(std::move(mine), lessons);
    if (!mine.workspace || (lessons && mine.problem.empty())) return mine;
    const std::vector<learn::Exercise>& known = mine.workspace->exercises;
    throw wrong("--mine", fmt::format("'{}' must be a lesson, {} to {}, or all", typed, known.front().number,
                                      known.back().number));
}

/// What the viewer shows first: a scene and, on request, the learner's picture of it.
ViewerState first_state(const ViewRequest& request) {
    const bool mine = !request.mine.empty();
    MineChoice choice;
    choice.folder = request.folder;
    if (mine) choice = chosen(std::move(choice), request.mine);
    const learn::Exercise* const exercise = exercise_of(choice);
    if (exercise && request.mine != present_lesson && exercise->own_picture == learn::OwnPicture::none)
        throw wrong("--mine", fmt::format("no picture beside ours is made by what lesson {0} teaches; glassbox learn "
                                          "picture {0} -o picture.png draws one that is",
                                          exercise->number));
    const std::string usual = exercise ? (choice.workspace->root / exercise->scene).string() : "levental-2014";
    ViewerState state = opened(scene_path(request.scene.empty() ? usual : request.scene));
    state.mine = choice;
    if (mine) show_last_mine(state);
    if (mine && request.pixel.empty()) state.page = Page::mine;
    state.setup.change(typed_setup(request, state.setup.now()));
    return state;
}

/// A scene of a million triangles, the paper's in all else.
ViewerState with_a_million_triangles(const ViewerState& paper) {
    Scene scene = a_million_triangles();
    scene.width = 1280;
    scene.height = 720;
    ViewerState state = paper;
    state.scene = std::make_shared<const Scene>(std::move(scene));
    state.setup = History(setup_of(*state.scene));
    return state;
}

void print(const Turning& turning) {
    fmt::print("  {:<52} {:>7.1f} /s   wanted: over 20\n", "pictures, while the view turns", turning.pictures);
    fmt::print("  {:<52} {:>7.1f} ms   least {:.1f}, greatest {:.1f}\n", "from one to the next (median)",
               1000 * turning.median, 1000 * turning.least, 1000 * turning.greatest);
    std::vector<std::string> sizes;
    for (const auto& [factor, count] : turning.sizes)
        sizes.push_back(factor == 1 ? fmt::format("{} whole", count) : fmt::format("{} of 1/{}", count, factor));
    fmt::print("  {:<52} {}\n", "their widths, of the whole picture's", fmt::join(sizes, ", "));
    fmt::print("  {:<52} {:>7.1f} ms\n", "processor time a picture, with the interface's", 1000 * turning.processor);
}

void print(const Quickness& q) {
    const auto row = [](const char* what, double value, const char* wanted) {
        fmt::print("  {:<52} {:>7.1f} ms   {}\n", what, 1000 * value, wanted);
    };
    row("a frame, while a picture is rendered (median)", q.frame, "wanted: under 16");
    row("the slowest frame", q.slowest_frame, "");
    row("from a click to the inspector (median)", q.pin_to_inspector, "wanted: under 50");
    row("from a change to a first picture (median)", q.slider_to_picture, "wanted: under 50");
    print(q.turning);
    fmt::print("  {:<52} {:>7.2f} %    wanted: under 2\n", "of a core, while nothing happens", 100 * q.idle);
}

/// Measures the scene that was asked for; and, by default, one that is hard to turn.
void run_bench(ViewerState state, WindowSize size, bool by_default) {
    if (!by_default) return print(quickness(std::move(state), size));
    const ViewerState large = with_a_million_triangles(state);
    print(quickness(std::move(state), size));
    const Scene& scene = *large.scene;
    fmt::print("  {} triangles, {}x{}:\n", scene.meshes.front()->faces.size(), scene.width, scene.height);
    print(turning(large, size));
}

void print(std::vector<double> seconds) {
    std::sort(seconds.begin(), seconds.end());
    fmt::print(
        "  from saving a header to its picture, {} edits: {:.2f} s (median), {:.2f} s (slowest)   wanted: under 2\n",
        seconds.size(), seconds[seconds.size() / 2], seconds.back());
}

void run(const ViewRequest& request, const std::stop_token& stop) {
    const std::optional<WindowSize> size = window_size(request);
    std::vector<script::Command> commands;
    if (!request.script.empty()) commands = script::read(read_lines(request.script), request.script);
    ViewerState state = first_state(request);
    state.scene_menu.folder = shipped_scenes();
    if (!request.pixel.empty()) pin(state, pixel("--pixel", request.pixel, *state.scene));
    if (!request.overlay.empty()) {
        state.overlay.measurement = measurement("--overlay", request.overlay).name;
        state.page = Page::overlay;
    }
    if (!request.minus.empty()) {
        if (request.overlay.empty())
            throw wrong("--minus", "needs a measurement to subtract from, such as --overlay depth");
        subtract(state.overlay, minus("--minus", request.minus));
        if (const std::string why = why_not_subtracted(state.overlay); !why.empty()) throw wrong("--minus", why);
    }
    if (!request.screenshot.empty()) {
        check_picture_file(request.screenshot);
        commands.emplace_back(script::Screenshot{request.screenshot});
    }
    if (request.bench && !request.mine.empty())
        return print(saving_to_picture(std::move(state), size.value_or(WindowSize{1280, 720}), 10));
    if (request.bench && state.scene->width < 2)
        throw wrong("--bench", "needs a picture two pixels wide or more, to click on one and then another");
    if (request.bench) return run_bench(std::move(state), size.value_or(WindowSize{1280, 720}), request.scene.empty());
    if (commands.empty() && request.script.empty()) view(std::move(state), size, stop);
    else script::run(std::move(state), commands, size.value_or(WindowSize{1280, 800}));
}

}  // namespace

void add_view(CLI::App& program, Session& session) {
    const auto request = std::make_shared<ViewRequest>();
    CLI::App* command = program.add_subcommand("view", "Open the viewer: click a pixel, see everything that made it");
    command
        ->add_option(
            "SCENE", request->scene,
            "a scene file, or the name of one that comes with Glassbox (default: levental-2014, or with --mine "
            "the lesson's own)")
        ->type_name(" ");
    command->add_option("--pixel", request->pixel, "a pixel to begin with")->type_name("X,Y");
    command->add_option("--overlay", request->overlay, "a measurement to lay over the picture")->type_name("NAME");
    command
        ->add_option("--minus", request->minus,
                     "minus the same measurement with these settings changed: scalar:certified")
        ->type_name("NAME:VALUE[,...]");
    command->add_flag("--mine", request->mine,
                      "the picture of your own code beside ours: of the lesson where you are, of lesson 2 with "
                      "--mine=2, of all that you have written with --mine=all");
    command->add_option("--folder", request->folder, "the folder of your own code (default: my)")->type_name("DIR");
    command->add_option("--size", request->window, "of the window, in pixels (default: as last time)")
        ->type_name("WxH");
    add_file(*command, "--script", "FILE", "run the commands in a file, without a display (docs/viewer.md)",
             request->script);
    add_file(*command, "--screenshot", "OUT.png", "draw one picture of the interface, without a display",
             request->screenshot);
    command->add_flag("--bench", request->bench, "measure how quickly the interface answers, without a display");
    add_parameters(*command, *request);
    command->footer("Example: glassbox view levental-2014 --pixel 350,149 --overlay margin");
    command->callback([request, &session] { run(*request, session.interrupt.token()); });
}

}  // namespace glassbox
