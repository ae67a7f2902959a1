#include "viewer/model/overlay/subtracted.hpp"

#include <fmt/format.h>

#include <type_traits>
#include <utility>

#include "render/measure/measurements.hpp"
#include "render/typed.hpp"

namespace glassbox {

namespace {

/// Why the viewer shows no difference of that measurement; empty if it does.
std::string why_not(const Measurement& what) {
    if (what.components.empty()) return why_no_difference(what);
    return fmt::format("{} has {} components; glassbox measure --minus writes their differences", what.name,
                       what.components.size());
}

}  // namespace

const Minus* subtracted(const Overlay& overlay) {
    const Measurement* const what = find_measurement(overlay.measurement);
    return what && overlay.minus && why_not(*what).empty() ? &*overlay.minus : nullptr;
}

std::string why_not_subtracted(const Overlay& overlay) {
    const Measurement* const what = find_measurement(overlay.measurement);
    return what && overlay.minus ? why_not(*what) : "";
}

std::string name_of(const Overlay& overlay) {
    const Minus* const minus = subtracted(overlay);
    return minus ? difference_name(overlay.measurement, *minus) : overlay.measurement;
}

void subtract(Overlay& overlay, const std::optional<Minus>& minus) {
    if (overlay.minus == minus) return;
    overlay.minus = minus;
    overlay.range.reset();
    overlay.spacing.reset();
    overlay.brush.reset();
}

std::vector<MinusChoice> minus_choices() {
    std::vector<MinusChoice> all{{"nothing", {}, "the measurement itself is shown"}};
    const Setup defaults;
    for (const Parameter& parameter : parameters()) {
        if (parameter.subject != Subject::computing) continue;
        with_value(parameter, defaults, [&](const auto& by_default) {
            using Value = std::remove_cvref_t<decltype(by_default)>;
            if constexpr (is_choice<Value>)
                for (const auto& one : choices<Value>) {
                    Minus chosen = minus("minus", fmt::format("{}:{}", parameter.name, one.name));
                    all.push_back({written(chosen), std::move(chosen), one.help});
                }
        });
    }
    return all;
}

}  // namespace glassbox
