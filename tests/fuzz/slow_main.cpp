// A fuzzer for time: draws random scenes of hard kinds, and tells which take how many times as long a ray as an
// ordinary scene with as many surfaces.
//
//   test_fuzz_time                      a short run, always the same: only that scenes are read and traced
//   test_fuzz_time --seeds 1000..2000   those seeds
//   … --above 20                        tells those that take at least so many times as long (10)
//   … --out FOLDER                      these, with as few surfaces as still do, into files there
//
// What it tells depends on the machine, and on what else that does.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "read_drawn.hpp"
#include "render/render.hpp"
#include "render/search/build_engine.hpp"
#include "render/view.hpp"
#include "scene/error.hpp"
#include "scene/scene_file.hpp"
#include "slow.hpp"

namespace glassbox::fuzz {

namespace {

using Clock = std::chrono::steady_clock;

struct TimeRequest {
    std::uint64_t from = 1, to = 30;
    double above = 10;
    std::string folder = {};
};

/// Nanoseconds a ray of its picture, at the least of some runs, on one thread. Slow ones are drawn smaller.
double nanoseconds_a_ray(const Drawn& drawn) {
    constexpr double long_enough = 0.02;  // seconds
    const Scene scene = read_drawn(drawn);
    const Job job{1, {}, nullptr, build_engine(scene, 5, 1)};
    const auto seconds = [&](const Scene& picture) {
        const auto start = Clock::now();
        render(picture, {}, job);
        return std::chrono::duration<double>(Clock::now() - start).count();
    };
    for (int side = 8;; side *= 2) {
        const Scene picture = resized(scene, side, side);  // the same view, its pixels coarser
        double least = seconds(picture);
        if (4 * least < long_enough && side < scene.width) continue;
        if (least < long_enough)
            for (int run = 0; run < 4; ++run) least = std::min(least, seconds(picture));
        return 1e9 * least / (1.0 * side * side);
    }
}

class TimeRun {
public:
    explicit TimeRun(TimeRequest request) : request_(std::move(request)) {}

    int operator()() {
        for (std::uint64_t seed = request_.from; seed <= request_.to; ++seed) try_seed(seed);
        std::sort(told_.rbegin(), told_.rend());
        fmt::print("{} scenes; {} take at least {:g} times as long a ray as ordinary ones of that size; {} refused\n",
                   tried_, told_.size(), request_.above, refused_);
        for (const auto& [ratio, line] : told_) fmt::print("  ×{:<8.3g} {}\n", ratio, line);
        // Scenes that the program does not read would be no test; a few numbers are too large for it.
        return refused_ * 4 > tried_ ? 1 : 0;
    }

private:
    void try_seed(std::uint64_t seed) {
        ++tried_;
        try {
            const Drawn drawn = draw_slow(seed);
            const double its_ratio = ratio(drawn);
            if (!(its_ratio >= request_.above)) return;
            told_.emplace_back(its_ratio, fmt::format("seed {}: {}", seed, drawn.kind));
            if (!request_.folder.empty()) keep(seed, drawn, its_ratio);
        } catch (const Error&) {
            ++refused_;
        }
    }

    double ratio(const Drawn& drawn) {
        const auto rounded = [](std::size_t count) {
            return count == 0 ? count : std::size_t{1} << std::lround(std::log2(count));
        };
        const std::pair size{rounded(drawn.surfaces.spheres.size()), rounded(drawn.surfaces.triangles.size())};
        const auto [known, is_new] = ordinary_.try_emplace(size);
        if (is_new) known->second = nanoseconds_a_ray(draw_ordinary(size.first, size.second, 64));
        return nanoseconds_a_ray(drawn) / known->second;
    }

    /// Writes the scene without surfaces that do not matter, as many as can be found in some seconds: it must keep half
    /// of its ratio.
    void keep(std::uint64_t seed, Drawn drawn, double its_ratio) {
        const auto end = Clock::now() + std::chrono::seconds(5);
        const auto shrink = [&](auto list_of) {
            for (std::size_t count = (drawn.surfaces.*list_of).size() / 2; count > 0; count /= 2)
                for (std::size_t from = 0; from < (drawn.surfaces.*list_of).size() && Clock::now() < end;) {
                    Drawn fewer = drawn;
                    auto& list = fewer.surfaces.*list_of;
                    const auto begin = list.begin() + static_cast<std::ptrdiff_t>(from);
                    list.erase(begin, begin + static_cast<std::ptrdiff_t>(std::min(count, list.size() - from)));
                    if (fewer.surfaces.size() > 0 && ratio(fewer) > its_ratio / 2) drawn = std::move(fewer);
                    else from += count;
                }
        };
        shrink(&oracle::Surfaces::spheres);
        shrink(&oracle::Surfaces::triangles);
        std::filesystem::create_directories(request_.folder);
        const auto file = std::filesystem::path(request_.folder) / fmt::format("{}.toml", seed);
        std::ofstream(file) << fmt::format("# ×{:.3g}: {}\n", its_ratio, drawn.kind) << to_toml(drawn);
    }

    TimeRequest request_;
    std::map<std::pair<std::size_t, std::size_t>, double> ordinary_;
    std::vector<std::pair<double, std::string>> told_;
    std::size_t tried_ = 0, refused_ = 0;
};

template <class Number>
bool read_number(std::string_view text, Number& value) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size();
}

std::optional<TimeRequest> read_request(int argc, char** argv) {
    TimeRequest request;
#ifndef NDEBUG
    request.to = 5;  // everything is checked at every step
#endif
    for (int i = 1; i < argc; i += 2) {
        const std::string_view name = argv[i], value = i + 1 < argc ? argv[i + 1] : "";
        if (name == "--seeds") {
            const std::size_t dots = value.find("..");
            const std::string_view last = dots == value.npos ? value : value.substr(dots + 2);
            if (!read_number(value.substr(0, dots), request.from) || !read_number(last, request.to)) return {};
        } else if (name == "--above") {
            if (!read_number(value, request.above)) return {};
        } else if (name == "--out" && !value.empty()) {
            request.folder = value;
        } else {
            return {};
        }
    }
    return request;
}

int time_scenes(int argc, char** argv) {
    const std::optional<TimeRequest> request = read_request(argc, argv);
    if (request) return TimeRun(*request)();
    fmt::print(stderr, "usage: test_fuzz_time [--seeds FROM..TO] [--above RATIO] [--out FOLDER]\n");
    return 2;
}

}  // namespace

}  // namespace glassbox::fuzz

int main(int argc, char** argv) { return glassbox::fuzz::time_scenes(argc, argv); }
