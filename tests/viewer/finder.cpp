// The failure finder: which pixels are the worst, which are lit up, and how large they are drawn.
#include "viewer/model/overlay/finder.hpp"

#include <doctest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <set>

#include "viewer/model/overlay/enlarged.hpp"
#include "viewer/model/overlay/laid_over.hpp"
#include "viewer/model/overlay/surfaces_in_picture.hpp"

using namespace glassbox;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

const Measurement& named(std::string_view name) { return *find_measurement(name); }

/// A picture of three columns.
Channel three_wide(std::vector<double> values) {
    const int height = static_cast<int>(values.size()) / 3;
    return {"value", 3, height, std::move(values)};
}

using Pixels = std::vector<Pixel>;

/// A state with a measurement laid over its picture, and the results for it.
struct Laid {
    ViewerState state;
    Results results;

    Laid(std::string_view name, Channel channel) {
        Scene scene;
        scene.width = channel.width;
        scene.height = channel.height;
        state.scene = std::make_shared<const Scene>(scene);
        state.setup = History(setup_of(scene));
        state.overlay.measurement = name;
        FoundPixels found = find_pixels(named(name), channel);
        results.overlay = std::make_shared<const MeasuredChannels>(
            MeasuredChannels{&named(name), {std::move(channel)}, 1, state.scene, state.setup.now(), std::move(found)});
    }
};

}  // namespace

TEST_CASE("the worst margins are the least, −∞ first; ∞ is none, and no value neither") {
    const FoundPixels found =
        find_pixels(named("margin"), three_wide({5, -2, infinity, -infinity, no_value, 3, -2, 1, 9}));
    CHECK(found.worst.pixels == Pixels{{0, 1}, {1, 0}, {0, 2}, {1, 2}, {2, 1}, {0, 0}, {2, 2}});
    CHECK(found.worst.count == 7);
    CHECK(found.alarming.pixels == Pixels{{0, 1}, {1, 0}, {0, 2}});
    CHECK(found.least.pixels.front() == Pixel{1, 0});  // −∞ is no finite value
    CHECK(found.greatest.pixels.front() == Pixel{2, 2});
}

TEST_CASE("of a verdict the wrong pixels, in reading order") {
    const FoundPixels found = find_pixels(named("verdict"), three_wide({0, 1, 0, 3, 0, 2}));
    CHECK(found.worst.pixels == Pixels{{1, 0}, {0, 1}, {2, 1}});
    CHECK(found.alarming.count == 3);
}

TEST_CASE("of a discriminant those nearest to 0, of a depth the greatest") {
    CHECK(find_pixels(named("discriminant"), three_wide({-3, 5, 1})).worst.pixels == Pixels{{2, 0}, {0, 0}, {1, 0}});
    const FoundPixels depth = find_pixels(named("depth"), three_wide({3, no_value, 4}));
    CHECK(depth.worst.pixels == Pixels{{2, 0}, {0, 0}});
    CHECK(depth.alarming.count == 0);
}

TEST_CASE("of a difference those farthest from 0, of either sign; where nothing differs nothing is found") {
    Measurement what = named("depth");
    what.worst = Worst::farthest_from_0;
    const FoundPixels found = find_pixels(what, three_wide({0, -3, 2, no_value, infinity, 0}));
    CHECK(found.worst.pixels == Pixels{{1, 1}, {1, 0}, {2, 0}});
    CHECK(found.worst.count == 3);
    CHECK(found.least.pixels.front() == Pixel{1, 0});
    CHECK(find_pixels(what, three_wide({0, 0, 0})).worst.pixels.empty());
}

TEST_CASE("of very many pixels the first are listed, and all are counted") {
    std::vector<double> values(3 * PixelList::most_listed, -1);
    values[7] = -5;
    const FoundPixels found = find_pixels(named("margin"), three_wide(values));
    CHECK(found.worst.pixels.size() == PixelList::most_listed);
    CHECK(found.worst.pixels.front() == Pixel{1, 2});
    CHECK(found.worst.count == 3 * static_cast<std::int64_t>(PixelList::most_listed));
}

TEST_CASE("from one of the worst to the next and back, around the end, and from elsewhere to the first or the last") {
    const PixelList worst{{{4, 0}, {1, 1}, {2, 2}}, 3};
    CHECK(next_worst(worst, Pixel{4, 0}, true) == 1);
    CHECK(next_worst(worst, Pixel{2, 2}, true) == 0);
    CHECK(next_worst(worst, Pixel{4, 0}, false) == 2);
    CHECK(next_worst(worst, {}, true) == 0);
    CHECK(next_worst(worst, Pixel{9, 9}, false) == 2);
    CHECK_FALSE(next_worst({}, Pixel{9, 9}, true));
}

