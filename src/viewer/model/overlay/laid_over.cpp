#include "viewer/model/overlay/laid_over.hpp"

#include <algorithm>
#include <cmath>

#include "viewer/model/overlay/subtracted.hpp"

namespace glassbox {

const MeasuredChannels* last_laid_over(const ViewerState& state, const Results& results) {
    const MeasuredChannels* const overlay = results.overlay.get();
    const bool same = overlay && overlay->what->name == name_of(state.overlay) && overlay->scene == state.scene;
    return same ? overlay : nullptr;
}

const MeasuredChannels* laid_over(const ViewerState& state, const Results& results) {
    const MeasuredChannels* const overlay = last_laid_over(state, results);
    return overlay && overlay->setup == state.setup.now() ? overlay : nullptr;
}

const MeasuredChannels* wholly_laid_over(const ViewerState& state, const Results& results) {
    const MeasuredChannels* const overlay = laid_over(state, results);
    return overlay && overlay->factor == 1 ? overlay : nullptr;
}

void pin_in_view(ViewerState& state, Pixel pixel) {
    pin(state, pixel);
    if (state.fit == Fit::none) state.view = showing(state.view, pixel, state.area);
}

void pin_next_worst(ViewerState& state, const Results& results, bool forward) {
    if (state.overlay.measurement.empty()) state.overlay.measurement = "verdict";
    const MeasuredChannels* const overlay = wholly_laid_over(state, results);
    if (!overlay) return;
    const PixelList& worst = overlay->found.worst;
    if (const auto next = next_worst(worst, state.pinned, forward)) pin_in_view(state, worst.pixels[*next]);
}

const Brush* brush_of(const Overlay& overlay) {
    return overlay.brush && overlay.brush->measurement == name_of(overlay) ? &*overlay.brush : nullptr;
}

bool is_brushed(const Brush& brush, double value) { return value >= brush.from && value <= brush.to; }

std::vector<std::uint8_t> ranks_of(const Measurement& what, const Channel& channel, const Overlay& overlay) {
    const Brush* const brush = brush_of(overlay);
    const auto rank = [&](double value) -> std::uint8_t {
        if (brush) return is_brushed(*brush, value) ? 1 : 0;
        if (!what.alarms(value)) return 0;
        return what.words.empty() ? static_cast<std::uint8_t>(std::min(255.0, 1 + 16 * std::abs(value))) : 1;
    };
    std::vector<std::uint8_t> ranks(channel.values.size());
    std::ranges::transform(channel.values, ranks.begin(), rank);
    return ranks;
}

std::string_view alarm_word(const Measurement& what) { return what.words.empty() ? "undecided" : "wrong"; }

}  // namespace glassbox
