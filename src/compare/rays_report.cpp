#include "compare/rays_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "compare/words.hpp"
#include "numerics/printed_bound.hpp"
#include "scene/suggestion.hpp"

namespace glassbox {

namespace {

using Json = nlohmann::ordered_json;

constexpr NameTable<Wrong, wrong_count> wrongs{{
    {"nothing", Wrong::nothing, "nothing"},
    {"validity", Wrong::validity, "whether it is a ray at all"},
    {"hit", Wrong::hit, "wrong hit"},
    {"miss", Wrong::miss, "wrong miss"},
    {"surface", Wrong::surface, "wrong surface"},
    {"t", Wrong::t, "another t"},
}};

constexpr std::string_view answer_word(Shot::Answer answer) {
    return answer == Shot::Answer::hit ? "hit" : answer == Shot::Answer::miss ? "miss" : "invalid";
}

/// The worst first: mistakes before what is not known before what rounding may do. Ties are none.
std::vector<const RayDifference*> worst_of(const RaysReport& report) {
    std::vector<const RayDifference*> all;
    for (const RayDifference& one : report.comparison.differences)
        if (one.cause != Cause::tie) all.push_back(&one);
    const auto rank = [](const RayDifference* one) { return std::pair(one->cause, one->times); };
    std::ranges::stable_sort(all, std::greater{}, rank);
    all.resize(std::min(all.size(), report.worst));
    return all;
}

/// The first that rounding does not explain; or, if it explains all, the first.
const RayDifference* first_of(const RaysReport& report) {
    const std::vector<RayDifference>& all = report.comparison.differences;
    auto found = std::ranges::find_if(all, [](const RayDifference& one) { return is_beyond_rounding(one.cause); });
    if (found == all.end())
        found = std::ranges::find_if(all, [](const RayDifference& one) { return one.cause != Cause::tie; });
    return found == all.end() ? nullptr : &*found;
}

std::string claim_text(const Claim& claim) {
    if (claim.answer != Shot::Answer::hit) return std::string(answer_word(claim.answer));
    return fmt::format("hit{}{}", claim.surface ? fmt::format(" surface {}", *claim.surface) : "",
                       claim.t ? fmt::format(" at t = {}", *claim.t) : "");
}

std::string truth_text(const Shot& shot) {
    if (shot.answer != Shot::Answer::hit) return std::string(answer_word(shot.answer));
    const auto t = static_cast<double>(shot.t);
    if (!std::isfinite(t) || !std::isfinite(shot.t_error)) return fmt::format("hit surface {}", shot.surface);
    const std::string value = value_beside(t, shot.t_error), bound = bound_beside(value, t, shot.t_error);
    return fmt::format("hit surface {} at t = {} {}", shot.surface, value, bound == "0" ? "exactly" : "± " + bound);
}

std::string t_text(const RayDifference& one) {
    if (!one.t_off) return "";
    if (!std::isfinite(*one.t_off)) return "their t is not finite";
    const std::string off = fmt::format("their t is {} from the certified one", rounded_up(std::abs(*one.t_off), 3));
    if (!std::isfinite(one.t_bound)) return off + "; rounding leaves it without a bound";
    return fmt::format("{}; rounding moves it by {} at most", off, rounded_up(one.t_bound, 2));
}

std::string reason_of_validity(const RayDifference& one) {
    if (one.wrong != Wrong::validity) return "";
    return one.cause == Cause::rounding ? "its direction is 0 in that precision, or a number overflows"
                                        : "a ray is invalid if a number of it is not finite or its direction is 0";
}

void tell(std::string& text, const RaysReport& report, const RayDifference& one) {
    const auto line = [&](std::string_view name, const std::string& what) {
        if (!what.empty()) text += fmt::format("  {:<9} {}\n", name, what);
    };
    text += fmt::format("\nray {}: {}\n", one.ray, wrongs[static_cast<std::size_t>(one.wrong)].help);
    line("theirs", claim_text(report.claims.rays[one.ray]));
    line("truth", truth_text(report.comparison.ours[one.ray]));
    for (const CloseCall& call : telling_calls(one.calls, one.cause)) line("call", call_text(call));
    line("call", reason_of_validity(one));
    if (one.wrong == Wrong::t) line("call", t_text(one));
    line("verdict", std::string(cause_text(one.cause)));
    line("look", report.command(one.ray));
}

Json json(const RaysReport& report, const RayDifference& one) {
    const Claim& claim = report.claims.rays[one.ray];
    const Shot& shot = report.comparison.ours[one.ray];
    const auto or_null = [](const auto& maybe) { return maybe ? Json(*maybe) : Json(nullptr); };
    const bool is_hit = shot.answer == Shot::Answer::hit;
    return {{"ray", one.ray},
            {"wrong", wrongs[static_cast<std::size_t>(one.wrong)].name},
            {"cause", causes[static_cast<std::size_t>(one.cause)].name},
            {"theirs",
             {{"verdict", answer_word(claim.answer)}, {"surface", or_null(claim.surface)}, {"t", or_null(claim.t)}}},
            {"truth",
             {{"verdict", answer_word(shot.answer)},
              {"surface", is_hit ? Json(shot.surface) : Json(nullptr)},
              {"t", is_hit ? Json(static_cast<double>(shot.t)) : Json(nullptr)},
              {"t_error", is_hit ? Json(bound_to_print(shot.t_error)) : Json(nullptr)}}},
            {"t_off", or_null(one.t_off)},
            {"t_bound", one.t_off ? Json(one.t_bound) : Json(nullptr)},
            {"times", one.times},
            {"calls", calls_json(one.calls)},
            {"command", report.command(one.ray)}};
}

}  // namespace

std::string to_text(const RaysReport& report) {
    const RayComparison& all = report.comparison;
    std::string text;
    const auto line = [&](std::string_view name, const std::string& what) {
        text += fmt::format("{:<12}{}\n", name, what);
    };
    const std::size_t rays = all.ours.size();
    line("differ", fmt::format("{} of {}", all.count(), counted(rays, "ray")));
    for (const Cause cause : {Cause::mistake, Cause::unknown, Cause::rounding}) {
        const auto& [name, value, help] = causes[static_cast<std::size_t>(cause)];
        std::string kinds;
        for (const auto& [wrong_name, wrong, words] : wrongs)
            if (const std::size_t count = all.count(wrong, cause); count > 0)
                kinds += fmt::format("{}{} {}", kinds.empty() ? ": " : ", ", words, count);
        if (all.count(cause) > 0 || cause != Cause::unknown)
            line(std::string("  ") + std::string(name), fmt::format("{}, {}{}", all.count(cause), help, kinds));
    }
    if (const std::size_t ties = all.count(Cause::tie); ties > 0)
        line("ties", fmt::format("{} besides: {}; both are right", ties, causes[1].help));
    double most = 0;
    for (const RayDifference& one : all.differences)
        if (one.wrong == Wrong::t && one.t_off && std::isfinite(*one.t_off))
            most = std::max(most, std::abs(*one.t_off));
    if (most > 0) line("t", fmt::format("{} from the certified one at most", rounded_up(most, 3)));
    line("judged", "by " + theirs_text(report.theirs));
    const std::string in_float = float_text(count_beyond_rounding(all), report.beyond_float);
    if (!in_float.empty()) line("note", in_float);
    if (report.claims.is_shortened(report.theirs.precision == TheirPrecision::float_ ? digits_of<float>
                                                                                     : digits_of<double>))
        line("note", fmt::format("their t have {} digits at most; what half of the last one explains is the writing's. "
                                 "Write all, as %.17g does",
                                 report.claims.digits));
    const std::vector<const RayDifference*> worst = worst_of(report);
    const RayDifference* const first = first_of(report);
    if (first) line("first", fmt::format("ray {}", first->ray));
    if (worst.size() == 1) text += "\nThe worst:\n";
    if (worst.size() > 1) text += fmt::format("\nThe {}, worst first:\n", counted(worst.size(), "difference"));
    for (const RayDifference* one : worst) tell(text, report, *one);
    if (first && !worst.empty() && std::ranges::find(worst, first) == worst.end()) {
        text += "\nThe first:\n";
        tell(text, report, *first);
    }
    return text;
}

std::string to_json(const RaysReport& report) {
    const RayComparison& all = report.comparison;
    Json worst = Json::array();
    for (const RayDifference* one : worst_of(report)) worst.push_back(json(report, *one));
    const RayDifference* const first = first_of(report);
    const Json whole = {{"version", 1},
                        {"rays", all.ours.size()},
                        {"differ", all.count()},
                        {"mistake", all.count(Cause::mistake)},
                        {"unknown", all.count(Cause::unknown)},
                        {"rounding", all.count(Cause::rounding)},
                        {"ties", all.count(Cause::tie)},
                        {"theirs", theirs_json(report.theirs)},
                        {"beyond_float", report.beyond_float ? Json(*report.beyond_float) : Json(nullptr)},
                        {"first", first ? json(report, *first) : Json(nullptr)},
                        {"worst", std::move(worst)}};
    return whole.dump(1, ' ', true, Json::error_handler_t::replace) + '\n';
}

}  // namespace glassbox
