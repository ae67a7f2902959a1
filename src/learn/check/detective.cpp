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

#include "learn/check/description.hpp"
#include "learn/check/relation.hpp"
#include "output/whole_file.hpp"
#include "scene/text_file.hpp"

namespace glassbox::learn {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

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

/// Whether a mistake's trace of a case is what this case left behind, as far as it came.
bool explains(const Trace& trace, const CaseResult& one) {
    const std::string_view checks = one.missing.empty() ? std::string_view(trace.checks)
                                                        : std::string_view(trace.checks).substr(0, one.checks.size());
    return trace.test == one.name && same_got(got(*one.failure), trace.got) &&
           (trace.checks.empty() || one.checks.empty() || checks == one.checks);
}

}  // namespace

bool same_got(std::string_view a, std::string_view b) {
    while (!a.empty() && !b.empty()) {
        std::string_view after_a = a, after_b = b;
        const auto number_a = take_number(after_a), number_b = take_number(after_b);
        if (number_a && number_b) {
            if (!as_good_as_equal(*number_a, *number_b)) return false;
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
        if (one.failure) traces.push_back({mistake, one.name, got(*one.failure), one.checks});
    return traces;
}

std::vector<std::string> candidates(const TestRun& run, const std::vector<Trace>& known) {
    struct Match {
        bool possible = true;
        int tests = 0;
    };
    std::map<std::string, Match> matches;
    for (const Trace& trace : known) {
        Match& match = matches[trace.mistake];
        const auto here = std::find_if(run.cases.begin(), run.cases.end(),
                                       [&](const CaseResult& one) { return one.name == trace.test; });
        const bool fails = here != run.cases.end() && here->failure;
        if (fails && !here->missing.empty()) continue;
        if (!fails || !explains(trace, *here)) match.possible = false;
        ++match.tests;
    }
    std::vector<std::string> names;
    for (const auto& [name, match] : matches)
        if (match.possible && match.tests > 0) names.push_back(name);
    std::ranges::stable_sort(names, std::greater{}, [&](const std::string& name) { return matches[name].tests; });
    return names;
}

std::vector<Trace> read_traces(const fs::path& file) {
    std::error_code none;
    if (!fs::exists(file, none)) return {};
    std::vector<Trace> traces;
    try {
        for (const Json& one : Json::parse(read_text(file)))
            traces.push_back({one.at("mistake"), one.at("case"), one.at("got"), one.value("checks", std::string())});
    } catch (const Json::exception&) {
        throw error_at({file.string()},
                       "this is not as a tool made it; make it again: glassbox learn mistake N --record");
    }
    return traces;
}

std::string written(const std::vector<Trace>& traces) {
    std::string text = "[";
    for (const Trace& trace : traces)
        text += fmt::format(
            "{}\n{}", &trace == traces.data() ? "" : ",",
            Json{{"mistake", trace.mistake}, {"case", trace.test}, {"got", trace.got}, {"checks", trace.checks}}.dump(
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
            request.double_first = true;
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
    const std::vector<std::string> names = candidates(run, known);
    const std::vector<Mistake> mistakes = read_mistakes(exercise);
    const auto words_of = [&](const std::string& name) {
        const auto mistake = std::ranges::find(mistakes, name, &Mistake::name);
        return mistake == mistakes.end() ? std::string() : mistake->looks_like;
    };
    const auto explained = [&](const CaseResult& one, const std::string& name) {
        return std::ranges::any_of(known,
                                   [&](const Trace& trace) { return trace.mistake == name && explains(trace, one); });
    };
    // A mistake is recorded in double, and in other scalars only if double is right.
    const auto is_recorded = [&](const CaseResult& one, const std::string& name) {
        const std::string_view scalar = name_and_scalar(one.name).second;
        return scalar != "long double" && (scalar != "float" || std::ranges::any_of(known, [&](const Trace& trace) {
                                               return trace.mistake == name &&
                                                      name_and_scalar(trace.test).second == "float";
                                           }));
    };
    // Whether every failure of a function is explained by one of two mistakes.
    const auto explain_all = [&](const Function* function, const std::string& one, const std::string& other) {
        return std::ranges::all_of(run.cases, [&](const CaseResult& result) {
            return !result.failure || !result.missing.empty() || !is_recorded(result, one) ||
                   function_tested_by(exercise, result.name) != function || explained(result, one) ||
                   explained(result, other);
        });
    };

    const CaseResult* const shown = judgement.shown;
    const bool fails = shown && shown->failure && shown->failure->not_written().empty();
    // The mistake that explains what is shown, and with it, alone or with another one, all that the function fails.
    const auto first_found = [&]() -> Recognised {
        std::vector<std::string> possible;
        for (const std::string& one : names)
            if (fails && explained(*shown, one)) possible.push_back(one);
        for (const std::string& one : possible)
            if (explain_all(judgement.function, one, one)) return {one, {}, {}, {}, {}};
        for (const std::string& one : possible)
            for (const std::string& other : names)
                if (one != other && explain_all(judgement.function, one, other)) return {one, {}, other, {}, {}};
        return {};
    };
    Recognised found = first_found();
    // Of two mistakes, the second may be in another function: it is named if it explains all that is wrong there.
    for (const std::string& one : names) {
        const Function* made_in = function_of(one, known, exercise);
        if (!found.also.empty() || made_in == judgement.function || !made_in) continue;
        const bool is_news = std::ranges::any_of(run.cases, [&](const CaseResult& result) {
            return result.failure && explained(result, one) && !explained(result, found.name);
        });
        if (is_news && explain_all(made_in, one, found.name)) found.also = one;
    }
    found.looks_like = words_of(found.name);
    if (found.looks_like.empty()) found.name.clear();
    found.also_looks_like = words_of(found.also);
    const Function* also_in = found.also.empty() ? nullptr : function_of(found.also, known, exercise);
    if (also_in && also_in != judgement.function)
        found.also_looks_like = fmt::format("In `{}`: {}", also_in->name, found.also_looks_like);
    if (found.name.empty()) found.description = description(exercise, run, judgement);
    return found;
}

}  // namespace glassbox::learn
