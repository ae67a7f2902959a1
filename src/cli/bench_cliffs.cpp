#include "cli/bench_cliffs.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <vector>

#include "bench/cliffs/cliff.hpp"
#include "bench/cliffs/timed.hpp"
#include "bench/runs.hpp"
#include "cli/progress.hpp"
#include "engine/kernels.hpp"
#include "render/typed.hpp"
#include "scene/suggestion.hpp"

namespace glassbox {

namespace {

/// "12.3", "1,234": three digits, or all before the point.
std::string short_number(double number) {
    return number < 100 ? fmt::format("{:.3g}", number) : fmt::format("{:.0f}", number);
}

std::string ratio_text(const Spread& ratios) {
    return fmt::format("{} ({} ... {})", short_number(ratios.median), short_number(ratios.least),
                       short_number(ratios.greatest));
}

struct Row {
    std::string name, ordinary_name, rays, ordinary, this_one, ratio, goal, reached, checked;
};

Row row_of(const Cliff& cliff, const CliffTimes& times, int runs) {
    const Spread ratios = ratio(times.this_one, times.ordinary);
    return {cliff.name,
            cliff.ordinary,
            fmt::to_string(times.rays) + (static_cast<int>(times.this_one.size()) < runs ? ", once" : ""),
            short_number(spread(times.ordinary).median),
            short_number(spread(times.this_one).median),
            ratio_text(ratios),
            fmt::format("{:g}", cliff.goal),
            ratios.median <= cliff.goal ? "yes" : "no",
            fmt::format("{} of {}", times.wrong, times.checked)};
}

void print(const Row& row, bool markdown) {
    if (markdown)
        fmt::print("| {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", row.name, row.ordinary_name, row.rays,
                   row.ordinary, row.this_one, row.ratio, row.goal, row.reached, row.checked);
    else
        fmt::print("{:<58} {:>10} {:>9} {:>9}  {:<28} {:>4} {:>7}  {}\n", row.name, row.rays, row.ordinary,
                   row.this_one, row.ratio, row.goal, row.reached, row.checked);
    std::fflush(stdout);
}

}  // namespace

bool bench_cliffs(const CliffRequest& request, const std::stop_token& stop) {
    std::vector<Cliff> cliffs = all_cliffs();
    std::erase_if(cliffs, [&](const Cliff& cliff) { return cliff.name.find(request.only) == std::string::npos; });
    if (cliffs.empty()) throw wrong("--only", fmt::format("no case's name contains '{}'", request.only));
    if (!request.markdown)
        fmt::print(
            "Nanoseconds a ray, on one thread, beside an ordinary scene of the same size; {} of each, in turn: "
            "median (least ... greatest)\nVectors are {}. Wrong is what differs from the plain certified loop.\n\n",
            counted(static_cast<std::size_t>(request.runs), "run"), engine::vectors_used());
    print({"case", "beside", "rays", "ordinary", "this", "ratio", "goal", "reached", "wrong"}, request.markdown);
    if (request.markdown) fmt::print("|---|---|---|---|---|---|---|---|---|\n");
    std::size_t reached = 0, wrong = 0;
    {
        Progress progress("timing", static_cast<std::int64_t>(cliffs.size()));
        for (const Cliff& cliff : cliffs) {
            const CliffTimes times = time_cliff(cliff, request.runs, request.rays_to_check, stop);
            const Row row = row_of(cliff, times, request.runs);
            print(row, request.markdown);
            reached += row.reached == "yes";
            wrong += times.wrong;
            ++progress.done();
        }
    }
    fmt::print("\n{} of {} reach their goals; wrong answers: {}\n", reached, cliffs.size(), wrong);
    return wrong == 0;
}

}  // namespace glassbox
