#include "viewer/model/state/keys.hpp"

#include <algorithm>

#include "viewer/model/space/boxes_in_space.hpp"
#include "viewer/model/state/command.hpp"
#include "viewer/model/state/playing.hpp"
#include "viewer/model/story/predicting.hpp"

namespace glassbox {

namespace {

using State = ViewerState;

constexpr KeyPress character(char32_t c) { return {Key::character, c, false, false}; }
constexpr KeyPress control(char32_t c, bool shift = false) { return {Key::character, c, true, shift}; }
constexpr KeyPress named(Key key) { return {key, 0, false, false}; }

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
    if (!state.fit) state.view = showing(state.view, *state.pinned, state.area);
}

void unpin(State& state, const Results&, const KeyPress&) {
    if (state.keys_shown) state.keys_shown = false;
    else if (state.compared) state.compared.reset();
    else state.pinned.reset();
}

void fit(State& state, const Results&, const KeyPress&) { state.fit = true; }

void zoom(State& state, double to) {
    state.fit = false;
    state.view = zoomed_to(state.view, to, state.area);
}

template <StepTo to>
void step(State& state, const Results& results, const KeyPress&) {
    if (!results.story) return;
    state.playing = false;
    state.page = Page::steps;
    state.step = stepped(steps_shown(state, results), state.step, to);
}

void play(State& state, const Results& results, const KeyPress&) {
    if (!results.story) return;
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

void change_text_size(State& state, float by) {
    float& size = state.appearance.text_size;
    size = std::clamp(size + by, least_text_size, greatest_text_size);
}

constexpr KeyBinding bindings[] = {
    {character('m'), "m", "show your own code's picture beside ours, or hide it", "Picture",
     [](State& s, const Results&, const KeyPress&) { toggle_mine(s); }},
    {character('f'), "F", "fit the whole picture", "Picture", fit},
    {character('1'), "1", "one to one", "Picture", [](State& s, const Results&, const KeyPress&) { zoom(s, 1); }},
    {character('+'), "+", "zoom in", "Picture",
     [](State& s, const Results&, const KeyPress&) { zoom(s, s.view.zoom * 2); }},
    {character('-'), "−", "zoom out", "Picture",
     [](State& s, const Results&, const KeyPress&) { zoom(s, s.view.zoom / 2); }},
    {named(Key::left), "←", "move the pin (with Shift by ten pixels)", "Picture", move_pin<-1, 0>},
    {named(Key::right), "→", "", "Picture", move_pin<1, 0>},
    {named(Key::up), "↑", "", "Picture", move_pin<0, -1>},
    {named(Key::down), "↓", "", "Picture", move_pin<0, 1>},
    {named(Key::escape), "Esc", "take away the second pin, then the first", "Picture", unpin},

    {character('d'), "d", "turn the view 10° counter-clockwise about z", "View", turn<Axis::z, 10>},
    {character('a'), "a", "and back", "View", turn<Axis::z, -10>},
    {character('w'), "w", "turn the view 10° counter-clockwise about y", "View", turn<Axis::y, 10>},
    {character('s'), "s", "and back", "View", turn<Axis::y, -10>},
    {character('r'), "R", "take back all turns", "View", turn_back},

    {character('b'), "b", "draw the engine's boxes in space, then a level deeper (with Shift: a level back)", "Space",
     change_boxes},

    {named(Key::space), "Space", "play the pinned pixel's steps, or pause", "Steps", play},
    {character(']'), "]", "a step forward", "Steps", step<StepTo::forward>},
    {character('['), "[", "a step back", "Steps", step<StepTo::back>},
    {named(Key::home), "Home", "to the first step", "Steps", step<StepTo::first>},
    {named(Key::end), "End", "to the last step", "Steps", step<StepTo::last>},
    {character('n'), "n", "to the next failed test", "Steps", step<StepTo::next_failed>},
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
    const KeyPress meant = without_layout(press);
    for (const bool sometimes : {true, false})
        for (const KeyBinding& binding : bindings)
            if (is_meant(binding, meant) && (sometimes ? binding.when && binding.when(state, results) : !binding.when))
                return binding.act(state, results, press);
}

}  // namespace glassbox
