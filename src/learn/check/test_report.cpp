#include "learn/check/test_report.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string_view>

#include "scene/printable.hpp"
#include "scene/text_file.hpp"

namespace glassbox::learn {
namespace {

using Json = nlohmann::ordered_json;

/// Parses a line as JSON with the nonce; null for anything else. JSON must be UTF-8: each other byte becomes '?'.
Json parsed(std::string line, const std::string& nonce) {
    while (const auto bad = first_not_utf8(line)) line[*bad] = '?';
    Json json = Json::parse(line, nullptr, false);
    const bool ours = json.is_object() && json.value("nonce", Json()) == nonce && json.contains("is");
    return ours ? json : Json();
}

/// Reads numbers, some of which JSON has as texts: "nan", "-inf".
std::vector<double> numbers(const Json& json, const char* name) {
    std::vector<double> all;
    if (const auto list = json.find(name); list != json.end() && list->is_array())
        for (const Json& one : *list)
            all.push_back(one.is_string() ? std::strtod(one.get<std::string>().c_str(), nullptr) : one.get<double>());
    return all;
}

std::vector<Input> inputs(const Json& json) {
    std::vector<Input> all;
    if (const auto named = json.find("inputs"); named != json.end())
        for (const auto& [name, value] : named->items()) all.push_back({name, numbers(*named, name.c_str())});
    return all;
}

CheckMade check_from(const Json& json) {
    return {json.value("case", std::string()),
            json.value("line", std::size_t{0}),
            json.value("passed", false),
            json.value("condition", false),
            printable_lines(json.value("expression", std::string())),
            numbers(json, "expected"),
            numbers(json, "got"),
            inputs(json),
            numbers(json, "ray"),
            numbers(json, "surface")};
}

/// Makes what a learner's code put into its exceptions and numbers printable.
Failure failure_from(const Json& json) {
    Failure failure;
    const auto text = [&](const char* name) { return printable_lines(json.value(name, std::string())); };
    const auto texts = [&](const char* name) {
        auto all = json.value(name, std::vector<std::string>{});
        for (std::string& one : all) one = printable_lines(one);
        return all;
    };
    failure.file = text("file");
    failure.line = json.value("line", std::size_t{0});
    failure.expression = text("expression");
    failure.expected = text("expected");
    failure.got = text("got");
    failure.negated = json.value("negated", false);
    failure.ulps = text("ulps");
    failure.threw = text("threw");
    failure.contexts = texts("contexts");
    failure.subcases = texts("subcases");
    failure.inputs = inputs(json);
    failure.ray = numbers(json, "ray");
    failure.surface = numbers(json, "surface");
    if (failure.expected.empty() && failure.threw.empty() && (failure.got == "true" || failure.got == "false"))
        failure.expected = failure.got == "true" ? "false" : "true";
    return failure;
}

/// Returns how the program died, in words, and the same for the detective.
std::pair<std::string, std::string> death(const Outcome& outcome) {
    std::string words = how_it_ended(outcome);
    if (words.empty()) words = "it ended the program (by _exit, perhaps) before its work was done";
    const int signal = outcome.end == End::signal ? outcome.status : 0;
    return {words, fmt::format("died {} {}", static_cast<int>(outcome.end), signal)};
}

}  // namespace

Report read_report(const std::string& text, const std::string& nonce, const Outcome& outcome) {
    Report report;
    bool running = false, done = false, foreign = false;
    for (std::size_t start = 0; start < text.size();) {
        const std::size_t end = std::min(text.find('\n', start), text.size());
        const Json json = parsed(text.substr(start, end - start), nonce);
        start = end + 1;
        if (json.is_null()) {
            foreign = true;
            continue;
        }
        const std::string what = json["is"];
        if (what == "case") {
            report.cases.push_back({json.value("name", std::string())});
            running = true;
        } else if (what == "wrong" && running) {
            report.cases.back().failure = failure_from(json);
        } else if (what == "end" && running) {
            running = false;
            report.cases.back().checks = json.value("checks", std::string());
            report.cases.back().missing = function_not_written(json.value("threw", std::string()));
            if (!json.value("passed", false) && !report.cases.back().failure) report.cases.back().failure = Failure{};
        } else if (what == "check") {
            report.checks.push_back(check_from(json));
        } else if (what == "done") {
            done = true;
        }
    }
    const bool ended_well = done && outcome.end == End::exited && outcome.last_words.kind == LastWords::finished;
    if (!ended_well) {
        const auto [words, for_the_detective] = death(outcome);
        if (running) {
            auto& failure = report.cases.back().failure;
            if (!failure || failure->not_written().empty()) failure.emplace();
            failure->died = words;
            failure->death = for_the_detective;
        } else if (outcome.end == End::stopped) {
            report.disturbed = words;
        } else if (!foreign) {
            report.disturbed = fmt::format("between the tests the program came to its end: {}", words);
        }
    }
    if (foreign)
        report.disturbed = "something else than the tests wrote into their report, so that it cannot be trusted";
    return report;
}

}  // namespace glassbox::learn
