#include "learn/check/description.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "learn/check/facts.hpp"
#include "learn/check/relation.hpp"
#include "scene/suggestion.hpp"

namespace glassbox::learn {
namespace {

using Checks = std::vector<const CheckMade*>;

Checks those(const Checks& checks, const auto& are) {
    Checks some;
    std::ranges::copy_if(checks, std::back_inserter(some), [&](const CheckMade* one) { return are(*one); });
    return some;
}

Checks wrong_ones(const Checks& checks) {
    return those(checks, [](const CheckMade& one) { return !one.passed; });
}

/// What is so of the arguments of some checks, of how many, and of which.
struct Row {
    Fact fact;
    std::size_t known = 0;
    bool is_so_of_the_wrong = true;  ///< and not of the right ones
    bool is_so_of_the_right = true;  ///< the other way round
};

/// Facts that tell the wrong checks from the right ones, and may be said: that hold of all, or of none, that are wrong,
/// and the other way round of all that are right. Each side must have enough inputs, since with few of them some fact
/// always does so by chance.
std::string about_places(const Checks& checks, std::string_view function) {
    std::vector<Row> rows;
    std::map<std::string, std::size_t> place;
    std::set<std::string> inputs_of_wrong, inputs_of_right;
    std::size_t wrong = 0;
    for (const CheckMade* one : checks) {
        const std::optional<OwnCall> call = own_call(*one, function);
        if (!call || call->arguments.empty()) return "";
        std::string inputs;
        for (const Input& argument : call->arguments) inputs += fmt::format("{};", fmt::join(argument.numbers, ","));
        (one->passed ? inputs_of_right : inputs_of_wrong).insert(std::move(inputs));
        wrong += one->passed ? 0 : 1;
        for (Fact& fact : facts_of(call->arguments)) {
            const auto [found, is_new] = place.emplace(fact.yes, rows.size());
            if (is_new) rows.push_back({fact});
            Row& row = rows[found->second];
            ++row.known;
            row.is_so_of_the_wrong &= fact.holds != one->passed;
            row.is_so_of_the_right &= fact.holds == one->passed;
        }
    }
    constexpr std::size_t enough = 5;
    const bool enough_wrong = inputs_of_wrong.size() >= enough, enough_right = inputs_of_right.size() >= enough;
    if (wrong == 0 || wrong == checks.size()) return "";
    for (const Row& row : rows) {
        const Fact& fact = row.fact;
        if (row.known != checks.size() || (!row.is_so_of_the_wrong && !row.is_so_of_the_right)) continue;
        const bool may_be_wrong = enough_wrong || (fact.is_special && row.is_so_of_the_wrong);
        const bool may_be_right = enough_right || (fact.is_special && row.is_so_of_the_right);
        if (!may_be_wrong || !may_be_right) continue;
        const auto& [where, elsewhere] =
            row.is_so_of_the_wrong ? std::pair(fact.yes, fact.no) : std::pair(fact.no, fact.yes);
        return fmt::format("It is wrong wherever {} ({}), and right wherever {} ({}).", where, counted(wrong, "check"),
                           elsewhere, checks.size() - wrong);
    }
    return "";
}

/// Which member of the answer is wrong, if it is one alone, and others are right.
std::string about_members(const Checks& checks) {
    const Checks wrong = wrong_ones(checks);
    if (wrong.empty()) return "";
    const std::string member = member_checked(*wrong[0]);
    const auto is_of_it = [&](const CheckMade& one) { return member_checked(one) == member; };
    const Checks of_it = those(checks, is_of_it);
    if (member.empty() || of_it.size() == checks.size() || those(wrong, is_of_it).size() != wrong.size()) return "";
    if (of_it.size() == 1) return fmt::format("It is the one check of `{}`.", member);
    return wrong.size() == of_it.size()
               ? fmt::format("Those are the {} of `{}`.", counted(of_it.size(), "check"), member)
           : wrong.size() == 1
               ? fmt::format("It is one of the {} of `{}`.", counted(of_it.size(), "check"), member)
               : fmt::format("All of them are among the {} of `{}`.", counted(of_it.size(), "check"), member);
}

/// "Every wrong number is half of what is expected."
std::string about_numbers(const Checks& wrong, std::string_view function) {
    const std::string words = relation_of(wrong, function);
    if (words.empty()) return "";
    return fmt::format("{} {} {}", wrong.size() > 1 ? "every wrong" : "the wrong",
                       wrong[0]->got.size() == 3 ? "vector" : "number", words);
}

/// "Every wrong answer is no, where yes is right", of a function that answers so, if both answers were asked for.
std::string about_conditions(const Checks& checks, std::string_view function) {
    const auto is_right = [](const CheckMade& one, double answer) {
        return one.expected.size() == 1 && one.expected[0] == answer;
    };
    if (!std::ranges::all_of(checks, [&](const CheckMade* one) {
            const auto call = own_call(*one, function);
            return one->is_condition && call && call->is_whole_answer;
        }))
        return "";
    const Checks wrong = wrong_ones(checks);
    for (const double answer : {1.0, 0.0}) {
        const auto is_this = [&](const CheckMade& one) { return is_right(one, answer); };
        const auto is_other = [&](const CheckMade& one) { return is_right(one, 1 - answer); };
        if (wrong.empty() || those(wrong, is_this).size() != wrong.size() || those(checks, is_other).empty()) continue;
        return fmt::format("{} wrong answer is {}.", wrong.size() > 1 ? "Every" : "The",
                           answer == 1 ? "no, where yes is right" : "yes, where no is right");
    }
    return "";
}

/// Whether there were more checks than those: of each line of a test, only so many are kept.
bool are_not_all(const Checks& kept) {
    std::map<std::tuple<std::string_view, std::size_t, bool>, int> counts;
    return std::ranges::any_of(kept, [&](const CheckMade* one) {
        return ++counts[{one->test, one->line, one->passed}] == most_checks_kept;
    });
}

std::string about_counts(const Checks& checks, std::size_t wrong, const Function* function) {
    const std::string of = function ? fmt::format(" of `{}`", function->name) : "";
    const std::string all = counted(checks.size(), "check") + of, fail = wrong == 1 ? "fails" : "fail";
    if (wrong < checks.size())
        return are_not_all(checks) ? fmt::format("Of {}, {} {}.", all, wrong, fail)
                                   : fmt::format("{} of {} {}.", wrong, all, fail);
    if (are_not_all(checks)) return fmt::format("All checks{} fail.", of);
    return wrong == 1 ? fmt::format("The one check{} fails.", of) : fmt::format("All {} fail.", all);
}

std::string as_sentence(std::string words) {
    words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
    return words + '.';
}

/// What the wrong answers have in common: all of the function's, or those of the check that is shown.
std::string about_answers(const Checks& all, const Checks& of_shown, const Function& function) {
    const bool answers_yes_or_no =
        function.returns == "bool" || function.returns.starts_with("Truth<");  // and no std::optional, which is nothing
    if (std::string words = answers_yes_or_no ? about_conditions(all, function.name) : ""; !words.empty()) return words;
    const auto in_common = [&](const Checks& checks) -> std::string {
        for (const std::size_t count : {std::size_t{3}, std::size_t{1}}) {  // vectors, numbers
            const Checks wrong = those(checks, [&](const CheckMade& one) {
                return !one.passed && !one.is_condition && one.got.size() == count;
            });
            if (std::string words = about_numbers(wrong, function.name); !words.empty()) return words;
        }
        return "";
    };
    if (std::string words = in_common(all); !words.empty()) return as_sentence(words);
    const std::string words = in_common(of_shown);
    return words.empty() ? "" : fmt::format("In the check above {}.", words);
}

/// The tests of the function that fail, and those that pass, by name.
std::string about_tests(const Exercise& exercise, const TestRun& run, const Judgement& judgement,
                        std::string_view scalar) {
    std::vector<std::string> right, wrong;
    for (const CaseResult& one : run.cases) {
        const auto [name, its] = name_and_scalar(one.name);
        if (function_tested_by(exercise, one.name) != judgement.function || its != scalar) continue;
        if (one.failure && !one.failure->not_written().empty()) continue;
        (one.failure ? wrong : right).push_back(fmt::format("“{}”", name));
    }
    if (right.empty())
        return wrong.size() < 2 ? "Its one test fails." : fmt::format("All its {} tests fail.", wrong.size());
    constexpr std::size_t most = 2;
    const auto listed = [&](std::vector<std::string> names) {
        const std::size_t more = names.size() > most ? names.size() - most : 0;
        names.resize(std::min(names.size(), most));
        return fmt::format("{}{}", fmt::join(names, ", "), more > 0 ? fmt::format(" and {} more", more) : "");
    };
    return fmt::format("Right in {}; wrong in {}.", listed(right), listed(wrong));
}

}  // namespace

std::string description(const Exercise& exercise, const TestRun& run, const Judgement& judgement) {
    const CaseResult* const shown = judgement.shown;
    if (!shown || !shown->failure || !shown->failure->not_written().empty()) return "";
    const std::string_view scalar = name_and_scalar(shown->name).second;
    Checks all, of_shown;
    bool right_in_double = scalar == "float" || scalar == "long double", right_in_float = scalar == "double";
    bool any_in_float = false;
    for (const CaseResult& one : run.cases)
        if (function_tested_by(exercise, one.name) == judgement.function) {
            const std::string_view its = name_and_scalar(one.name).second;
            if (its == "double" && one.failure) right_in_double = false;
            if (its == "float" && one.failure) right_in_float = false;
            any_in_float |= its == "float";
        }
    for (const CheckMade& one : run.checks) {
        if (function_tested_by(exercise, one.test) != judgement.function) continue;
        const std::string_view its = name_and_scalar(one.test).second;
        if (its == scalar || its.empty()) all.push_back(&one);
        if (one.test == shown->name && one.line == shown->failure->line) of_shown.push_back(&one);
    }
    std::vector<std::string> sentences;
    const std::size_t wrong = wrong_ones(all).size();
    if (wrong > 0) sentences.push_back(about_counts(all, wrong, judgement.function));
    if (right_in_double) sentences.push_back("In double all is right.");
    if (right_in_float && any_in_float) sentences.push_back("In float all is right.");
    const Function none{};
    const Function& function = judgement.function ? *judgement.function : none;
    const std::string places = about_places(all, function.name), members = about_members(all);
    const std::string answers = about_answers(all, of_shown, function);
    for (const std::string& words : {places.empty() ? members : places, answers})
        if (!words.empty()) sentences.push_back(words);
    if (places.empty() || answers.empty()) {
        std::string tests = about_tests(exercise, run, judgement, scalar);
        if (!tests.empty()) sentences.push_back(std::move(tests));
    }
    return fmt::format("{}", fmt::join(sentences, " "));
}

}  // namespace glassbox::learn
