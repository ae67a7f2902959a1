// A fuzzer: draws random scenes, runs the program on each in every way, and compares the answers with the oracle's.
//
//   test_fuzz                      a short run, always the same
//   test_fuzz --seeds 1000..2000   those seeds; one alone: --seeds 1234
//   test_fuzz --minutes 60         from a seed of the clock's on
//   … --kind grazing               scenes of one kind only
//   … --share 3                    each scene by a third of the ways, which third changing from seed to seed
//   … --out FOLDER                 the smallest scene of each fault into files there
//
// Run two at once, with seeds of their own, to use two cores.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "scene/error.hpp"
#include "shrink.hpp"

namespace glassbox::fuzz {

namespace {

using Clock = std::chrono::steady_clock;

struct Request {
    std::uint64_t from = 1, to = 0;
    std::optional<double> minutes;
    std::uint64_t share = 1;  ///< each scene by one route in so many
    std::string kind, folder;
};

/// So many faults of one kind in scenes of one kind are shown whole; the others are counted.
constexpr int shown_whole = 2;

class Run {
public:
    explicit Run(Request request) : request_(std::move(request)) {}

    /// 0 if nothing is wrong.
    int operator()() {
        if (request_.share > routes_.size()) {
            fmt::print(stderr, "test_fuzz: error: --share {}: there are {} routes; each scene must have one\n",
                       request_.share, routes_.size());
            return 2;
        }
        const auto begin = Clock::now();
        auto told = begin;
        if (request_.kind.empty())
            for (const Drawn& drawn : known()) try_scene(drawn, "none");
        for (std::uint64_t seed = request_.from; !is_over(seed, begin); ++seed) {
            try_scene(draw(seed, request_.kind), fmt::to_string(seed), seed);
            if (Clock::now() - told < std::chrono::seconds(30)) continue;
            told = Clock::now();
            fmt::print("… seed {}, {}\n", seed, sums());
            std::fflush(stdout);
        }
        const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
        fmt::print("Seeds from {} on: {}, in {:.1f} s.\n", request_.from, sums(), seconds);
        for (const auto& [kind, count] : of_kind_)
            fmt::print("  {:<10} {:>6} scenes, {:>9} pixels, {:3.0f}% of them hits\n", kind, count.scenes, count.pixels,
                       100.0 * static_cast<double>(count.hits) / static_cast<double>(count.pixels));
        for (const auto& [what, count] : refusals_) fmt::print("  refused {} times, as: {}\n", count, what);
        for (const auto& [what, count] : faults_) fmt::print("  WRONG in {} scenes: {}\n", count, what);
        return faults_.empty() ? 0 : 1;
    }

private:
    struct Count {
        int scenes = 0;
        std::size_t pixels = 0, hits = 0;
    };

    bool is_over(std::uint64_t seed, Clock::time_point begin) const {
        if (!request_.minutes) return seed > request_.to;
        return Clock::now() - begin > std::chrono::duration<double, std::ratio<60>>(*request_.minutes);
    }

    std::string sums() const {
        return fmt::format("{} scenes, {} pixels, {} rays, each by {} of {} routes; faults in {} scenes", scenes_,
                           pixels_, rays_, routes_.size() / request_.share, routes_.size(), wrong_scenes_);
    }

    /// Tries a scene by all routes, or by those whose `turn` it is.
    void try_scene(const Drawn& drawn, const std::string& seed, std::optional<std::uint64_t> turn = {}) {
        ++scenes_;
        std::optional<Trial> trial;
        try {
            trial.emplace(drawn);
        } catch (const Error& error) {
            ++refusals_[without_place(error.what())];
            return;
        }
        pixels_ += trial->pixels();
        rays_ += trial->rays().size();
        Count& count = of_kind_[drawn.kind];
        ++count.scenes;
        count.pixels += trial->pixels();
        count.hits +=
            static_cast<std::size_t>(std::count_if(trial->pixel_answers().begin(), trial->pixel_answers().end(),
                                                   [](const auto& answer) { return !answer.met.empty(); }));
        std::set<std::string> kinds_here;  // shown by the first route that has such a fault
        for (std::size_t i = 0; i < routes_.size(); ++i) {
            if (turn && (i + *turn) % request_.share != 0) continue;
            const Route& route = routes_[i];
            const std::optional<Fault> fault = check(route, *trial);
            if (!fault) continue;
            ++faults_[fault->kind + ", " + route.name];
            if (kinds_here.insert(fault->kind).second && ++shown_[drawn.kind + fault->kind] <= shown_whole)
                show(seed, drawn, *fault, route);
        }
        wrong_scenes_ += !kinds_here.empty();
    }

    static std::optional<Fault> check(const Route& route, const Trial& trial) {
        try {
            return route.check(trial);
        } catch (const std::exception& error) {
            return Fault{"exception", {}, {}, "none", error.what()};
        }
    }

