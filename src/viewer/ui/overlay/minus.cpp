#include "render/typed.hpp"
#include "viewer/model/overlay/subtracted.hpp"
#include "viewer/ui/overlay/parts.hpp"
#include "viewer/ui/widgets/edit.hpp"

namespace glassbox {

void draw_minus(const Frame& frame) {
    Overlay& overlay = frame.state.overlay;
    const std::string present = overlay.minus ? written(*overlay.minus) : "nothing";
    choice(frame, "minus the same by", minus_choices(), present,
           [&](const std::optional<Minus>& minus) { subtract(overlay, minus); });
    if (!overlay.minus) return;
    if (const std::string why = why_not_subtracted(overlay); !why.empty())
        return faint(frame, "Nothing is subtracted: " + why + ".");
    const Setup& now = frame.state.setup.now();
    if (changed_by(*overlay.minus, now) == now)
        faint(frame, "The picture is computed so itself: nothing can differ. Choose another scalar or rule.");
}

}  // namespace glassbox
