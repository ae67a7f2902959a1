#include "viewer/ui/widgets/slider.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>

#include "explain/phrases.hpp"
#include "viewer/ui/widgets/wrapped.hpp"

namespace glassbox {

namespace {

std::string number_as_written(double value, const char* format) {
    std::array<char, 400> text{};
    std::snprintf(text.data(), text.size(), format, value);
    return text.data();
}

}  // namespace

bool slider(const char* id, const std::string& name, double& value, const SliderRange& range, float room_on_right) {
    const auto& [least, most, format, is_logarithmic] = range;
    draw_wrapped(name + ": " + with_minus(number_as_written(value, format)));
    ImGui::SetNextItemWidth(std::max(ImGui::GetFontSize(), ImGui::GetContentRegionAvail().x - room_on_right));
    // Without a format Dear ImGui writes no number over the handle, and rounds none.
    const bool moved = ImGui::SliderScalar(id, ImGuiDataType_Double, &value, &least, &most, "",
                                           is_logarithmic ? ImGuiSliderFlags_Logarithmic : 0);
    if (!moved || ImGui::GetIO().WantTextInput) return moved;  // a number that was typed stays as it is
    const std::string written = number_as_written(value, format);
    value = std::strtod(written.c_str(), nullptr);
    return true;
}

}  // namespace glassbox
