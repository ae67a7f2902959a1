#include "explain/verdict_phrases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "explain/judgement.hpp"
#include "explain/phrases.hpp"
#include "render/option_names.hpp"

namespace glassbox {

using namespace story;

namespace {

/// "a", "a and b", "a, b and c".
std::string listed(const std::vector<std::string>& names) {
    std::string all;
    for (std::size_t i = 0; i < names.size(); ++i)
        all += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
    return all;
}

/// "surface 816 is shown, and nearest"; "nothing is shown, and nothing is there".
std::string what_is_shown(const Judgement& judgement) {
    if (!judgement.shown) return "nothing is shown, and nothing is there";
    return fmt::format("surface {} is shown, and nearest", *judgement.shown);
}

/// "the sign of c of surface 816"; "which of surfaces 3 and 816 is nearer".
std::string left_open(const LeastSure& least) {
    if (least.nearer_than)
        return fmt::format("which of surfaces {} and {} is nearer", *least.nearer_than, least.surface);
    return "the sign of " + whose(least);
}

std::string right_line(const Judgement& judgement, const Options& options) {
    const std::string shown = what_is_shown(judgement);
    if (!judgement.is_weighed) return "right: " + shown + "; checking how sure that is …";
    if (!judgement.least) return "right, proven: there is no surface";
    const LeastSure& least = *judgement.least;
    if (least.sureness > 1) {
        const bool exact = std::isinf(least.sureness);
        return fmt::format("right, proven, {}: {}",
                           exact ? "nothing was rounded" : margin_text(least) + " digits to spare", shown);
    }
    if (is_proven(options.scalar))
        return fmt::format("right, proven in exact arithmetic: {}; error bounds alone leave open {}", shown,
                           left_open(least));
    const std::size_t wrong = judgement.wrongly_met + judgement.wrongly_missed;
    if (wrong > 0)
        return fmt::format("right by luck, not proven: {}; {} other surface{} judged wrongly", shown, wrong,
                           wrong == 1 ? " is" : "s are");
    return fmt::format("right, but not proven: {}; error bounds leave open {}", shown, left_open(least));
}

/// What made it wrong, if that can be said.
std::string cause(const Judgement& judgement, const Story& story) {
    const std::optional<std::size_t> surface = judged_wrongly(judgement);
    const Surface* row = nullptr;
    for (const Surface& one : story.surfaces)
        if (one.number == surface) row = &one;
    const bool of_sphere = row && std::holds_alternative<SphereTest>(row->test);
    const Options& options = story.options;
    if (judgement.by_rule)
        return fmt::format("; so says the rule {}, without any rounding",
                           of_sphere ? std::string(name_of(options.sphere_rule)) : written(options.triangle_rule));
    if (is_proven(options.scalar)) return "";
    if (row && row->fate == Fate::overflow) return "; a number has grown too large for the scalar";
    if (!judgement.turned.empty())
        return fmt::format("; rounding turned the sign{} of {}", judgement.turned.size() > 1 ? "s" : "",
                           listed(judgement.turned));
    return is_geometry(options.sphere_rule) && is_geometry(options.triangle_rule) ? "; rounding did it" : "";
}

/// What is wrong. That is as sure as the truth is, which the reference search proves.
std::string what_is_wrong(const Judgement& judgement) {
    if (judgement.verdict == Verdict::wrong_hit)
        return fmt::format("surface {} is shown, and nothing is there", *judgement.shown);
    if (judgement.verdict == Verdict::wrong_miss)
        return fmt::format("nothing is shown, and surface {} is there", *judgement.truth);
    if (!judgement.shown_is_there)
        return fmt::format("{} is shown, and not there; {} is", *judgement.shown, *judgement.truth);
    return fmt::format("{} is shown, and {} is {}", *judgement.shown, *judgement.truth,
                       judgement.at_once ? "as near and listed later" : "nearer");
}

std::string wrong_line(const Judgement& judgement) {
    return fmt::format("{}, proven {}: {}", word(judgement.verdict),
                       judgement.truth_needed_exact ? "in exact arithmetic" : "by error bounds",
                       what_is_wrong(judgement));
}

}  // namespace

std::string_view sign(Mark mark) { return mark == Mark::right ? "✓" : mark == Mark::wrong ? "✗" : "?"; }

std::string_view word(Verdict verdict) {
    switch (verdict) {
        case Verdict::right:
            return "right";
        case Verdict::wrong_hit:
            return "wrong hit";
        case Verdict::wrong_miss:
            return "wrong miss";
        case Verdict::wrong_surface:
            return "wrong surface";
    }
    return "";
}

Mark mark_of(const Story& story) {
    if (!story.judgement) return Mark::unknown;
    return story.judgement->verdict == Verdict::right ? Mark::right : Mark::wrong;
}

bool is_surely_right(const Story& story) {
    if (mark_of(story) != Mark::right || !story.judgement->is_weighed) return false;
    return is_proven(story.options.scalar) || !story.judgement->least || story.judgement->least->sureness > 1;
}

std::string short_verdict_line(const Story& story) {
    const std::string line = verdict_line(story);
    const bool right = mark_of(story) == Mark::right && !story.border;
    return line.substr(0, right ? line.find(": ") : line.find("; "));
}

std::string verdict_line(const Story& story) {
    if (story.options.stage == 1) return "stage 1 traces nothing: the colour is the ray's direction";
    const std::string under = story.border ? "border, painted over what the ray brings; beneath it: " : "";
    if (!story.judgement) return under + "not known: a number of the ray is not finite, or D = 0";
    const Judgement& judgement = *story.judgement;
    if (judgement.verdict == Verdict::right) return under + right_line(judgement, story.options);
    return under + wrong_line(judgement) + cause(judgement, story);
}

Mark mark_of(const Surface& surface, const Story& story) {
    if (!story.judgement) return Mark::unknown;
    const bool as_met = is_met(surface.fate) == surface.truly_met;
    const bool as_near = (surface.fate == Fate::nearest) == surface.truly_nearest;
    return as_met && as_near ? Mark::right : Mark::wrong;
}

std::string truth_of(const Surface& surface, const Story& story) {
    const Mark mark = mark_of(surface, story);
    if (mark == Mark::unknown) return "not known";
    const char* const is = mark == Mark::right ? "right" : "wrong";
    if (!surface.truly_met) return fmt::format("{}: truly missed", is);
    if (surface.truly_nearest) return fmt::format("{}: truly met, nearest", is);
    if (mark == Mark::wrong && is_met(surface.fate) && story.judgement->truth)
        return fmt::format("wrong: truly met, but surface {} is {}", *story.judgement->truth,
                           story.judgement->at_once ? "as near and listed later" : "nearer");
    return fmt::format("{}: truly met", is);
}

Mark mark_of_sign(const Number& n) {
    if (n.known == Known::not_at_all || may_be_zero(n) || !std::isfinite(n.recorded)) return Mark::unknown;
    const int computed = n.recorded > 0 ? 1 : n.recorded < 0 ? -1 : 0;
    return computed == n.sign ? Mark::right : Mark::wrong;
}

double margin(const LeastSure& least) {
    // The quotient and its logarithm are rounded, by less than this.
    constexpr double off = 1e-12;
    const double rounded_down = std::floor((std::log10(least.sureness) - off) * 10) / 10;
    return least.sureness > 1 ? std::max(0.0, rounded_down) : rounded_down;
}

std::string margin_text(const LeastSure& least) {
    const double digits = margin(least);
    if (std::isinf(digits)) return digits > 0 ? "∞" : "−∞";
    return fmt::format("{}{:.1f}", digits < 0 ? "−" : "", std::abs(digits));
}

bool is_decided_exactly(const LeastSure& least, const Options& options) {
    return !(least.sureness > 1) && is_proven(options.scalar);
}

std::string margin_in_words(const LeastSure& least, const Options& options) {
    if (least.sureness > 1) return margin_text(least) + " digits to spare";
    return margin_text(least) + (is_decided_exactly(least, options)
                                     ? " digits by bounds alone, decided in exact arithmetic"
                                     : " digits, undecided");
}

std::string whose(const LeastSure& least) {
    if (least.nearer_than) return fmt::format("t of surfaces {} and {}", *least.nearer_than, least.surface);
    return fmt::format("{} of surface {}", least.name, least.surface);
}

std::string among_turned(const LeastSure& least, const Story& story) {
    if (!story.judgement || least.nearer_than || judged_wrongly(*story.judgement) != least.surface) return "";
    const Judgement& judgement = *story.judgement;
    const std::vector<std::string>& turned = judgement.turned;
    if (turned.size() < 2 || judgement.by_rule || std::find(turned.begin(), turned.end(), least.name) == turned.end())
        return "";
    // All signs of a hit must hold, so that the least sure counts; of a miss one that is sure is enough.
    const bool was_hit = judgement.shown == least.surface;
    return fmt::format(", {} of {}", was_hit ? "the least sure" : "one", listed(turned));
}

std::string whose(const LeastSure& least, const Story& story) { return whose(least) + among_turned(least, story); }

std::string lost_by(const LeastSure& least, const Story& story) {
    if (!least.row || !least.step) return "";
    if (!least.worst) return "no bits lost";
    const std::vector<StoryStep>& steps = story.surfaces[*least.row].steps;
    return fmt::format("{} lost {:.1f} bits", operation(steps, steps[*least.worst].step), least.worst_loss);
}

std::string counts(const Story& story) {
    return story.tested == story.in_all ? fmt::format("{} tested, {} met", story.tested, story.met)
                                        : fmt::format("{} of {} tested, {} met", story.tested, story.in_all, story.met);
}

std::string boxes(const Story& story) {
    if (!story.nodes || !story.boxes_missed) return "";
    return fmt::format("{} node{}, {} of their boxes missed", *story.nodes, *story.nodes == 1 ? "" : "s",
                       *story.boxes_missed);
}

}  // namespace glassbox
