#include "viewer/model/story/truth.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "explain/phrases.hpp"
#include "explain/verdict_phrases.hpp"
#include "explain/words.hpp"
#include "viewer/model/story/predicting.hpp"

namespace glassbox {

namespace {

using namespace story;
using About = TileLine::About;
using Events = std::span<const Event>;

std::array<Tile, 3> empty_tiles() {
    return {
        Tile{
            .title = "tested / met",
            .lines = {},
            .brief = {},
            .overlay = "tests",
            .step = {},
            .key = "q",
            .tip =
                "How many surfaces were tested, and how many the ray meets. Opens that step and the overlay tests (q)"},
        Tile{.title = "cosines",
             .lines = {},
             .brief = {},
             .overlay = "n.l",
             .step = {},
             .key = "l",
             .tip =
                 "Cosines of the angles between unit vectors at the hit. n·l: normal · light, how directly the light "
                 "falls in; n·r: normal · viewer; n·h: normal · half vector, which makes the highlight. Opens the step "
                 "of n·l and the overlay n.l (l)"},
        Tile{.title = "least margin",
             .lines = {},
             .brief = {},
             .overlay = "margin",
             .step = {},
             .key = "y",
             .tip = "The least sure sign of those that decide what is shown. With 3 digits to spare its number is 10³ "
                    "times as large as its error bound; below 0 digits it is smaller, and bounds alone do not tell "
                    "its sign. Opens its step and the overlay margin, which is of side products alone, of all "
                    "triangles tested (y)"}};
}

std::optional<std::size_t> event_where(Events events, const auto& is_wanted) {
    const auto found = std::find_if(events.begin(), events.end(), is_wanted);
    if (found == events.end()) return {};
    return static_cast<std::size_t>(found - events.begin());
}

void fill_search(Tile& tile, const Story& story, Events events) {
    const bool all = story.tested == story.in_all;
    tile.lines = {
        {all ? fmt::format("{} tested", story.tested) : fmt::format("{} of {} tested", story.tested, story.in_all)},
        {fmt::format("{} met", story.met)}};
    tile.brief = {{fmt::format("{} / {}", story.tested, story.met)}};
    if (const std::string by_engine = boxes(story); !by_engine.empty()) tile.lines.push_back({by_engine, About::words});
    tile.step = event_where(events, [](const Event& event) { return event.group == "which is nearest"; });
    if (tile.step && story.not_listed > 0) ++*tile.step;  // first it is said how many more are missed
}

void fill_cosines(Tile& tile, const Story& story, Events events) {
    if (!story.hit || !story.hit->shade) {
        const char* const why = story.options.stage < 4 ? "not before stage 4" : "nothing is met";
        tile.lines = tile.brief = {{why, About::words}};
        return;
    }
    const Shade& shade = *story.hit->shade;
    const bool phong = shade.model == ShadingModel::phong;
    const auto add = [&](const char* name, const Number& cosine, About about) {
        tile.lines.push_back(
            {fmt::format("{} {}  {}", name, degrees(cosine.value), with_minus(fmt::format("{:.3f}", cosine.value))),
             about});
        tile.brief.push_back({fmt::format("{} {}", name, degrees(cosine.value)), about});
    };
    add("n·l", shade.n_l, About::n_l);
    add("n·r", shade.n_r, About::n_r);
    add(phong ? "r·m" : "n·h", shade.highlight, About::n_h);
    tile.step = event_where(events, [&](const Event& event) {
        return event.place && !event.place->row && story.hit->steps[event.place->step].name == "n·l";
    });
}

void fill_margin(Tile& tile, const Story& story, Events events) {
    if (!story.judgement || !story.judgement->is_weighed) {
        tile.lines = tile.brief = {{story.judgement ? "checking …" : "nothing is decided", About::words}};
        return;
    }
    if (!story.judgement->least) {
        tile.lines = tile.brief = {{"no surface", About::words}};
        return;
    }
    const LeastSure& least = *story.judgement->least;
    const bool proven = least.sureness > 1, decided = is_decided_exactly(least, story.options);
    const std::string digits = margin_text(least) + " digits";
    const About about = proven || decided ? About::number : About::danger;
    tile.lines = {{digits + (proven ? " to spare" : decided ? " by bounds alone" : ": undecided"), about}};
    if (!proven && decided) tile.lines.push_back({"decided in exact arithmetic", About::words});
    tile.lines.push_back({whose(least, story), About::number});
    tile.brief = {{digits + (proven    ? ""
                             : decided ? "; decided exactly"
                                       : ": undecided"),
                   about},
                  {(least.nearer_than ? fmt::format("t: {}, {}", *least.nearer_than, least.surface)
                                      : fmt::format("{} of {}", least.name, least.surface)) +
                       among_turned(least, story),
                   About::number}};
    if (const std::string culprit = lost_by(least, story); !culprit.empty()) {
        tile.lines.push_back({culprit, About::words});
        tile.brief.push_back({culprit, About::words});
    }
    tile.step = event_where(events, [&](const Event& event) {
        return least.step && event.place && event.place->row == least.row && event.place->step == *least.step;
    });
    if (!tile.step) tile.step = event_where(events, [&](const Event& event) { return event.surface == least.row; });
}

void fill_hidden(std::array<Tile, 3>& tiles) {
    for (Tile& tile : tiles) tile.lines = tile.brief = {{"hidden", About::words}};
}

/// Whether the verdict would answer what the page is asking.
bool hides_truth(const ViewerState& state, const Results& results) {
    return state.page == Page::steps && next_question(state, results);
}

}  // namespace

TruthInSight truth_in_sight(const ViewerState& state, const Results& results) {
    TruthInSight seen;
    seen.tiles = empty_tiles();
    auto& [search, cosines, margins] = seen.tiles;
    if (!state.pinned || !results.story) {
        seen.line = state.pinned ? "checking this pixel …" : "Click a pixel: is it right, and how sure is that?";
        seen.short_line = seen.line;
        search.lines = search.brief = {{"surfaces", About::words}};
        cosines.lines = {{"n·l: normal · light", About::n_l},
                         {"n·r: normal · viewer", About::n_r},
                         {"n·h: normal · half", About::n_h}};
        cosines.brief = {{"n·l n·r n·h", About::words}};
        margins.lines = margins.brief = {{"digits to spare", About::words}};
        return seen;
    }
    if (hides_truth(state, results)) {
        seen.line = seen.short_line = "Hidden while you predict: answer the questions, or switch Predict first off.";
        fill_hidden(seen.tiles);
        return seen;
    }
    const Story& story = *results.story;
    seen.mark = mark_of(story);
    seen.is_sure = is_surely_right(story);
    seen.line = verdict_line(story);
    seen.short_line = short_verdict_line(story);
    fill_search(search, story, results.timeline);
    fill_cosines(cosines, story, results.timeline);
    fill_margin(margins, story, results.timeline);
    return seen;
}

void open_tile(ViewerState& state, const Results& results, TileKind kind) {
    const TruthInSight seen = truth_in_sight(state, results);
    const Tile& tile = seen.tiles[static_cast<std::size_t>(kind)];
    if (state.overlay.measurement != tile.overlay) state.overlay.range.reset();  // it was for the other measurement
    state.overlay.measurement = tile.overlay;
    if (!results.story) return;
    state.page = Page::steps;
    state.mine.is_stepped = false;  // the tile is about ours
    state.playing = false;
    const std::span<const Event> shown = steps_shown(state, results);
    if (tile.step && !shown.empty()) state.step = std::min(*tile.step, shown.size() - 1);
}

}  // namespace glassbox
