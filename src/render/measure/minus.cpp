#include "render/measure/minus.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "render/measure/measurements.hpp"

namespace glassbox {

namespace {

/// What a parameter is in that setup, as it is typed; a switch is on or off.
std::string value_of(const Parameter& parameter, const Setup& setup) {
    if (const auto* const flag = std::get_if<bool Options::*>(&parameter.member))
        return part(setup, *flag) ? "on" : "off";
    return written(parameter, setup);
}

/// What the settings are in that setup, each with its name.
std::string listed(const Minus& minus, const Setup& setup, std::string_view is, std::string_view and_then) {
    std::string text;
    for (const Parameter* parameter : minus.told)
        text += fmt::format("{}{}{}{}", text.empty() ? "" : and_then, parameter->name, is, value_of(*parameter, setup));
    return text;
}

}  // namespace

Setup changed_by(const Minus& minus, Setup setup) {
    for (const Parameter* parameter : minus.told) setup = taken_over(std::move(setup), *parameter, minus.setup);
    return setup;
}

std::string written(const Minus& minus) { return listed(minus, minus.setup, ":", ","); }

std::string told_of(const Minus& minus, const Setup& setup) { return listed(minus, setup, " ", ", "); }

std::string why_no_difference(const Measurement& what) {
    if (what.words.empty()) return "";
    return fmt::format("{} is told in words ({}), and words have no difference", what.name,
                       fmt::join(what.words, ", "));
}

std::string difference_name(std::string_view what, const Minus& minus) {
    std::string name = fmt::format("{}-minus-{}", what, written(minus));
    std::ranges::replace(name, ',', '+');
    return name;
}

std::string difference_file_name(std::string_view what, const Minus& minus) {
    std::string name = difference_name(what, minus);
    std::ranges::replace(name, ':', '-');
    return name;
}

}  // namespace glassbox
