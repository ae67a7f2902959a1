#include <fmt/format.h>

#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "render/parameters.hpp"
#include "render/typed.hpp"
#include "scene/suggestion.hpp"
#include "viewer/model/overlay/subtracted.hpp"
#include "viewer/model/story/predicting.hpp"
#include "viewer/script/commands.hpp"

namespace glassbox::script {

namespace {

constexpr NameTable<bool, 2> themes{{{"dark", true, ""}, {"light", false, ""}}};
constexpr NameTable<bool, 2> ways_to_turn{{{"accumulated", true, ""}, {"rebuilt", false, ""}}};
constexpr NameTable<bool, 2> count_axes{{{"log", true, ""}, {"linear", false, ""}}};
constexpr NameTable<StepsPane, 4> step_panes{{
    {"source", StepsPane::source, ""},
    {"formula", StepsPane::formula, ""},
    {"losses", StepsPane::losses, ""},
    {"nudge", StepsPane::nudge, ""},
}};
constexpr NameTable<NumberForm, 3> number_forms{{
    {"short", NumberForm::brief, ""},
    {"full", NumberForm::full, ""},
    {"hex", NumberForm::hex, ""},
}};

constexpr NameTable<bool, 2> whose_steps{{{"ours", false, ""}, {"mine", true, ""}}};

using Word = const std::string&;

/// What `set NAME VALUE` can set.
struct Settable {
    std::string_view name;
    std::function<Command(Word name, Word typed)> read;
};

/// Sets `member(state)` to what `read(name, typed)` returns.
template <class Read, class Member>
Settable settable(std::string_view its_name, const Read& read, const Member& member) {
    return {its_name, [read, member](Word name, Word typed) {
                return change([member, value = read(name, typed)](ViewerState& state) {
                    auto& changed = member(state);
                    changed = static_cast<std::remove_reference_t<decltype(changed)>>(value);
                });
            }};
}

/// Reads one of a table's names.
template <class Table>
auto one_of(const Table& table) {
    return [&table](Word name, Word typed) { return chosen(name, typed, table); };
}

/// Reads a number from `least` to `most`.
auto from_to(double least, double most) {
    return [least, most](Word name, Word typed) { return number(name, typed, least, most); };
}

/// What is no part of the setup.
const Settable settables[] = {
    settable(
        "other-scalar", one_of(scalars), [](ViewerState& s) -> auto& { return s.other.scalar; }),
    settable(
        "other-triangle", triangle_rule, [](ViewerState& s) -> auto& { return s.other.triangle_rule; }),
    settable(
        "other-sphere", one_of(sphere_rules), [](ViewerState& s) -> auto& { return s.other.sphere_rule; }),
    settable(
        "theme", one_of(themes), [](ViewerState& s) -> auto& { return s.appearance.dark; }),
    settable(
        "text-size", from_to(least_text_size, greatest_text_size),
        [](ViewerState& s) -> auto& { return s.appearance.text_size; }),
    settable(
        "numbers", one_of(number_forms), [](ViewerState& s) -> auto& { return s.number_form; }),
    settable(
        "step-pane", one_of(step_panes), [](ViewerState& s) -> auto& { return s.stepping.pane; }),
    settable(
        "space", one_of(switches), [](ViewerState& s) -> auto& { return s.space_shown; }),
    settable(
        "split", from_to(0, 1), [](ViewerState& s) -> auto& { return s.split; }),
    {"lesson",
     [](Word name, Word typed) {
         const std::optional<LessonChoice> lessons = read_lesson_choice(typed);
         if (!lessons) throw wrong(name, fmt::format("'{}' must be the number of a lesson, or all", typed));
         return change([lessons](ViewerState& s) { show_mine(s, lessons); });
     }},
    {"steps-of",
     [](Word name, Word typed) {
         return change([mine = chosen(name, typed, whose_steps)](ViewerState& s) { step_mine(s, mine); });
     }},
    {"predict",
     [](Word name, Word typed) {
         return change([on = chosen(name, typed, switches)](ViewerState& s, const Results& results) {
             set_predicting(s, results, on);
         });
     }},
    settable(
        "opacity", from_to(0, 1), [](ViewerState& s) -> auto& { return s.overlay.opacity; }),
    settable(
        "legend", one_of(switches), [](ViewerState& s) -> auto& { return s.overlay.legend_shown; }),
    {"overlay-minus",
     [](Word name, Word typed) {
         const std::optional<Minus> other = typed == "nothing" ? std::nullopt : std::optional(minus(name, typed));
         return change([other](ViewerState& s) { subtract(s.overlay, other); });
     }},
    {"scale",
     [](Word name, Word typed) {
         const SetSpacing spacing = typed == "auto" ? SetSpacing{} : chosen(name, typed, spacings);
         return change([spacing](ViewerState& s) { s.overlay.spacing = spacing; });
     }},
    settable(
        "counts", one_of(count_axes), [](ViewerState& s) -> auto& { return s.overlay_page.log_counts; }),
    settable(
        "side-width", from_to(.1, .75), [](ViewerState& s) -> auto& { return s.side_width; }),
    settable(
        "space-height", from_to(.1, .8), [](ViewerState& s) -> auto& { return s.space_height; }),
};

/// All that `set` can set; the view's parameters have commands of their own.
std::vector<Settable> all_settables() {
    std::vector<Settable> all;
    const auto add = [&](Subject subject) {
        for (const Parameter& parameter : parameters())
            if (parameter.subject == subject && is_offered(parameter))
                all.push_back({parameter.name, [&](Word name, Word typed) {
                                   return change_setup(
                                       [&parameter, from = with_typed({}, parameter, name, typed)](Setup& setup) {
                                           setup = taken_over(std::move(setup), parameter, from);
                                       });
                               }});
    };
    add(Subject::shading);
    all.push_back({"turns", [](Word name, Word typed) {
                       return change_setup([added = chosen(name, typed, ways_to_turn)](Setup& setup) {
                           setup.options.accumulated = added;
                       });
                   }});
    add(Subject::computing);
    all.insert(all.end(), std::begin(settables), std::end(settables));
    return all;
}

}  // namespace

Command set(const Words& words) {
    std::vector<std::string_view> names;
    for (const auto& [name, read] : all_settables()) {
        if (words[1] == name) return read(words[1], words[2]);
        names.push_back(name);
    }
    throw wrong("set", fmt::format("'{}' is not known; {}", words[1], suggestion(words[1], names)));
}

}  // namespace glassbox::script
