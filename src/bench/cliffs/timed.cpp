#include "bench/cliffs/timed.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <utility>

#include "bench/cliffs/shapes.hpp"
#include "bench/plain_loop.hpp"
#include "bench/runs.hpp"
#include "bench/trace_certified.hpp"
#include "engine/tile.hpp"
#include "render/pixel.hpp"
#include "render/render.hpp"
#include "render/search/build_engine.hpp"
#include "render/shoot.hpp"

namespace glassbox {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

// Pictures, or lists of rays: the least and the greatest side.
constexpr int least_side = 8, usual_side = 256, side_to_check = 512;

// With fewer rays, what a picture costs besides its rays would count.
constexpr int least_ordinary_side = 32;

/// A scene ready to be timed.
struct Ready {
    Traced traced;
    std::shared_ptr<const engine::Engine> engine;

    explicit Ready(Traced what) : traced(std::move(what)), engine(build_engine(traced.scene, 5)) {}

    Job job(int threads, const std::stop_token& stop) const { return {threads, stop, nullptr, engine}; }

    std::size_t rays() const {
        return traced.rays.empty() ? pixel_count(traced.scene.width, traced.scene.height) : traced.rays.size();
    }

    Work work(const std::stop_token& stop) const {
        return {"", static_cast<double>(rays()), [this, one = job(1, stop)] {
                    if (!traced.rays.empty()) {
                        shoot(traced.scene, {}, traced.rays, one);
                    } else if (!traced.measured.empty()) {
                        const Measurement* const what[]{find_measurement(traced.measured)};
                        measure(traced.scene, {}, what, one);
                    } else {
                        render(traced.scene, {}, one);
                    }
                }};
    }
};

/// With as many rays as can be traced in a quarter of a second, at least some; and the seconds that they took.
std::pair<std::unique_ptr<Ready>, double> of_right_size(const Cliff& cliff, const std::stop_token& stop) {
    constexpr double long_enough = 0.25;
    for (int side = least_side;; side *= 2) {
        auto ready = std::make_unique<Ready>(cliff.make(side));
        const auto start = Clock::now();
        ready->work(stop).run();
        const double seconds = seconds_since(start);
        if (seconds * 4 > long_enough || side == usual_side) return {std::move(ready), seconds};
    }
}

/// What each ray, or each pixel's, meets first.
std::vector<std::uint32_t> answers(const Ready& ready, const Job& job) {
    const Scene& scene = ready.traced.scene;
    if (ready.traced.rays.empty()) {
        NearestHits hits(ready.rays());
        trace_certified(view(scene, {}), scene.width, scene.height, job, hits);
        return hits.surface;
    }
    std::vector<std::uint32_t> surfaces;
    for (const Shot& shot : shoot(scene, {}, ready.traced.rays, job))
        surfaces.push_back(shot.answer == Shot::Answer::hit ? static_cast<std::uint32_t>(shot.surface)
                                                            : engine::no_surface);
    return surfaces;
}

void check(const Ready& ready, std::optional<int> wanted, const std::stop_token& stop, CliffTimes& result) {
    constexpr double enough = 1;        // seconds
    constexpr std::size_t piece = 512;  // rays, evenly from all
    const Job all = ready.job(0, stop);
    const std::vector<std::uint32_t> got = answers(ready, all);
    const std::vector<Ray<double>> rays =
        ready.traced.rays.empty() ? shape::picture_rays(ready.traced.scene) : ready.traced.rays;
    const std::size_t most =
        wanted ? std::min<std::size_t>(rays.size(), static_cast<std::size_t>(*wanted)) : rays.size();
    const std::size_t pieces = (most + piece - 1) / piece, step = rays.size() / std::min(rays.size(), pieces * piece);
    const std::size_t apart = step * pieces;
    const auto start = Clock::now();
    for (std::size_t p = 0; p < pieces && (wanted || p == 0 || seconds_since(start) < enough); ++p) {
        std::vector<std::size_t> places;
        std::vector<Ray<double>> some;
        for (std::size_t i = p * step; i < rays.size() && result.checked + some.size() < most; i += apart) {
            places.push_back(i);
            some.push_back(rays[i]);
        }
        const std::vector<std::uint32_t> met = nearest_by_plain_loop(ready.traced.scene, some, all);
        for (std::size_t k = 0; k < some.size(); ++k) result.wrong += met[k] != got[places[k]];
        result.checked += some.size();
    }
}

}  // namespace

CliffTimes time_cliff(const Cliff& cliff, int runs, std::optional<int> rays_to_check, const std::stop_token& stop) {
    constexpr double too_long = 2;  // seconds
    const auto [ready, seconds] = of_right_size(cliff, stop);
    const int side = static_cast<int>(std::lround(std::sqrt(static_cast<double>(ready->rays()))));
    const Ready ordinary(cliff.make_ordinary(std::max(side, least_ordinary_side)));
    CliffTimes result;
    result.rays = ready->rays();
    if (seconds > too_long) {
        result.ordinary = nanoseconds(time_in_turn({ordinary.work(stop)}, 1)[0]);
        result.this_one = {1e9 * seconds / static_cast<double>(result.rays)};
    } else {
        const Speeds speeds = time_in_turn({ordinary.work(stop), ready->work(stop)}, runs);
        result.ordinary = nanoseconds(speeds[0]);
        result.this_one = nanoseconds(speeds[1]);
    }
    if (rays_to_check) check(Ready(cliff.make(side_to_check)), rays_to_check, stop, result);
    else check(*ready, {}, stop, result);
    return result;
}

}  // namespace glassbox
