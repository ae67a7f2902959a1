#pragma once
#include <optional>
#include <stop_token>
#include <string>

namespace glassbox {

struct CliffRequest {
    int runs = 5;
    std::optional<int> rays_to_check;  ///< none: as many as the plain loop can do in a second
    std::string only;                  ///< the cases whose names contain this
    bool markdown = false;             ///< as a table for docs/speed-cliffs.md
};

/// Times each cliff beside an ordinary scene, and prints a table. Returns whether all answers that were checked are
/// right. Throws Cancelled.
bool bench_cliffs(const CliffRequest& request, const std::stop_token& stop);

}  // namespace glassbox
