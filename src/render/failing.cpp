#include "render/failing.hpp"

#include <algorithm>

#include "render/parameters.hpp"
#include "render/typed.hpp"

namespace glassbox {

std::optional<Setup> failing_setup(const Scene& scene, Setup setup) {
    if (scene.failing.empty()) return {};
    for (const auto& choice : scene.failing) {
        const auto& [name, value, place] = choice;
        const auto parameter =
            std::ranges::find_if(parameters(), [&](const Parameter& each) { return each.name == choice.name; });
        if (parameter == parameters().end()) throw error_at(place, fmt::format("{} is no option", name));
        setup = with_typed(std::move(setup), *parameter, error_at(place, name).what(), value);
    }
    return setup;
}

}  // namespace glassbox
