#include "viewer/script/commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/hierarchy.hpp"
#include "explain/timeline.hpp"
#include "output/output_file.hpp"
#include "render/job.hpp"
#include "render/typed.hpp"
#include "scene/error.hpp"
#include "scene/named.hpp"
#include "scene/scene_path.hpp"
#include "scene/suggestion.hpp"
#include "viewer/model/overlay/subtracted.hpp"
#include "viewer/model/space/camera.hpp"
#include "viewer/model/state/keys.hpp"
#include "viewer/model/state/tour.hpp"
#include "viewer/model/story/predicting.hpp"
#include "viewer/model/story/stepping.hpp"
#include "viewer/model/story/steps_now.hpp"
#include "viewer/model/work/watching.hpp"

namespace glassbox::script {

namespace {

constexpr NameTable<Page, 5> pages{{
    {"inspector", Page::inspector, ""},
    {"steps", Page::steps, ""},
    {"overlay", Page::overlay, ""},
    {"controls", Page::controls, ""},
    {"mine", Page::mine, ""},
}};
constexpr NameTable<Beside, 6> besides{{
    {"nothing", Beside::nothing, ""},
    {"overlay", Beside::overlay, ""},
    {"other", Beside::other, ""},
    {"difference", Beside::difference, ""},
    {"mine", Beside::mine, ""},
    {"mine-difference", Beside::mine_difference, ""},
}};
constexpr NameTable<StepTo, 7> step_targets{{
    {"first", StepTo::first, ""},
    {"back", StepTo::back, ""},
    {"forward", StepTo::forward, ""},
    {"last", StepTo::last, ""},
    {"no", StepTo::next_no, ""},
    {"failed", StepTo::next_failed, ""},
    {"cancellation", StepTo::next_cancellation, ""},
}};

/// What else `step` can be told.
struct StepAction {
    std::string_view name;
    void (*act)(ViewerState&, const Results&);
};
constexpr StepAction step_actions[] = {
    {"into", step_into},
    {"over", step_over},
    {"out", step_out},
    {"operand", [](ViewerState& s, const Results& r) { jump_to_operand(s, r, false); }},
    {"second-operand", [](ViewerState& s, const Results& r) { jump_to_operand(s, r, true); }},
    {"jump-back", jump_back},
    {"jump-forth", jump_forth},
};

/// "X,Y" or "none".
std::optional<Pixel> pixel_or_none(const std::string& name, const std::string& typed) {
    if (typed == "none") return {};
    const Words words = between_commas(typed);
    if (words.size() != 2) throw wrong(name, fmt::format("'{}' must be X,Y, a pixel, or none", typed));
    return Pixel{whole_number(name, words[0], 0, max_side), whole_number(name, words[1], 0, max_side)};
}

/// The same pixel, if it lies on the picture. Throws Error.
std::optional<Pixel> on_picture(const ViewerState& state, const std::optional<Pixel>& pixel) {
    const int width = state.scene->width, height = state.scene->height;
    if (pixel && (pixel->x >= width || pixel->y >= height))
        throw Error(fmt::format("({},{}) lies beside the picture; x must be from 0 to {} and y from 0 to {}", pixel->x,
                                pixel->y, width - 1, height - 1));
    return pixel;
}

Command overlay(const Words& words) {
    if (words[1] == "none") return change([](ViewerState& state) { state.overlay.measurement.clear(); });
    measurement("overlay", words[1]);
    return change([name = words[1]](ViewerState& state) { state.overlay.measurement = name; });
}

Command range(const Words& words) {
    if (words[1] == "auto") return change([](ViewerState& state) { state.overlay.range.reset(); });
    if (words.size() != 3) throw wrong("range", "must be followed by LOW HIGH, or by auto");
    const double low = number("range", words[1], -1e300, 1e300), high = number("range", words[2], -1e300, 1e300);
    if (!(low < high))
        throw wrong("range", fmt::format("LOW must be less than HIGH, and {} is not less than {}", low, high));
    return change([low, high](ViewerState& state) { state.overlay.range = {low, high}; });
}

Command brush(const Words& words) {
    if (words[1] == "none") return change([](ViewerState& state) { state.overlay.brush.reset(); });
    if (words.size() != 3) throw wrong("brush", "must be followed by LOW HIGH, or by none");
    const double low = number("brush", words[1], -INFINITY, INFINITY);
    const double high = number("brush", words[2], -INFINITY, INFINITY);
    if (!(low <= high)) throw wrong("brush", fmt::format("LOW must not be above HIGH, and {} is above {}", low, high));
    return change([low, high](ViewerState& state) {
        if (state.overlay.measurement.empty()) throw Error("brush: nothing is laid over; put 'overlay NAME' before");
        state.overlay.brush = Brush{name_of(state.overlay), low, high};
    });
}

Command zoom(const Words& words) {
    if (words[1] == "fit") return change([](ViewerState& state) { state.fit = Fit::as_fits; });
    const double to = number("zoom", words[1], least_zoom, greatest_zoom);
    const std::optional<Pixel> about = words.size() > 2 ? pixel_or_none("zoom", words[2]) : std::nullopt;
    return change([to, about](ViewerState& state) {
        state.fit = Fit::none;
        state.view = zoomed_to(state.view, to, state.area);
        const std::optional<Pixel> middle = about ? about : state.pinned;
        if (!middle) return;
        const Point now = state.view.on_screen({middle->x + .5, middle->y + .5});
        state.view = moved(state.view, {state.area.x / 2 - now.x, state.area.y / 2 - now.y});
    });
}

constexpr NameTable<SaveWhat, 3> what_is_saved{{
    {"picture", SaveWhat::picture, ""},
    {"overlay", SaveWhat::overlay, ""},
    {"beside", SaveWhat::beside, ""},
}};

/// What a file's name alone means: numbers are the overlay's.
SaveWhat usually_saved(const std::string& file) {
    const std::string extension = std::filesystem::path(file).extension().string();
    return extension == ".csv" || extension == ".exr" ? SaveWhat::overlay : SaveWhat::picture;
}

/// A script's files replace those that are there, as screenshots do.
Command save_file(const Words& words) {
    const SaveWhat what = words.size() > 2 ? chosen("save", words[2], what_is_saved) : usually_saved(words[1]);
    return change([what, file = words[1]](const ViewerState& state, const Results& results) {
        write(saving(state, results, what, file), {});
    });
}

Command orbit(const Words& words) {
    const Words typed = between_commas(words[1]);
    if (typed.size() != 2 && typed.size() != 3)
        throw wrong("orbit", fmt::format("'{}' must be AZIMUTH,ELEVATION or AZIMUTH,ELEVATION,DISTANCE", words[1]));
    Orbit to{number("orbit", typed[0], -360, 360), number("orbit", typed[1], -greatest_elevation, greatest_elevation)};
    if (typed.size() == 3) to.distance = number("orbit", typed[2], least_distance, greatest_distance);
    return change([to](ViewerState& state) { state.orbit = to; });
}

Command boxes(const Words& words) {
    if (words[1] == "off") return change([](ViewerState& state) { state.box_level.reset(); });
    return change([level = whole_number("boxes", words[1], 0, engine::most_levels)](ViewerState& state) {
        state.space_shown = true;
        state.box_level = level;
    });
}

void check_steps(std::string_view command, const ViewerState& state, const Results& results) {
    if (steps_now(state, results).story) return;
    const std::string& words = state.mine.problem.empty() ? results.mine_steps.update.words : state.mine.problem;
    if (state.pinned && state.mine.is_stepped) throw wrong(command, fmt::format("there are no steps: {}", words));
    throw Error(fmt::format("{}: no pixel is pinned; put 'pin X,Y' before", command));
}

Command step(const Words& words) {
    for (const StepAction& action : step_actions)
        if (words[1] == action.name)
            return change([act = action.act](ViewerState& state, const Results& results) {
                state.page = Page::steps;
                check_steps("step", state, results);
                act(state, results);
            });
    const auto to = find_named(step_targets, words[1]);
    const bool forward = words[1].starts_with('+'), relative = forward || words[1].starts_with('-');
    constexpr int most = 1'000'000'000;
    const int by = to ? 0 : whole_number("step", forward ? words[1].substr(1) : words[1], relative ? -most : 0, most);
    return change([to, by, relative](ViewerState& state, const Results& results) {
        state.page = Page::steps;
        check_steps("step", state, results);
        const std::span<const Event> events = steps_shown(state, results);
        const auto last = std::max<std::int64_t>(static_cast<std::int64_t>(events.size()) - 1, 0);
        const std::int64_t at = by + (relative ? static_cast<std::int64_t>(state.step) : 0);
        if (to) return go(state, results, *to);
        state.step = static_cast<std::size_t>(std::clamp<std::int64_t>(at, 0, last));
    });
}

Command feeding_only(const Words& words) {
    return change([on = chosen("feeding", words[1], switches)](ViewerState& state, const Results& results) {
        state.page = Page::steps;
        check_steps("feeding", state, results);
        show_only_feeding(state, results, on);
        if (on && !state.stepping.fed)
            throw Error("feeding: this event is no operation; put 'step …' before, to one that is");
    });
}

/// "NAME:BY", "undo" or "reset".
Command nudge_input(const Words& words) {
    if (words[1] == "undo") return change(undo_nudge);
    if (words[1] == "reset") return change([](ViewerState& state) { reset_nudges(state); });
    const std::size_t colon = words[1].find(':');
    if (colon == std::string::npos) throw wrong("nudge", fmt::format("'{}' must be NAME:BY, undo or reset", words[1]));
    const std::string name = words[1].substr(0, colon);
    const int by = whole_number("nudge", words[1].substr(colon + 1), -farthest_nudge, farthest_nudge);
    return change([name, by](ViewerState& state, const Results& results) {
        state.page = Page::steps;
        state.stepping.pane = StepsPane::nudge;
        const std::optional<std::size_t> row = row_to_nudge(state, results);
        if (!row) throw Error("nudge: there is no surface to test; pin a pixel, and step to a surface's test");
        std::vector<std::string> names;
        for (const NudgedInput& input : nudged(*results.story, *row, {}).inputs) names.push_back(input.name);
        if (std::ranges::find(names, name) == names.end())
            throw wrong("nudge",
                        fmt::format("'{}' is not known; {}", name,
                                    suggestion(name, std::vector<std::string_view>(names.begin(), names.end()))));
        nudge(state, results, name, by);
    });
}

/// Goes to the next question, and answers it.
Command predict(const Words& words) {
    return change([typed = words[1]](ViewerState& state, const Results& results) {
        const Question* const next = next_question(state, results);
        if (!next) throw Error("predict: nothing is asked; put 'set predict on' and 'pin X,Y' before");
        const std::optional<double> said = answer_in(typed, next->asked);
        if (!said && typed != "skip")
            throw wrong("predict", fmt::format("'{}' is no answer to: {}", typed,
                                               in_words(*results.story, results.timeline, *next)));
        state.page = Page::steps;
        state.step = next->at;
        answer(state, results, said);
    });
}

Command key(const Words& words) {
    const std::string label = words.size() > 2 ? words[1] + ' ' + words[2] : words[1];  // "Ctrl +" is two words
    std::vector<std::string_view> labels;
    for (const KeyBinding& binding : key_bindings()) {
        if (label == binding.label) return PressKey{binding.press};
        labels.push_back(binding.label);
    }
    throw wrong("key", fmt::format("'{}' is not known; {}", label, suggestion(label, labels)));
}

/// A command's name, how many words follow it, and what they mean.
struct Syntax {
    std::string_view name, usage;
    std::size_t least, most;
    Command (*read)(const Words&);
};

const Syntax all_commands[] = {
    {"open", "open SCENE", 1, 1,
     [](const Words& w) {
         return change([file = scene_path(w[1])](ViewerState& state) {
             open_scene(state, file);
             if (!state.file_error.empty()) throw Error(state.file_error);
         });
     }},
    {"size", "size WxH", 1, 1,
     [](const Words& w) -> Command {
         const auto [width, height] = size("size", w[1]);
         return ResizeTo{{width, height}};
     }},
    {"pin", "pin X,Y | none", 1, 1,
     [](const Words& w) {
         return change([at = pixel_or_none("pin", w[1])](ViewerState& state) { pin(state, on_picture(state, at)); });
     }},
    {"compare", "compare X,Y | none", 1, 1,
     [](const Words& w) {
         return change(
             [at = pixel_or_none("compare", w[1])](ViewerState& state) { state.compared = on_picture(state, at); });
     }},
    {"overlay", "overlay NAME | none", 1, 1, overlay},
    {"range", "range LOW HIGH | auto", 1, 2, range},
    {"beside", "beside nothing | overlay | other | difference | mine | mine-difference", 1, 1,
     [](const Words& w) {
         return change([what = chosen("beside", w[1], besides)](ViewerState& state) { show_beside(state, what); });
     }},
    {"stage", "stage 1..5", 1, 1,
     [](const Words& w) {
         return change_setup([to = whole_number("stage", w[1], 1, 5)](Setup& setup) { setup.options.stage = to; });
     }},
    {"turn", "turn AXIS:DEGREES,...", 1, 1,
     [](const Words& w) {
         return change_setup([by = turns("turn", w[1])](Setup& setup) {
             for (const Turn<double>& turn : by) setup = turned(std::move(setup), turn.axis, turn.degrees);
         });
     }},
    {"set", "set NAME VALUE", 2, 2, set},
    {"page", "page inspector | steps | overlay | controls | mine", 1, 1,
     [](const Words& w) {
         return change([page = chosen("page", w[1], pages)](ViewerState& state) { state.page = page; });
     }},
    {"step",
     "step N | +N | -N | first | back | forward | last | no | failed | cancellation | into | over | out | operand | "
     "second-operand | jump-back | jump-forth",
     1, 1, step},
    {"feeding", "feeding on | off", 1, 1, feeding_only},
    {"nudge", "nudge NAME:BY | undo | reset", 1, 1, nudge_input},
    {"predict", "predict hit | miss | + | - | 0 | BITS | skip", 1, 1, predict},
    {"watch", "watch PIXELS", 1, 1,
     [](const Words& w) {
         return change([shown = whole_number("watch", w[1], 0, max_side * max_side)](ViewerState& state) {
             state.watching.on = true;
             state.watching.running = false;
             state.watching.shown = std::min<double>(shown, pixels(state));
         });
     }},
    {"fail", "fail", 0, 0,
     [](const Words&) {
         return change([](ViewerState& state) {
             if (state.scene->failing.empty()) throw Error("fail: the scene does not say with what it fails");
             show_failing(state);
         });
     }},
    {"brush", "brush LOW HIGH | none", 1, 2, brush},
    {"zoom", "zoom Z [X,Y] | fit", 1, 2, zoom},
    {"orbit", "orbit AZIMUTH,ELEVATION[,DISTANCE]", 1, 1, orbit},
    {"boxes", "boxes LEVEL | off", 1, 1, boxes},
    {"tour", "tour STOP | off", 1, 1,
     [](const Words& w) {
         if (w[1] == "off") return change([](ViewerState& state) { leave_tour(state); });
         const int stop = whole_number("tour", w[1], 1, static_cast<int>(tour().size()));
         return change([stop](ViewerState& state) { go_to_stop(state, static_cast<std::size_t>(stop) - 1); });
     }},
    {"key", "key LABEL", 1, 2, key},
    {"wait", "wait [SECONDS]", 0, 1,
     [](const Words& w) -> Command { return Wait{w.size() > 1 ? number("wait", w[1], 0, 3600) : 0}; }},
    {"save", "save FILE [picture | overlay | beside]", 1, 2, save_file},
    {"screenshot", "screenshot FILE.png", 1, 1,
     [](const Words& w) -> Command {
         check_picture_file(w[1]);
         return Screenshot{w[1]};
     }},
};

}  // namespace

Command command_of(const Words& words) {
    std::vector<std::string_view> names;
    for (const Syntax& command : all_commands) {
        names.push_back(command.name);
        if (words[0] != command.name) continue;
        const std::size_t after = words.size() - 1;
        if (after < command.least || after > command.most) throw Error(fmt::format("this must be: {}", command.usage));
        return command.read(words);
    }
    throw Error(fmt::format("'{}' is not a command; {}", words[0], suggestion(words[0], names)));
}

}  // namespace glassbox::script