    /// What is wrong, without the numbers of that one scene.
    static std::string without_place(const std::string& message) {
        const std::size_t error = message.find("error: ");
        std::string text;
        for (const char c : message.substr(error == message.npos ? 0 : error + 7))
            if (c < '0' || c > '9') text += c;
            else if (text.empty() || text.back() != '#') text += '#';
        return text.substr(0, text.find_first_of("#.")) + "…" + text.substr(std::min(text.find(';'), text.size()));
    }

    /// The smallest scene with the fault, what is true there, and what each route says.
    void show(const std::string& seed, const Drawn& drawn, const Fault& fault, const Route& route) {
        const auto [least, its_fault] = shrink(drawn, fault, route);
        const Trial trial(least);
        fmt::print("\nWRONG, seed {} ({}): {} by {}\n", seed, drawn.kind, its_fault.kind, route.name);
        if (its_fault.pixel) fmt::print("  pixel     {},{}\n", trial.x(*its_fault.pixel), trial.y(*its_fault.pixel));
        std::map<std::string, std::vector<std::string>> wrong;
        std::size_t right = 0;
        for (const Route& other : routes_) {
            if (const std::optional<Fault> also = check(other, trial))
                wrong[fmt::format("{}\n    expected  {}\n    got       {}", also->kind, also->expected, also->got)]
                    .push_back(other.name);
            else ++right;
        }
        for (const auto& [what, names] : wrong) fmt::print("  {}\n    by        {}\n", what, fmt::join(names, "; "));
        fmt::print("  right by {} other routes\n", right);
        const std::string toml = to_toml(least);
        std::vector<oracle::Ray> rays = least.rays;
        if (rays.empty() && its_fault.ray) rays.push_back(to_oracle(trial.rays()[*its_fault.ray]));
        const std::string csv = rays.empty() ? "" : to_csv(rays);
        fmt::print("  glassbox {} SCENE\n{}{}\n", route.command, toml, csv);
        std::fflush(stdout);
        if (!request_.folder.empty()) keep(fmt::format("{}-{}", seed, its_fault.kind), toml, csv);
    }

    void keep(std::string name, const std::string& toml, const std::string& csv) const {
        std::replace(name.begin(), name.end(), ' ', '-');
        const std::filesystem::path folder = request_.folder;
        std::filesystem::create_directories(folder);
        std::ofstream(folder / (name + ".toml")) << toml;
        if (!csv.empty()) std::ofstream(folder / (name + ".csv")) << csv;
    }

    Request request_;
    std::vector<Route> routes_ = all_routes();
    std::size_t scenes_ = 0, pixels_ = 0, rays_ = 0, wrong_scenes_ = 0;
    std::map<std::string, Count> of_kind_;
    std::map<std::string, int> faults_, shown_, refusals_;
};

/// The number that a text is, all of it.
template <class Number>
std::optional<Number> number(std::string_view text) {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return {};
    return value;
}

std::optional<Request> read(int argc, char** argv) {
    Request request;
#ifdef NDEBUG
    request.to = 100;
#else
    request.to = 10;  // everything is checked at every step
#endif
    for (int i = 1; i < argc; i += 2) {
        const std::string_view name = argv[i], value = i + 1 < argc ? argv[i + 1] : "";
        if (name == "--seeds") {
            const std::size_t dots = value.find("..");
            const auto from = number<std::uint64_t>(value.substr(0, dots));
            const auto to = dots == value.npos ? from : number<std::uint64_t>(value.substr(dots + 2));
            if (!from || !to) return {};
            request.from = *from;
            request.to = *to;
        } else if (name == "--minutes") {
            request.minutes = number<double>(value);
            if (!request.minutes) return {};
            request.from = static_cast<std::uint64_t>(std::chrono::system_clock::now().time_since_epoch().count());
        } else if (name == "--share") {
            const auto share = number<std::uint64_t>(value);
            if (!share || *share == 0) return {};
            request.share = *share;
        } else if (name == "--kind") {
            const auto names = kinds();
            if (std::find(names.begin(), names.end(), value) == names.end()) return {};
            request.kind = value;
        } else if (name == "--out" && !value.empty()) {
            request.folder = value;
        } else {
            return {};
        }
    }
    return request;
}

int run(int argc, char** argv) {
    const std::optional<Request> request = read(argc, argv);
    if (request) return Run(*request)();
    fmt::print(
        stderr,
        "usage: test_fuzz [--seeds FROM..TO | --minutes N] [--kind NAME] [--share N] [--out FOLDER]\nkinds: {}\n",
        fmt::join(kinds(), " "));
    return 2;
}

}  // namespace

}  // namespace glassbox::fuzz

int main(int argc, char** argv) { return glassbox::fuzz::run(argc, argv); }