TEST_CASE("the keys pin what is the worst, and bring it into view; without an overlay they lay verdict over") {
    Laid laid("margin", three_wide({5, -2, 1, -7, 0, 3}));
    laid.state.fit = Fit::none;
    laid.state.area = {100, 100};
    laid.state.view = zoomed_to({50, {-5000, -5000}}, 50, laid.state.area);
    pin_next_worst(laid.state, laid.results, true);
    CHECK(laid.state.pinned == Pixel{0, 1});
    const Point seen = laid.state.view.on_screen({0.5, 1.5});
    CHECK(seen.x > 0);
    CHECK(seen.x < 100);
    CHECK(seen.y > 0);
    CHECK(seen.y < 100);
    pin_next_worst(laid.state, laid.results, true);
    CHECK(laid.state.pinned == Pixel{1, 0});

    laid.state.overlay.measurement.clear();
    pin_next_worst(laid.state, laid.results, true);
    CHECK(laid.state.overlay.measurement == "verdict");
    CHECK(laid.state.pinned == Pixel{1, 0});  // nothing is measured yet
}

TEST_CASE("what was measured of something else, or coarsely, is not what is laid over") {
    Laid laid("margin", three_wide({1, 2, 3}));
    CHECK(laid_over(laid.state, laid.results));
    CHECK(wholly_laid_over(laid.state, laid.results));
    laid.state.overlay.measurement = "depth";
    CHECK_FALSE(last_laid_over(laid.state, laid.results));
    laid.state.overlay.measurement = "margin";
    laid.state.setup.change(turned(laid.state.setup.now(), Axis::z, 10));
    CHECK_FALSE(laid_over(laid.state, laid.results));
    CHECK(last_laid_over(laid.state, laid.results));  // its colours stay until there are others; its numbers do not
    laid.state.setup.undo();
    MeasuredChannels coarse = *laid.results.overlay;
    coarse.factor = 8;
    laid.results.overlay = std::make_shared<const MeasuredChannels>(coarse);
    CHECK(laid_over(laid.state, laid.results));
    CHECK_FALSE(wholly_laid_over(laid.state, laid.results));
}

TEST_CASE("ranks: what is worse ranks higher; with a brush what it holds, of its own measurement only") {
    Overlay overlay;
    overlay.measurement = "margin";
    const Channel channel = three_wide({-infinity, -0.5, -3, 0, 8, no_value});
    const std::vector<std::uint8_t> ranks = ranks_of(named("margin"), channel, overlay);
    CHECK(ranks[0] > ranks[2]);
    CHECK(ranks[2] > ranks[1]);
    CHECK(ranks[1] > 0);
    CHECK(std::vector<std::uint8_t>(ranks.begin() + 3, ranks.end()) == std::vector<std::uint8_t>{0, 0, 0});
    overlay.brush = Brush{"margin", 0, 8};
    CHECK(ranks_of(named("margin"), channel, overlay) == std::vector<std::uint8_t>{0, 0, 0, 1, 1, 0});
    overlay.brush->measurement = "depth";
    CHECK(ranks_of(named("margin"), channel, overlay) == ranks);
}

TEST_CASE("a pixel is at least three of the screen's, at any zoom") {
    CHECK(side_to_be_seen(60) == 1);
    CHECK(side_to_be_seen(3) == 1);
    for (double zoom = least_zoom; zoom < 3; zoom *= 1.1) CHECK(side_to_be_seen(zoom) * zoom >= 3);
}

TEST_CASE("enlarged: as a loop over all pixels draws them, at corners and edges, too") {
    std::mt19937 random(16);
    struct Case {
        int width, height, side;
    };
    for (const Case& each :
         {Case{7, 5, 1}, {7, 5, 2}, {7, 5, 3}, {13, 9, 4}, {13, 9, 6}, {5, 8, 11}, {1, 1, 3}, {1, 6, 192}}) {
        const int width = each.width, height = each.height, side = each.side;
        CAPTURE(width);
        CAPTURE(side);
        // Every rank once at most, so that it is clear which one is seen.
        std::vector<std::uint8_t> ranks(static_cast<std::size_t>(width * height), 0);
        for (std::uint8_t rank = 1; rank <= 4; ++rank) ranks[random() % ranks.size()] = rank;
        const std::vector<std::uint32_t> drawn = enlarged(ranks, static_cast<std::size_t>(width), side);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const auto index = [&](int column, int row) { return static_cast<std::size_t>(row * width + column); };
                std::size_t expected = index(x, y);
                for (int row = 0; row < height; ++row)
                    for (int column = 0; column < width; ++column) {
                        // A square of that side about (column, row) begins (side − 1)/2 before it, rounded down.
                        const int dx = x - column + (side - 1) / 2, dy = y - row + (side - 1) / 2;
                        if (dx < 0 || dy < 0 || dx >= side || dy >= side) continue;
                        if (ranks[index(column, row)] > ranks[expected]) expected = index(column, row);
                    }
                CHECK(drawn[index(x, y)] == expected);
            }
    }
}

// Surface 7 is seen in an L of three pixels:   7 7 .
//                                              7 . .
TEST_CASE("an outline goes around the pixels of a surface, straight as long as it can") {
    const Channel numbers = three_wide({7, 7, 2, 7, no_value, 2});
    const std::vector<PixelBorder> borders = outline(numbers, 7);
    const std::vector<PixelBorder> expected{{{0, 0}, {2, 0}}, {{1, 1}, {2, 1}}, {{0, 2}, {1, 2}},
                                            {{0, 0}, {0, 2}}, {{1, 1}, {1, 2}}, {{2, 0}, {2, 1}}};
    CHECK(borders == expected);
    CHECK(outline(numbers, 5).empty());
    CHECK(outline(three_wide({}), 7).empty());
}
