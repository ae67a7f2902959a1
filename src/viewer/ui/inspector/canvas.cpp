#include "viewer/ui/inspector/canvas.hpp"

#include <algorithm>
#include <cmath>

namespace glassbox {

namespace {

ImVec2 between(ImVec2 a, ImVec2 b, float part) { return {a.x + (b.x - a.x) * part, a.y + (b.y - a.y) * part}; }

}  // namespace

ImU32 to_color(Rgb color, int opacity) { return IM_COL32(color.red, color.green, color.blue, opacity); }

Canvas::Canvas(const Frame& frame, ImVec2 size)
    : palette_(frame.palette),
      list_(ImGui::GetWindowDrawList()),
      corner_(ImGui::GetCursorScreenPos()),
      size_(std::max(size.x, 1.f), std::max(size.y, 1.f)),
      unit_(ImGui::GetFontSize()),
      pixel_(std::max(1.f, ImGui::GetFontSize() / 16)) {
    ImGui::Dummy(size_);
    list_->PushClipRect(corner_, at(size_.x, size_.y), true);
}

Canvas::~Canvas() { list_->PopClipRect(); }

void Canvas::line(ImVec2 from, ImVec2 to, ImU32 color, float thickness) const {
    list_->AddLine(from, to, color, thickness * pixel_);
}

void Canvas::dashed(ImVec2 from, ImVec2 to, ImU32 color) const {
    const float length = std::hypot(to.x - from.x, to.y - from.y);
    const int dashes = std::clamp(static_cast<int>(length / (unit_ * .5f)), 1, 400);
    for (int i = 0; i < dashes; ++i) {
        const auto place = [&](float of_dash) {
            return between(from, to, (static_cast<float>(i) + of_dash) / static_cast<float>(dashes));
        };
        line(place(.2f), place(.8f), color);
    }
}

void Canvas::arrow_head(ImVec2 from, ImVec2 tip, ImU32 color) const {
    const float length = std::hypot(tip.x - from.x, tip.y - from.y);
    if (!(length > 0)) return;
    const ImVec2 along{(tip.x - from.x) / length, (tip.y - from.y) / length};
    const float size = unit_ * .5f, wide = size * .4f;
    const ImVec2 back{tip.x - along.x * size, tip.y - along.y * size};
    list_->AddTriangleFilled(tip, {back.x - along.y * wide, back.y + along.x * wide},
                             {back.x + along.y * wide, back.y - along.x * wide}, color);
}

void Canvas::arrow(ImVec2 from, ImVec2 to, ImU32 color, float thickness) const {
    const float length = std::hypot(to.x - from.x, to.y - from.y);
    if (!(length > 0)) return;
    line(from, between(from, to, std::max(0.f, 1 - unit_ * .4f / length)), color, thickness);
    arrow_head(from, to, color);
}

void Canvas::dot(ImVec2 middle, ImU32 color, bool filled) const {
    if (filled) list_->AddCircleFilled(middle, unit_ * .22f, color, 24);
    else list_->AddCircle(middle, unit_ * .34f, color, 24, 1.5f * pixel_);
}

void Canvas::box(ImVec2 low, ImVec2 high, ImU32 fill) const {
    list_->AddRectFilled(low, high, fill);
    list_->AddRect(low, high, palette_.line, 0.f, 0, pixel_);
}

float Canvas::text_width(std::string_view text) const {
    return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x;
}

void Canvas::text(ImVec2 where, ImVec2 anchor, ImU32 color, std::string_view text) const {
    const ImVec2 extent = ImGui::CalcTextSize(text.data(), text.data() + text.size());
    const ImVec2 far = at(size_.x, size_.y);
    const ImVec2 place{std::max(corner_.x, std::min(where.x - anchor.x * extent.x, far.x - extent.x)),
                       std::max(corner_.y, std::min(where.y - anchor.y * extent.y, far.y - extent.y))};
    list_->AddText(place, color, text.data(), text.data() + text.size());
}

}  // namespace glassbox
