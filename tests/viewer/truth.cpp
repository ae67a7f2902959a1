// The line and the three tiles above the pages: what they say, and where they lead.
#include "viewer/model/story/truth.hpp"

#include <doctest.h>

#include <algorithm>

#include "explain/explain.hpp"
#include "explain/text.hpp"
#include "scene/scene_file.hpp"
#include "viewer/model/state/keys.hpp"
#include "viewer/model/story/predicting.hpp"

using namespace glassbox;

namespace {

/// A pinned pixel, as the background shows it.
struct Pinned {
    ViewerState state;
    Results results;

    Pinned(const char* scene, int x, int y, const Options& options = {}, Detail detail = Detail::whole) {
        state = opened(std::string(SCENES "/") + scene);
        state.pinned = Pixel{x, y};
        results.story = std::make_shared<const Story>(explain(*state.scene, options, x, y, detail));
        results.timeline = timeline(*results.story);
        results.questions = questions(*results.story, results.timeline);
        ++results.story_serial;
    }
    TruthInSight seen() const { return truth_in_sight(state, results); }
    std::vector<std::string> words(TileKind kind, bool brief = false) const {
        const TruthInSight all = seen();
        const Tile& tile = all.tiles[static_cast<std::size_t>(kind)];
        std::vector<std::string> words;
        for (const TileLine& line : brief ? tile.brief : tile.lines) words.push_back(line.text);
        return words;
    }
    const Event& event() const { return results.timeline.at(state.step); }
    void press(char32_t character) { obey({Key::character, character, false, false}, state, results); }
};

}  // namespace

// The green sphere's middle: n = r = (1, 0, 0), and n·l = 4/√18 = cos 19.47°; h is unit(1001, 250, 250), 0.94291 =
// cos 19.45°.
TEST_CASE("the line is explain's, and the tiles have its numbers") {
    const Pinned pinned("levental-2014.toml", 350, 149);
    const TruthInSight seen = pinned.seen();
    CHECK(seen.mark == story::Mark::right);
    CHECK(to_text(*pinned.results.story).starts_with("✓ " + seen.line + '\n'));
    CHECK(pinned.words(TileKind::search) == std::vector<std::string>{"6 tested", "1 met"});
    CHECK(pinned.words(TileKind::cosines) ==
          std::vector<std::string>{"n·l 19.5°  0.943", "n·r 0.0°  1.000", "n·h 19.5°  0.943"});
    CHECK(pinned.words(TileKind::cosines, true) == std::vector<std::string>{"n·l 19.5°", "n·r 0.0°", "n·h 19.5°"});
    const std::vector<std::string> margin = pinned.words(TileKind::margin);
    REQUIRE(margin.size() == 3);
    CHECK(margin[0].ends_with(" digits to spare"));
    CHECK(margin[1].find(" of surface ") != std::string::npos);
}

TEST_CASE("a key opens a tile's step and lays its overlay") {
    Pinned pinned("room.toml", 330, 200);
    pinned.state.overlay.range = {0, 1};
    pinned.press('q');
    CHECK(pinned.state.overlay.measurement == "tests");
    CHECK_FALSE(pinned.state.overlay.range);
    CHECK(pinned.state.page == Page::steps);
    CHECK(pinned.event().group == "which is nearest");
    pinned.press('l');
    CHECK(pinned.state.overlay.measurement == "n.l");
    CHECK(pinned.event().formula.starts_with("n·l = "));
    pinned.press('y');
    CHECK(pinned.state.overlay.measurement == "margin");
    const auto& least = pinned.results.story->judgement->least;
    REQUIRE(pinned.event().place);
    CHECK(pinned.event().place->row == least->row);
    CHECK(pinned.event().place->step == least->step);
    for (const std::string_view name : {"tests", "n.l", "margin"}) CHECK(find_measurement(name));
}

TEST_CASE("a wrong hit is told as one") {
    Options options;
    options.triangle_rule = Tolerance{};
    const Pinned pinned("tolerance-tiny.toml", 399, 0, options);
    CHECK(pinned.seen().mark == story::Mark::wrong);
    CHECK(
        pinned.seen().line.starts_with("wrong hit, proven by error bounds: surface 0 is shown, and nothing is there"));
}

// Surfaces 8 and 9 of edges.toml share an edge that pixel (120, 8) looks at, a hair off.
TEST_CASE("the tile says which means decided, as the line does") {
    const Pinned certified("edges.toml", 120, 8);
    CHECK(certified.seen().line.find("proven in exact arithmetic") != std::string::npos);
    const std::vector<std::string> words = certified.words(TileKind::margin);
    REQUIRE(words.size() > 2);
    CHECK(words[0].ends_with(" digits by bounds alone"));
    CHECK(words[1] == "decided in exact arithmetic");
    Options options;
    options.scalar = Scalar::double_;
    CHECK(Pinned("edges.toml", 120, 8, options).words(TileKind::margin).at(0).ends_with(" digits: undecided"));
}

TEST_CASE("without a pixel the line says what to do, and keys lay overlays only") {
    Pinned pinned("room.toml", 330, 200);
    pinned.state.pinned.reset();
    pinned.results.story = nullptr;
    pinned.results.timeline.clear();
    CHECK(pinned.seen().line.starts_with("Click a pixel"));
    CHECK_FALSE(pinned.seen().mark);
    pinned.state.page = Page::controls;
    pinned.press('y');
    CHECK(pinned.state.page == Page::controls);
    CHECK(pinned.state.overlay.measurement == "margin");
}

TEST_CASE("until all signs are weighed the line says that it checks") {
    Options options;
    options.scalar = Scalar::double_;
    const Pinned pinned("room.toml", 330, 200, options, Detail::judged);
    CHECK(pinned.seen().line == "right: surface 816 is shown, and nearest; checking how sure that is …");
    CHECK(pinned.words(TileKind::margin) == std::vector<std::string>{"checking …"});
}

TEST_CASE("nothing is given away while the page Steps asks") {
    Pinned pinned("levental-2014.toml", 350, 149);
    set_predicting(pinned.state, pinned.results, true);
    pinned.state.page = Page::steps;
    CHECK(pinned.seen().line.starts_with("Hidden while you predict"));
    CHECK(pinned.words(TileKind::search) == std::vector<std::string>{"hidden"});
    pinned.press('l');
    CHECK(pinned.state.step < steps_shown(pinned.state, pinned.results).size());
    pinned.state.page = Page::inspector;
    CHECK(pinned.seen().mark == story::Mark::right);
}

TEST_CASE("what is not shaded has no cosines, and Phong's own model another product") {
    CHECK(Pinned("levental-2014.toml", 10, 10).words(TileKind::cosines) == std::vector<std::string>{"nothing is met"});
    Options third;
    third.stage = 3;
    CHECK(Pinned("levental-2014.toml", 350, 149, third).words(TileKind::cosines) ==
          std::vector<std::string>{"not before stage 4"});
}

TEST_CASE("with the engine the tile counts boxes and nodes, too") {
    Options fast;
    fast.engine = EngineChoice::fast;
    const std::vector<std::string> words = Pinned("room.toml", 330, 200, fast).words(TileKind::search);
    REQUIRE(words.size() == 3);
    CHECK(words[0].ends_with(" of 1255 tested"));
    CHECK(words[2].find("of their boxes missed") != std::string::npos);
}
