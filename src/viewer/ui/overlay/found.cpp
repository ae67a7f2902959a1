#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "output/legend_number.hpp"
#include "output/value_words.hpp"
#include "viewer/model/overlay/laid_over.hpp"
#include "viewer/ui/overlay/parts.hpp"
#include "viewer/ui/widgets/buttons.hpp"

namespace glassbox {

namespace {

/// A heading with the count, then a button for each of the first pixels.
void list(const Frame& frame, const MeasuredChannels& measured, const char* heading, const PixelList& found) {
    constexpr std::size_t most = 6;
    ImGui::TextWrapped("%s", heading);
    if (found.pixels.empty()) return;
    ImGui::PushID(heading);
    const std::size_t shown = std::min(most, found.pixels.size());
    for (std::size_t i = 0; i < shown; ++i) {
        const Pixel pixel = found.pixels[i];
        const std::string label = fmt::format("({}, {}) {}", pixel.x, pixel.y,
                                              value_in_short(*measured.what, measured.channels.front().at(pixel)));
        if (i > 0) flow(label.c_str());
        if (toggle(label.c_str(), frame.state.pinned == pixel)) pin_in_view(frame.state, pixel);
    }
    ImGui::PopID();
    if (const std::int64_t more = found.count - static_cast<std::int64_t>(shown); more > 0)
        faint(frame, fmt::format("and {} more", more));
}

}  // namespace

void draw_found(const Frame& frame, const MeasuredChannels& measured) {
    const Measurement& what = *measured.what;
    const FoundPixels& found = measured.found;
    if (measured.factor > 1 || what.scale == Scale::direction) return;
    ImGui::Spacing();
    ImGui::TextUnformatted("Worst pixels");
    ImGui::SameLine();
    const Results& results = frame.results;
    if (button_if(!found.worst.pixels.empty(), "◀ ,")) pin_next_worst(frame.state, results, false);
    tip("The one before (,)");
    ImGui::SameLine();
    if (button_if(!found.worst.pixels.empty(), ". ▶")) pin_next_worst(frame.state, results, true);
    tip("The next one (.)");
    if (what.alarm != Alarm::none) {
        const std::string word(alarm_word(what));
        const std::string heading = found.alarming.count == 0
                                        ? fmt::format("no pixel is {}", word)
                                        : fmt::format("{}: {}", word, pixels(found.alarming.count));
        list(frame, measured, heading.c_str(), found.alarming);
    }
    if (!what.words.empty() || found.least.count == 0) return;
    list(frame, measured, "least", found.least);
    list(frame, measured, "greatest", found.greatest);
}

}  // namespace glassbox
