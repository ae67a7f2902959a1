#include "viewer/model/work/failing_test.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <span>

#include "output/whole_file.hpp"
#include "render/parameters.hpp"
#include "render/typed.hpp"
#include "scene/error.hpp"
#include "viewer/model/state/state.hpp"
#include "viewer/model/work/results.hpp"

namespace glassbox {

namespace {

/// "the-normal-points-outwards"
std::string file_name(const std::string& test) {
    std::string name;
    for (const char c : test) {
        const bool is_plain = std::isalnum(static_cast<unsigned char>(c)) != 0 && static_cast<unsigned char>(c) < 128;
        if (is_plain) name += c;
        else if (!name.empty() && name.back() != '-') name += '-';
    }
    constexpr std::size_t longest = 80;
    return name.substr(0, longest);
}

Setup by_rule_of(Setup setup, const learn::ToldRay& ray) {
    for (const Parameter& parameter : parameters())
        if (!ray.option.empty() && parameter.name == ray.option)
            setup = with_typed(std::move(setup), parameter, ray.option, ray.rule);
    return setup;
}

void open_ray(ViewerState& state, const learn::ToldCase& test) {
    const learn::Workspace& workspace = *state.mine.workspace;
    const std::filesystem::path file =
        learn::make_folder(workspace.hidden() / "failing") / (file_name(test.name) + ".toml");
    write_whole(file, std::as_bytes(std::span(test.ray->toml)));
    const std::filesystem::path before = state.looked_at ? state.looked_at->before : state.file;
    open(state, file);
    if (!state.file_error.empty()) return;
    state.setup.change(by_rule_of(state.setup.now(), *test.ray));
    pin(state, test.ray->pixel);
    state.split = 0.4;  // the pin lies in the middle, and the split's handle would hide it
    state.looked_at = LookedAt{test.name, test.rows, before};
}

}  // namespace

void look_at(ViewerState& state, const learn::ToldCase& test) {
    state.mine.test = test.name;
    if (!test.ray) return;
    try {
        open_ray(state, test);
    } catch (const Error& error) {  // the disk is full
        state.file_error = error.what();
    }
}

void look_at_next_failing(ViewerState& state, const Results& results, bool forward) {
    if (!results.tests) return;
    std::vector<const learn::ToldCase*> failing;
    for (const learn::ToldFunction& function : results.tests->functions)
        for (const learn::ToldCase& test : function.cases)
            if (test.state == learn::State::failing) failing.push_back(&test);
    if (failing.empty()) return;
    if (!forward) std::reverse(failing.begin(), failing.end());
    auto next = std::find_if(failing.begin(), failing.end(),
                             [&](const learn::ToldCase* test) { return test->name == state.mine.test; });
    if (next != failing.end()) ++next;
    look_at(state, next == failing.end() ? *failing.front() : **next);
}

void look_back(ViewerState& state) {
    if (state.looked_at) open(state, std::filesystem::path(state.looked_at->before));
}

std::vector<learn::ToldRow> expected_and_got(const std::vector<learn::ToldRow>& rows) {
    std::vector<learn::ToldRow> both;
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(both), [](const learn::ToldRow& row) {
        return row.name == "checked" || row.name == "expected" || row.name == "got" || row.name == "off by" ||
               row.name == "threw" || row.name == "died";
    });
    return both;
}

}  // namespace glassbox
