#include "learn/check/description.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "learn/check/facts.hpp"
#include "learn/check/relation.hpp"
#include "scene/suggestion.hpp"

namespace glassbox::learn {
namespace {

using Checks = std::vector<const CheckMade*>;

/// What is so of each of some checks, a row for each fact.
struct Row {
    std::string yes, no;
    bool is_of_the_outcome = false;
    std::vector<signed char> holds;  ///< 1, 0, or -1 where it cannot be said of that check
};

/// Facts and their contraries.
std::vector<Row> rows_of(const Checks& checks) {
    std::vector<Row> rows;
    std::map<std::string, std::size_t> place;
    for (std::size_t i = 0; i < checks.size(); ++i)
        for (Fact& fact : facts_of(*checks[i])) {
            const auto [found, is_new] = place.emplace(fact.yes, rows.size());
            if (is_new) {
                const signed char elsewhere = fact.no.empty() ? 0 : -1;
                rows.push_back({std::move(fact.yes), std::move(fact.no), fact.is_of_the_outcome, {}});
                rows.back().holds.assign(checks.size(), elsewhere);
            }
            rows[found->second].holds[i] = fact.holds;
        }
    const std::size_t facts = rows.size();
    for (std::size_t k = 0; k < facts; ++k) {
        if (rows[k].no.empty()) continue;
        Row contrary{rows[k].no, rows[k].yes, rows[k].is_of_the_outcome, rows[k].holds};
        for (signed char& one : contrary.holds) one = one < 0 ? one : static_cast<signed char>(1 - one);
        rows.push_back(std::move(contrary));
    }
    return rows;
}

/// Where the wrong checks are: only where something is so.
struct Split {
    std::string where, elsewhere;
    std::size_t wrong = 0;            ///< of the checks of which it is so
    std::size_t right = 0;            ///< the same
    std::size_t right_elsewhere = 0;  ///< of those of which it is not
    bool exact() const { return right == 0; }
};

bool is_so_of_all_wrong(const Checks& checks, const std::vector<signed char>& is) {
    for (std::size_t i = 0; i < checks.size(); ++i)
        if (!checks[i]->passed && is[i] != 1) return false;
    return true;
}

std::optional<Split> split_by(const Checks& checks, const std::vector<signed char>& is) {
    if (!is_so_of_all_wrong(checks, is)) return {};
    Split split;
    for (std::size_t i = 0; i < checks.size(); ++i) {
        if (!checks[i]->passed) ++split.wrong;
        else if (is[i] == 1) ++split.right;
        else if (is[i] == 0) ++split.right_elsewhere;
    }
    return split.right_elsewhere > 0 ? std::optional(split) : std::nullopt;
}

std::optional<Split> split_by(const Checks& checks, const Row& row) {
    std::optional<Split> split = split_by(checks, row.holds);
    if (split) split->where = row.yes, split->elsewhere = row.no.empty() ? "anything else is" : row.no;
    return split;
}

/// Returns the fact that tells wrong checks from right ones exactly, the most telling one if there are several; else
/// two facts that do so together; else the fact that does it best, if it leaves half of what is right elsewhere.
std::optional<Split> best_split(const Checks& checks) {
    const std::vector<Row> rows = rows_of(checks);
    std::vector<const Row*> possible;  // what is so of all that is wrong
    std::optional<Split> best;
    double best_share = 0.5;
    for (const Row& row : rows) {
        if (!is_so_of_all_wrong(checks, row.holds)) continue;
        possible.push_back(&row);
        std::optional<Split> split = split_by(checks, row);
        if (!split) continue;
        const double all = static_cast<double>(split->right + split->right_elsewhere);
        constexpr double of_the_outcome = 0.2;  // says less
        const double share =
            static_cast<double>(split->right) / all + (row.is_of_the_outcome && !split->exact() ? of_the_outcome : 0);
        if (split->exact()) {
            if (!best || !best->exact()) best = std::move(split);
        } else if ((!best || !best->exact()) && share < best_share) {
            best = std::move(split);
            best_share = share;
        }
    }
    if (best && best->exact()) return best;
    constexpr std::size_t most_pairs = 60;
    possible.resize(std::min(possible.size(), most_pairs));
    for (std::size_t k = 0; k < possible.size(); ++k)
        for (std::size_t i = 0; i < k; ++i) {
            std::vector<signed char> both = possible[i]->holds;
            for (std::size_t n = 0; n < both.size(); ++n) {
                const signed char one = both[n], other = possible[k]->holds[n];
                both[n] = one == 0 || other == 0 ? 0 : std::min(one, other);  // where one is not so, not both are
            }
            std::optional<Split> split = split_by(checks, both);
            if (!split || !split->exact() || possible[i]->no == possible[k]->yes) continue;
            split->where = fmt::format("{} and {}", possible[i]->yes, possible[k]->yes);
            split->elsewhere = "one of the two is not so";
            return split;
        }
    return best;
}

Checks wrong_ones(const Checks& checks) {
    Checks wrong;
    std::ranges::copy_if(checks, std::back_inserter(wrong), [](const CheckMade* one) { return !one->passed; });
    return wrong;
}

std::string sentence_of(const Split& split, const std::string& subject) {
    if (split.exact())
        return fmt::format("{} wrong wherever {} ({}), and right wherever {} ({}).", subject, split.where,
                           counted(split.wrong, "check"), split.elsewhere, split.right_elsewhere);
    return fmt::format("{} wrong only where {} ({} of {}), and right wherever {} ({}).", subject, split.where,
                       split.wrong, counted(split.wrong + split.right, "such check"), split.elsewhere,
                       split.right_elsewhere);
}

/// "first_of(" of "first_of(Real(6), Real(14)).t", and what stands after its parenthesis; the whole of anything else.
std::string without_arguments(const std::string& expression) {
    const std::size_t open = expression.find('('), close = expression.rfind(')');
    if (open == std::string::npos || close == std::string::npos || close < open) return expression;
    return expression.substr(0, open) + "(…)" + expression.substr(close + 1);
}

/// Some of the function's checks, and what to call them.
struct Group {
    std::string subject;
    Checks checks;
};

/// All checks; those of numbers, or the conditions; those that are written like the one that is shown; that one alone.
std::vector<Group> groups_of(const Checks& all, const Checks& of_shown) {
    std::vector<Group> groups{{"It is", all}};
    if (of_shown.empty()) return groups;
    const CheckMade& shown = *of_shown[0];
    const auto add = [&](std::string subject, const auto& belongs) {
        Group group{std::move(subject), {}};
        for (const CheckMade* one : all)
            if (belongs(*one)) group.checks.push_back(one);
        if (group.checks.size() < groups.back().checks.size()) groups.push_back(std::move(group));
    };
    add(shown.is_condition ? "Answers of yes or no are" : "Numbers are",
        [&](const CheckMade& one) { return one.is_condition == shown.is_condition; });
    const std::string written = without_arguments(shown.expression);
    add(fmt::format("`{}` is", written),
        [&](const CheckMade& one) { return without_arguments(one.expression) == written; });
    groups.push_back({"In the check above it is", of_shown});
    return groups;
}

/// Where the function is wrong, and where it is right; "" if nothing that we know of tells the two apart.
std::string about_places(const Checks& all, const Checks& of_shown) {
    std::string best;
    for (const Group& group : groups_of(all, of_shown)) {
        const std::size_t wrong = wrong_ones(group.checks).size();
        if (wrong == 0 || wrong == group.checks.size()) continue;
        const std::optional<Split> split = best_split(group.checks);
        if (!split) continue;
        if (split->exact()) return sentence_of(*split, group.subject);
        if (best.empty()) best = sentence_of(*split, group.subject);
    }
    return best;
}

/// "Every wrong number is half of what is expected."
std::string about(const Checks& wrong) {
    const std::string words = relation_of(wrong);
    if (words.empty()) return "";
    if (wrong[0]->is_condition) return fmt::format("Where yes or no is asked, every wrong answer {}.", words);
    return fmt::format("{} {} {}.", wrong.size() > 1 ? "Every wrong" : "The wrong",
                       wrong[0]->got.size() == 3 ? "vector" : "number", words);
}

/// What the wrong answers have in common: all of the function's, or those of the check that is shown.
std::vector<std::string> about_answers(const Checks& all, const Checks& of_shown) {
    std::vector<std::string> sentences;
    for (const bool is_condition : {false, true}) {
        Checks wrong = wrong_ones(all);
        std::erase_if(wrong, [&](const CheckMade* one) { return one->is_condition != is_condition; });
        std::string words = about(wrong);
        if (!words.empty()) sentences.push_back(std::move(words));
    }
    if (!sentences.empty()) return sentences;
    const Checks wrong = wrong_ones(of_shown);
    std::string words = wrong.empty() || wrong[0]->is_condition ? "" : about(wrong);
    if (words.empty()) return {};
    return {"In the check above: " + words};
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
    if (wrong == 1 && all.size() == 1) sentences.push_back("The one check looked at is wrong.");
    else if (wrong > 0)
        sentences.push_back(wrong == all.size()
                                ? fmt::format("All {} looked at are wrong.", counted(all.size(), "check"))
                                : fmt::format("{} of {} looked at {} wrong.", wrong, counted(all.size(), "check"),
                                              wrong == 1 ? "is" : "are"));
    if (right_in_double) sentences.push_back("In double all is right.");
    if (right_in_float && any_in_float) sentences.push_back("In float all is right.");
    const std::string places = about_places(all, of_shown);
    const bool is_told_where = !places.empty();
    if (is_told_where) sentences.push_back(places);
    const std::vector<std::string> answers = about_answers(all, of_shown);
    sentences.insert(sentences.end(), answers.begin(), answers.end());
    if (!is_told_where || answers.empty()) {
        std::string tests = about_tests(exercise, run, judgement, scalar);
        if (!tests.empty()) sentences.push_back(std::move(tests));
    }
    return fmt::format("{}", fmt::join(sentences, " "));
}

}  // namespace glassbox::learn
