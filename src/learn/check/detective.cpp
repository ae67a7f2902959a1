#include "learn/check/detective.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cmath>
#include <future>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <tuple>

#include "output/whole_file.hpp"
#include "scene/text_file.hpp"

namespace glassbox::learn {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr double as_good_as_equal = 1e-6;

/// Strips the parenthesis from "0.5 (0x1p-1)": it is the same number again.
std::string without_hexadecimals(std::string text) {
    for (std::size_t open = text.find(" ("); open != std::string::npos; open = text.find(" (", open + 1)) {
        const std::size_t close = text.find(')', open);
        const bool hexadecimal = text.compare(open + 2, 2, "0x") == 0 || text.compare(open + 2, 3, "-0x") == 0;
        if (hexadecimal && close != std::string::npos) text.erase(open, close + 1 - open);
    }
    return text;
}

std::string got(const Failure& failure) {
    if (!failure.died.empty()) return failure.death;
    if (!failure.threw.empty()) return "threw " + failure.threw;
    return fmt::format("{}: {}", failure.expression, without_hexadecimals(failure.got));
}

/// Takes a number off the front of a text and returns it; none if there is none.
std::optional<double> take_number(std::string_view& text) {
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{}) return {};
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return number;
}

/// Returns the function that is looked at first if this is the only mistake: the first that one of its tests finds
/// wrong.
const Function* function_of(const std::string& mistake, const std::vector<Trace>& known, const Exercise& exercise) {
    const Function* first = nullptr;
    for (const Trace& trace : known) {
        const Function* function = trace.mistake == mistake ? function_tested_by(exercise, trace.test) : nullptr;
        if (function && (!first || function < first)) first = function;
    }
    return first;
}

bool close(double a, double b) {
    return a == b || (std::isnan(a) && std::isnan(b)) ||
           std::abs(a - b) <= as_good_as_equal * std::max(std::abs(a), std::abs(b));
}

}  // namespace

bool same_got(std::string_view a, std::string_view b) {
    while (!a.empty() && !b.empty()) {
        std::string_view after_a = a, after_b = b;
        const auto number_a = take_number(after_a), number_b = take_number(after_b);
        if (number_a && number_b) {
            if (!close(*number_a, *number_b)) return false;
            a = after_a, b = after_b;
        } else {
            if (a.front() != b.front()) return false;
            a.remove_prefix(1), b.remove_prefix(1);
        }
    }
    return a.empty() && b.empty();
}

std::vector<Trace> traces_of(const std::string& mistake, const TestRun& run) {
    std::vector<Trace> traces;
    for (const CaseResult& one : run.cases)
        if (one.failure) traces.push_back({mistake, one.name, got(*one.failure)});
    return traces;
}

std::string looks_like(const TestRun& run, const std::vector<Trace>& known, const CaseResult* shown) {
    struct Match {
        bool possible = true, is_shown = false;
        int tests = 0;
    };
    std::map<std::string, Match> matches;
    for (const Trace& trace : known) {
        Match& match = matches[trace.mistake];
        const auto here = std::find_if(run.cases.begin(), run.cases.end(),
                                       [&](const CaseResult& one) { return one.name == trace.test; });
        const bool fails = here != run.cases.end() && here->failure;
        if (fails && !here->failure->not_written().empty()) continue;
        if (!fails || !same_got(got(*here->failure), trace.got)) match.possible = false;
        match.is_shown |= shown && trace.test == shown->name;
        ++match.tests;
    }
    std::string best;
    Match of_best;
    for (const auto& [name, match] : matches) {
        if (!match.possible || std::tie(match.is_shown, match.tests) <= std::tie(of_best.is_shown, of_best.tests))
            continue;
        best = name;
        of_best = match;
    }
    return best;
}

std::vector<Trace> read_traces(const fs::path& file) {
    std::error_code none;
    if (!fs::exists(file, none)) return {};
    std::vector<Trace> traces;
    try {
        for (const Json& one : Json::parse(read_text(file)))
            traces.push_back({one.at("mistake"), one.at("case"), one.at("got")});
    } catch (const Json::exception&) {
        throw error_at({file.string()},
                       "this is not as a tool made it; make it again: glassbox learn mistake N --record");
    }
    return traces;
}

std::string written(const std::vector<Trace>& traces) {
    std::string text = "[";
    for (const Trace& trace : traces)
        text += fmt::format("{}\n{}", &trace == traces.data() ? "" : ",",
                            Json{{"mistake", trace.mistake}, {"case", trace.test}, {"got", trace.got}}.dump(
                                -1, ' ', false, Json::error_handler_t::replace));
    return text + "\n]\n";
}

void make_mistaken_headers(const Workspace& workspace, const Exercise& exercise, const Mistake& mistake,
                           const fs::path& folder) {
    std::error_code none;
    fs::remove_all(folder, none);
    make_folder(folder);
    for (const std::string& header : exercise.headers) {
        std::string text = read_text(workspace.solution(exercise, header));
        if (header == mistake.header) text = with_mistake(text, mistake);
        write_whole(folder / header, std::as_bytes(std::span(text)));
    }
}

std::vector<Trace> traces_of_all(const Workspace& workspace, const Exercise& exercise, const Toolchain& tools,
                                 const std::function<void(const Mistake&, const TestRun&)>& done,
                                 const std::stop_token& stop) {
    const std::vector<Mistake> mistakes = read_mistakes(exercise);
    std::vector<std::vector<Trace>> found(mistakes.size());
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        for (std::size_t i = next++; i < mistakes.size() && !stop.stop_requested(); i = next++) {
            const fs::path folder = workspace.hidden() / "mistakes" / exercise.name / mistakes[i].name;
            make_mistaken_headers(workspace, exercise, mistakes[i], folder / "headers");
            TestRequest request{folder / "headers", folder};
            request.at_once = false;
            const TestRun run = run_tests(workspace, exercise, tools, request, stop);
            found[i] = traces_of(mistakes[i].name, run);
            done(mistakes[i], run);
        }
    };
    auto other = std::async(std::launch::async, work);
    work();
    other.get();
    std::vector<Trace> all;
    for (const std::vector<Trace>& some : found) all.insert(all.end(), some.begin(), some.end());
    std::sort(all.begin(), all.end(),
              [](const Trace& a, const Trace& b) { return std::tie(a.mistake, a.test) < std::tie(b.mistake, b.test); });
    return all;
}

Recognised recognised(const Exercise& exercise, const TestRun& run, const Judgement& judgement) {
    const std::vector<Trace> known = read_traces(exercise.lesson / "mistakes.json");
    const std::string name = looks_like(run, known, judgement.shown);
    if (name.empty()) return {};
    const std::vector<Mistake> mistakes = read_mistakes(exercise);
    const auto mistake = std::ranges::find(mistakes, name, &Mistake::name);
    if (mistake == mistakes.end()) return {};
    const Function* made_in = function_of(name, known, exercise);
    if (!made_in || made_in == judgement.function) return {name, mistake->looks_like};
    return {name, fmt::format("In `{}`, not in the failure above: {}", made_in->name, mistake->looks_like)};
}

}  // namespace glassbox::learn
