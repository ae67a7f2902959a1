#include "viewer/ui/widgets/dialog.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "viewer/ui/widgets/wrapped.hpp"

namespace glassbox {

namespace {

int complete(ImGuiInputTextCallbackData* data) {
    const auto& completed = *static_cast<const std::function<std::string()>*>(data->UserData);
    const std::string text = completed();
    data->DeleteChars(0, data->BufTextLen);
    data->InsertChars(0, text.c_str());
    return 0;
}

/// Whether this is another row than the one that was chosen when the window was last drawn.
bool is_newly_chosen(int number) {
    int& last = *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("chosen row"), -1);
    return std::exchange(last, number) != number || ImGui::IsWindowAppearing();
}

}  // namespace

void draw_dialog(const char* title, bool& shown, float width, float height, const std::function<void()>& content) {
    const ImGuiViewport* const viewport = ImGui::GetMainViewport();
    const float font = ImGui::GetFontSize();
    const ImVec2 corner = viewport->WorkPos, all = viewport->WorkSize;
    const float wide = std::min(width * font, all.x * .95f), most = all.y * .92f;
    ImGui::SetNextWindowPos({corner.x + all.x / 2, corner.y + all.y / 2}, ImGuiCond_Always, {.5f, .5f});
    ImGuiWindowFlags flags = ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoResize;
    if (height > 0) {
        ImGui::SetNextWindowSize({wide, std::min(height * font, most)});
    } else {
        ImGui::SetNextWindowSizeConstraints({wide, 0}, {wide, most});
        flags |= ImGuiWindowFlags_AlwaysAutoResize;
    }
    if (ImGui::Begin(title, &shown, flags)) content();
    ImGui::End();
}

std::string typed_text(const char* hint, const std::string& text, int renewed,
                       const std::function<std::string()>& completed) {
    std::array<char, 4096> typed{};
    std::copy_n(text.data(), std::min(text.size(), typed.size() - 1), typed.data());
    ImGui::PushID(renewed);
    if (!ImGui::IsAnyItemActive() && !ImGui::IsMouseDown(0)) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1);
    ImGui::InputTextWithHint("##typed", hint, typed.data(), typed.size(),
                             completed ? ImGuiInputTextFlags_CallbackCompletion : 0, completed ? complete : nullptr,
                             const_cast<std::function<std::string()>*>(&completed));
    ImGui::PopID();
    return typed.data();
}

bool draw_row(const Frame& frame, std::size_t number, bool chosen, const std::function<void()>& content) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float sign = 1.2f * ImGui::GetFontSize();
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const float right = from.x + ImGui::GetContentRegionAvail().x;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.ChannelsSplit(2);
    list.ChannelsSetCurrent(1);
    ImGui::BeginGroup();
    if (chosen) list.AddText(from, frame.palette.accent, "▸");
    ImGui::Indent(sign);
    content();
    ImGui::Unindent(sign);
    ImGui::EndGroup();
    const ImVec2 to{right, ImGui::GetItemRectMax().y};
    list.ChannelsSetCurrent(0);
    const float margin = style.ItemSpacing.y / 2;
    const ImVec2 low{from.x, from.y - margin}, high{to.x, to.y + margin};
    const bool hovered = ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(low, high);
    if (chosen || hovered)
        list.AddRectFilled(low, high, ImGui::GetColorU32(chosen ? ImGuiCol_FrameBgActive : ImGuiCol_FrameBg),
                           style.FrameRounding);
    list.ChannelsMerge();
    if (chosen && is_newly_chosen(static_cast<int>(number))) ImGui::SetScrollHereY(.5f);
    return hovered && ImGui::IsMouseClicked(0);
}

void draw_lines(const std::string& text, float room) {
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + room);
    ImGui::TextUnformatted(wrapped(text, room).c_str());
    ImGui::PopTextWrapPos();
}

void draw_failure(const Frame& frame, const std::string& text) {
    if (text.empty()) return;
    ImGui::PushStyleColor(ImGuiCol_Text, frame.palette.failed);
    ImGui::TextWrapped("✗ %s", text.c_str());
    ImGui::PopStyleColor();
}

float wrapped_height(const char* text) {
    return ImGui::CalcTextSize(text, nullptr, false, ImGui::GetContentRegionAvail().x).y;
}

}  // namespace glassbox
