#include "viewer/model/state/keys.hpp"

#include <algorithm>
#include <cmath>

#include "viewer/model/overlay/laid_over.hpp"
#include "viewer/model/space/boxes_in_space.hpp"
#include "viewer/model/space/camera.hpp"
#include "viewer/model/space/flight.hpp"
#include "viewer/model/state/command.hpp"
#include "viewer/model/state/playing.hpp"
#include "viewer/model/state/tour.hpp"
#include "viewer/model/story/predicting.hpp"
#include "viewer/model/story/stepping.hpp"
#include "viewer/model/story/steps_now.hpp"
#include "viewer/model/story/truth.hpp"

namespace glassbox {

namespace {

using State = ViewerState;

constexpr KeyPress character(char32_t c) { return {Key::character, c, false, false}; }
constexpr KeyPress control(char32_t c, bool shift = false) { return {Key::character, c, true, shift}; }
constexpr KeyPress named(Key key, bool control = false, bool shift = false) { return {key, 0, control, shift}; }

/// As in the paper's program, with its directions corrected: counter-clockwise as seen from the axis's tip.
template <Axis axis, int degrees>
void turn(State& state, const Results&, const KeyPress&) {
    state.setup.change(turned(state.setup.now(), axis, degrees));
}

void turn_back(State& state, const Results&, const KeyPress&) {
    Setup setup = state.setup.now();
    setup.options.turns.clear();
    state.setup.change(std::move(setup));
}

template <int dx, int dy>
void move_pin(State& state, const Results&, const KeyPress& press) {
    if (!state.pinned) return;
    const int by = press.shift ? 10 : 1;
    const auto [x, y] = *state.pinned;
    pin(state,
        Pixel{std::clamp(x + by * dx, 0, state.scene->width - 1), std::clamp(y + by * dy, 0, state.scene->height - 1)});
    if (state.fit == Fit::none) state.view = showing(state.view, *state.pinned, state.area);
}

/// Pins the pixel in the middle of what is seen; where one is pinned, with Shift, it is the second one, too, from which
/// the arrow keys then move away.
void pin_by_key(State& state, const Results&, const KeyPress& press) {
    if (state.pinned) {
        if (press.shift) state.compared = state.pinned;
        return;
    }
    const Pixel middle = state.view.pixel_at({state.area.x / 2, state.area.y / 2});
    pin(state,
        Pixel{std::clamp(middle.x, 0, state.scene->width - 1), std::clamp(middle.y, 0, state.scene->height - 1)});
}

template <bool forward>
void worst_pixel(State& state, const Results& results, const KeyPress&) {
    pin_next_worst(state, results, forward);
}

void unpin(State& state, const Results&, const KeyPress&) {
    if (state.keys_work_buttons) state.keys_work_buttons = false;
    else if (state.tour) leave_tour(state);
    else if (state.keys_shown) state.keys_shown = false;
    else if (state.compared) state.compared.reset();
    else state.pinned.reset();
}

void fit(State& state, const Results&, const KeyPress& press) {
    state.fit = press.shift ? Fit::whole_multiple : Fit::as_fits;
}

void zoom(State& state, double to) {
    state.fit = Fit::none;
    state.view = zoomed_to(state.view, to, state.area);
}

template <StepTo to>
void step(State& state, const Results& results, const KeyPress&) {
    if (!steps_now(state, results).story) return;
    state.page = Page::steps;
    go(state, results, to);
}

/// Does something on the page of steps.
template <void (*act)(State&, const Results&)>
void on_steps(State& state, const Results& results, const KeyPress&) {
    if (!steps_now(state, results).story) return;
    state.page = Page::steps;
    act(state, results);
}

void to_operand(State& state, const Results& results, const KeyPress& press) {
    if (!steps_now(state, results).story) return;
    state.page = Page::steps;
    jump_to_operand(state, results, press.shift);
}

void jump_again(State& state, const Results& results, const KeyPress& press) {
    if (!steps_now(state, results).story) return;
    state.page = Page::steps;
    if (press.shift) jump_forth(state, results);
    else jump_back(state, results);
}

void only_feeding(State& state, const Results& results) { show_only_feeding(state, results, !state.stepping.fed); }

void play(State& state, const Results& results, const KeyPress&) {
    if (!steps_now(state, results).story) return;
    state.page = Page::steps;
    play_or_pause(state, results);
}

void next_failing_test(State& state, const Results& results, const KeyPress& press) {
    state.page = Page::mine;
    look_at_next_failing(state, results, !press.shift);
}

void predict_or_not(State& state, const Results& results, const KeyPress&) {
    state.page = Page::steps;
    set_predicting(state, results, !state.predicting.on);
}

template <int said>
void say(State& state, const Results& results, const KeyPress&) {
    answer(state, results, said);
}

void skip(State& state, const Results& results, const KeyPress&) { answer(state, results, {}); }

bool is_asked(const State& state, const Results& results) {
    return state.page == Page::steps && open_question(state, results);
}

template <Asked what>
bool asks(const State& state, const Results& results) {
    return is_asked(state, results) && open_question(state, results)->asked == what;
}

void change_boxes(State& state, const Results& results, const KeyPress& press) {
    if (press.shift) go_back(state, results);
    else go_deeper(state, results);
}

constexpr double orbit_step = 10;  // degrees

template <int azimuth, int elevation>
void look_from(State& state, const Results&, const KeyPress&) {
    state.orbit.azimuth = std::remainder(state.orbit.azimuth + azimuth * orbit_step, 360);
    state.orbit.elevation =
        std::clamp(state.orbit.elevation + elevation * orbit_step, -greatest_elevation, greatest_elevation);
}

template <int notches>
void come_closer(State& state, const Results&, const KeyPress&) {
    state.orbit = closer(state.orbit, std::pow(1.15, -notches));
}

/// Moves the bars between the window's parts, by steps that are a part of the window.
template <int side, int space>
void resize_parts(State& state, const Results&, const KeyPress&) {
    constexpr float bar_step = .05f;
    state.side_width = std::clamp(state.side_width + bar_step * static_cast<float>(side), .1f, .75f);
    state.space_height = std::clamp(state.space_height + bar_step * static_cast<float>(space), .1f, .8f);
}

template <Page page>
void show_page(State& state, const Results&, const KeyPress&) {
    state.page = page;
}

template <int steps>
void move_split(State& state, const Results&, const KeyPress&) {
    if (state.beside != Beside::nothing) state.split = std::clamp(state.split + .05 * steps, 0.0, 1.0);
}

/// Whether Dear ImGui takes this key to move from button to button, or to press one.
bool is_for_buttons(const KeyPress& press) {
    return !press.control && press.key != Key::character && press.key != Key::escape && press.key != Key::f6;
}

void change_text_size(State& state, float by) {
    float& size = state.appearance.text_size;
    size = std::clamp(size + by, least_text_size, greatest_text_size);
}

constexpr KeyBinding bindings[] = {
    {character('m'), "m", "show your own code's picture beside ours, or hide it", "Picture",
     [](State& s, const Results&, const KeyPress&) { toggle_mine(s); }},
    {character('f'), "F", "fit the whole picture (with Shift: one to one, or by a whole number)", "Picture", fit},
    {character('1'), "1", "one to one", "Picture", [](State& s, const Results&, const KeyPress&) { zoom(s, 1); }},
    {character('+'), "+", "zoom in", "Picture",
     [](State& s, const Results&, const KeyPress&) { zoom(s, s.view.zoom * 2); }},
    {character('-'), "−", "zoom out", "Picture",
     [](State& s, const Results&, const KeyPress&) { zoom(s, s.view.zoom / 2); }},
    {named(Key::left), "←", "move the pin (with Shift by ten pixels)", "Picture", move_pin<-1, 0>},
    {named(Key::right), "→", "", "Picture", move_pin<1, 0>},
    {named(Key::up), "↑", "", "Picture", move_pin<0, -1>},
    {named(Key::down), "↓", "", "Picture", move_pin<0, 1>},
    {character('>'), ">", "move the bar between the two pictures", "Picture", move_split<1>},
    {character('<'), "<", "", "Picture", move_split<-1>},
    {named(Key::enter), "Enter", "pin the pixel in the middle (with Shift: keep this pin as the second one)", "Picture",
     pin_by_key},
    {character('.'), ".", "to the next worst pixel of the overlay", "Picture", worst_pixel<true>},
    {character(','), ",", "and the one before", "Picture", worst_pixel<false>},
    {named(Key::escape), "Esc", "take away the second pin, then the first", "Picture", unpin},

    {character('d'), "d", "turn the view 10° counter-clockwise about z", "View", turn<Axis::z, 10>},
    {character('a'), "a", "and back", "View", turn<Axis::z, -10>},
    {character('w'), "w", "turn the view 10° counter-clockwise about y", "View", turn<Axis::y, 10>},
    {character('s'), "s", "and back", "View", turn<Axis::y, -10>},
    {character('r'), "R", "take back all turns", "View", turn_back},

    {character('b'), "b", "draw the engine's boxes in space, then a level deeper (with Shift: a level back)", "Space",
     change_boxes},
    {character('z'), "z", "fly to the first hit, or back to where all is in sight", "Space",
     [](State& s, const Results&, const KeyPress&) { fly_to_hit_or_back(s); }},
    {named(Key::left, true), "Ctrl+←", "look at the scene in space from elsewhere", "Space", look_from<-1, 0>},
    {named(Key::right, true), "Ctrl+→", "", "Space", look_from<1, 0>},
    {named(Key::up, true), "Ctrl+↑", "", "Space", look_from<0, 1>},
    {named(Key::down, true), "Ctrl+↓", "", "Space", look_from<0, -1>},
    {named(Key::page_up, true), "Ctrl+PgUp", "come closer", "Space", come_closer<1>},
    {named(Key::page_down, true), "Ctrl+PgDn", "go farther away", "Space", come_closer<-1>},
    {named(Key::home, true), "Ctrl+Home", "look at it as at first", "Space",
     [](State& s, const Results&, const KeyPress&) { s.orbit = Orbit{}; }},

    {character('q'), "q", "to the search: how many surfaces were tested and met, and the overlay tests", "Truth",
     [](State& s, const Results& r, const KeyPress&) { open_tile(s, r, TileKind::search); }},
    {character('l'), "l", "to the light: n·l, and its overlay", "Truth",
     [](State& s, const Results& r, const KeyPress&) { open_tile(s, r, TileKind::cosines); }},
    {character('y'), "y", "to the least sure sign, and the overlay margin", "Truth",
     [](State& s, const Results& r, const KeyPress&) { open_tile(s, r, TileKind::margin); }},

    {named(Key::space), "Space", "play the pinned pixel's steps, or pause", "Steps", play},
    {character(']'), "]", "a step forward", "Steps", step<StepTo::forward>},
    {character('['), "[", "a step back", "Steps", step<StepTo::back>},
    {named(Key::home), "Home", "to the first step", "Steps", step<StepTo::first>},
    {named(Key::end), "End", "to the last step", "Steps", step<StepTo::last>},
    {character('i'), "i", "into what the line of the call stack calls", "Steps", on_steps<step_into>},
    {character('o'), "o", "over that line", "Steps", on_steps<step_over>},
    {character('u'), "u", "out of the function", "Steps", on_steps<step_out>},
    {character('e'), "e", "to the step that made the first operand (with Shift: the second)", "Steps", to_operand},
    {character('j'), "j", "back to where you jumped from (with Shift: forth again)", "Steps", jump_again},
    {character('v'), "v", "only the steps that feed this number, or all", "Steps", on_steps<only_feeding>},
    {character('/'), "/", "go through the steps of your own code, or of ours", "Steps",
     [](State& s, const Results&, const KeyPress&) {
         s.page = Page::steps;
         step_mine(s, !s.mine.is_stepped);
     }},
    {character('n'), "n", "to the next no: a condition that does not hold, a miss", "Steps", step<StepTo::next_no>},
    {character('x'), "x", "to what failed next: a wrong answer, a number too large", "Steps",
     step<StepTo::next_failed>},
    {character('c'), "c", "to the next cancellation", "Steps", step<StepTo::next_cancellation>},

    {character('p'), "p", "predict first: be asked before each test, or not", "Steps", predict_or_not},
    {character('h'), "h", "to the question: a hit, a miss", "Steps", say<1>, asks<Asked::hit>},
    {character('m'), "m", "", "Steps", say<0>, asks<Asked::hit>},
    {character('+'), "+", "to the question: the sign", "Steps", say<1>, asks<Asked::sign>},
    {character('-'), "−", "", "Steps", say<-1>, asks<Asked::sign>},
    {character('0'), "0", "", "Steps", say<0>, asks<Asked::sign>},
    {character('k'), "k", "skip the question", "Steps", skip, is_asked},

    {character('t'), "t", "to the next of your tests that fails, and its ray (with Shift: to the one before)", "Mine",
     next_failing_test},
    {character('g'), "g", "back from a test's ray to the scene before", "Mine",
     [](State& s, const Results&, const KeyPress&) { look_back(s); }},

    {control('z'), "Ctrl+Z", "undo a change", "Everything",
     [](State& s, const Results&, const KeyPress&) { s.setup.undo(); }},
    {control('y'), "Ctrl+Y", "redo it", "Everything",
     [](State& s, const Results&, const KeyPress&) { s.setup.redo(); }},
    {control('z', true), "Ctrl+Shift+Z", "redo it, too", "Everything",
     [](State& s, const Results&, const KeyPress&) { s.setup.redo(); }},
    {control('+'), "Ctrl +", "larger text", "Everything",
     [](State& s, const Results&, const KeyPress&) { change_text_size(s, 2); }},
    {control('-'), "Ctrl −", "smaller text", "Everything",
     [](State& s, const Results&, const KeyPress&) { change_text_size(s, -2); }},
    {control('1'), "Ctrl+1", "the page Inspector; the next ones are Steps, Overlay, Controls, Mine", "Everything",
     show_page<Page::inspector>},
    {control('2'), "Ctrl+2", "", "Everything", show_page<Page::steps>},
    {control('3'), "Ctrl+3", "", "Everything", show_page<Page::overlay>},
    {control('4'), "Ctrl+4", "", "Everything", show_page<Page::controls>},
    {control('5'), "Ctrl+5", "", "Everything", show_page<Page::mine>},
    {named(Key::f6), "F6", "let the arrows and the space bar work the buttons, or the picture again", "Everything",
     [](State& s, const Results&, const KeyPress&) { s.keys_work_buttons = !s.keys_work_buttons; }},
    {named(Key::left, true, true), "Ctrl+Shift+←", "move the bars between the window's parts", "Everything",
     resize_parts<1, 0>},
    {named(Key::right, true, true), "Ctrl+Shift+→", "", "Everything", resize_parts<-1, 0>},
    {named(Key::up, true, true), "Ctrl+Shift+↑", "", "Everything", resize_parts<0, 1>},
    {named(Key::down, true, true), "Ctrl+Shift+↓", "", "Everything", resize_parts<0, -1>},
    {control('o'), "Ctrl+O", "open another scene", "Everything",
     [](State& s, const Results&, const KeyPress&) { show_scene_menu(s); }},
    {control('s'), "Ctrl+S", "save the picture, the overlay or its numbers", "Everything",
     [](State& s, const Results&, const KeyPress&) { show_save_menu(s); }},
    {control('c'), "Ctrl+C", "copy the command that shows this again", "Everything",
     [](State& s, const Results&, const KeyPress&) { copy(s, command_to_view(s)); }},
    {control('c', true), "Ctrl+Shift+C", "choose which command to copy", "Everything",
     [](State& s, const Results&, const KeyPress&) { show_copy_menu(s); }},
    {control('q'), "Ctrl+Q", "close the window", "Everything",
     [](State& s, const Results&, const KeyPress&) { s.leaving = true; }},
    {character('?'), "?", "show or hide this list", "Everything",
     [](State& s, const Results&, const KeyPress&) { s.keys_shown = !s.keys_shown; }},
};

/// Shift counts only together with Ctrl: elsewhere it may be needed to type the character, or means "more".
bool is_meant(const KeyBinding& binding, const KeyPress& press) {
    return press.key == binding.press.key && press.character == binding.press.character &&
           press.control == binding.press.control && (!press.control || press.shift == binding.press.shift);
}

/// Makes Ctrl with + independent of the keyboard: on American ones + is Shift with =, and = alone counts, too.
KeyPress without_layout(const KeyPress& press) {
    const bool plus =
        press.key == Key::character && press.control && (press.character == '=' || press.character == '+');
    return plus ? control('+') : press;
}

}  // namespace

std::span<const KeyBinding> key_bindings() { return bindings; }

bool takes_keyboard(const ViewerState& state) {
    return state.scene_menu.shown || state.save_menu.shown || state.copy_menu.shown;
}

void obey(const KeyPress& press, ViewerState& state, const Results& results) {
    if (takes_keyboard(state) && !press.control) {
        if (state.scene_menu.shown) obey_in_scene_menu(press, state);
        else if (state.save_menu.shown) obey_in_save_menu(press, state, results);
        else obey_in_copy_menu(press, state);
        return;
    }
    if (state.keys_work_buttons && is_for_buttons(press)) return;
    const KeyPress meant = without_layout(press);
    for (const bool sometimes : {true, false})
        for (const KeyBinding& binding : bindings)
            if (is_meant(binding, meant) && (sometimes ? binding.when && binding.when(state, results) : !binding.when))
                return binding.act(state, results, press);
}

bool is_obeyed_while_typing(const KeyPress& press) {
    return press.key == Key::f6 || press == control('o') || press == control('q');
}

}  // namespace glassbox
