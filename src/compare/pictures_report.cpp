#include "compare/pictures_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>

#include "compare/words.hpp"
#include "explain/phrases.hpp"
#include "scene/suggestion.hpp"

namespace glassbox {

namespace {

using Json = nlohmann::ordered_json;

constexpr NameTable<Seen, seen_count> seens{{
    {"color", Seen::color, "the colour rounded, or cut to a byte, in another way"},
    {"neighbour", Seen::neighbour, "rounding decides what is seen"},
    {"tie", Seen::tie, "another surface at exactly the same t"},
    {"behind", Seen::behind, "the colour of what lies behind"},
    {"background", Seen::background, "the background, where a surface is surely met"},
    {"shading", Seen::shading, "another colour than any surface here has"},
    {"nothing", Seen::nothing, "a colour where nothing is met"},
    {"border", Seen::border, "the border, which the scene paints over the picture"},
}};

const Named<Seen>& named(Seen seen) { return seens[static_cast<std::size_t>(seen)]; }

bool is_worse(const PixelDifference* a, const PixelDifference* b) {
    return std::pair(a->cause, a->off) > std::pair(b->cause, b->off);
}

/// The worst first: mistakes before what is not known before what rounding may do.
std::vector<const PixelDifference*> worst_pixels(const PicturesReport& report) {
    std::vector<const PixelDifference*> all;
    for (const PixelDifference& one : report.comparison.looked_into) all.push_back(&one);
    std::ranges::stable_sort(all, is_worse);
    all.resize(std::min(all.size(), report.worst));
    return all;
}

/// The first that rounding does not explain; or, if it explains all, the first.
const PixelDifference* first_pixel(const PictureComparison& comparison) {
    const auto& all = comparison.looked_into;
    const auto found =
        std::ranges::find_if(all, [](const PixelDifference& one) { return is_beyond_rounding(one.cause); });
    if (found != all.end()) return &*found;
    return all.empty() ? nullptr : &all.front();
}

std::string truth_line(const PixelDifference& one) {
    if (one.seen == Seen::border) return "the border";
    if (!one.truth) return "nothing is met: the background";
    return fmt::format("surface {} is met first, at t = {}", one.truth->surface, short_number(one.truth->t));
}

/// What theirs looks like.
std::string seen_line(const PixelDifference& one) {
    const std::string words(named(one.seen).help);
    if (one.seen == Seen::behind) return fmt::format("{}, surface {}", words, *one.surface);
    if (one.seen != Seen::neighbour) return words;
    return words +
           (one.surface ? fmt::format(": theirs may be surface {}", *one.surface) : ": theirs may be the background");
}

void tell(std::string& text, const PicturesReport& report, const PixelDifference& one) {
    const auto line = [&](std::string_view name, const std::string& what) {
        text += fmt::format("  {:<9} {}\n", name, what);
    };
    text += fmt::format("\npixel {},{}: off by {}\n", one.pixel.x, one.pixel.y, one.off);
    line("theirs", triple(one.theirs));
    line("ours", triple(one.ours));
    line("truth", truth_line(one));
    line("shows", seen_line(one));
    for (const CloseCall& call : telling_calls(one.calls, one.cause)) line("call", call_text(call));
    line("verdict", std::string(cause_text(one.cause)));
    line("look", report.command(one.pixel));
}

Json json(const PicturesReport& report, const PixelDifference& one) {
    const auto color = [](Rgb c) { return Json::array({c.red, c.green, c.blue}); };
    return {{"pixel", {one.pixel.x, one.pixel.y}},
            {"theirs", color(one.theirs)},
            {"ours", color(one.ours)},
            {"off", one.off},
            {"cause", causes[static_cast<std::size_t>(one.cause)].name},
            {"shows", named(one.seen).name},
            {"shows_surface", one.surface ? Json(*one.surface) : Json(nullptr)},
            {"surface", one.truth ? Json(one.truth->surface) : Json(nullptr)},
            {"t", one.truth ? Json(one.truth->t) : Json(nullptr)},
            {"calls", calls_json(one.calls)},
            {"command", report.command(one.pixel)}};
}

}  // namespace

std::string to_text(const PicturesReport& report) {
    const PictureComparison& all = report.comparison;
    std::string text;
    const auto line = [&](std::string_view name, const std::string& what) {
        text += fmt::format("{:<12}{}\n", name, what);
    };
    const std::string pixels = counted(all.ours.pixels.size(), "pixel");
    if (all.differ == 0) line("differ", fmt::format("0 of {}", pixels));
    else
        line("differ", fmt::format("{} of {}, by {} at most and {:.3g} on average (of 255)", all.differ, pixels,
                                   all.greatest, all.mean));
    if (!all.is_all())
        line("looked", fmt::format("into {} of them, which lie evenly; the following counts are of these",
                                   all.looked_into.size()));
    for (const Cause cause : {Cause::mistake, Cause::unknown, Cause::rounding, Cause::tie}) {
        const auto& [name, value, help] = causes[static_cast<std::size_t>(cause)];
        if (all.count(cause) == 0 && (cause == Cause::unknown || cause == Cause::tie)) continue;
        line(fmt::format("  {}", name), fmt::format("{}, {}", all.count(cause), help));
        for (const auto& [seen_name, seen, words] : seens)
            if (const std::size_t count = all.count(seen, cause); count > 0)
                text += fmt::format("              {}: {}\n", count, words);
    }
    for (const Explanation& one : all.explanations)
        line("found",
             fmt::format("theirs is ours {}: {} of {} differ then", one.words, one.still_differ, one.compared));
    line("judged", "by " + theirs_text(report.theirs));
    const std::string in_float = float_text(count_beyond_rounding(all), report.beyond_float);
    if (!in_float.empty()) line("note", in_float);
    const std::vector<const PixelDifference*> worst = worst_pixels(report);
    const PixelDifference* const first = first_pixel(all);
    if (first) line("first", fmt::format("pixel {},{}", first->pixel.x, first->pixel.y));
    if (worst.size() == 1) text += "\nThe worst:\n";
    if (worst.size() > 1) text += fmt::format("\nThe {}, worst first:\n", counted(worst.size(), "difference"));
    for (const PixelDifference* one : worst) tell(text, report, *one);
    if (first && !worst.empty() && std::ranges::find(worst, first) == worst.end()) {
        text += "\nThe first:\n";
        tell(text, report, *first);
    }
    return text;
}

std::string to_json(const PicturesReport& report) {
    const PictureComparison& all = report.comparison;
    Json worst = Json::array(), found = Json::array();
    for (const PixelDifference* one : worst_pixels(report)) worst.push_back(json(report, *one));
    for (const Explanation& one : all.explanations)
        found.push_back({{"ours", one.words}, {"differ", one.still_differ}, {"compared", one.compared}});
    const PixelDifference* const first = first_pixel(all);
    const Json whole = {{"version", 1},
                        {"size", {all.ours.width, all.ours.height}},
                        {"differ", all.differ},
                        {"greatest", all.greatest},
                        {"mean", all.mean},
                        {"looked_into", all.looked_into.size()},
                        {"mistake", all.count(Cause::mistake)},
                        {"unknown", all.count(Cause::unknown)},
                        {"rounding", all.count(Cause::rounding)},
                        {"ties", all.count(Cause::tie)},
                        {"found", std::move(found)},
                        {"theirs", theirs_json(report.theirs)},
                        {"beyond_float", report.beyond_float ? Json(*report.beyond_float) : Json(nullptr)},
                        {"first", first ? json(report, *first) : Json(nullptr)},
                        {"worst", std::move(worst)}};
    return whole.dump(1, ' ', true, Json::error_handler_t::replace) + '\n';
}

}  // namespace glassbox
