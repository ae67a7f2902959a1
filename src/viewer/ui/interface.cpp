#include "viewer/ui/interface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "viewer/model/state/keys.hpp"
#include "viewer/model/state/playing.hpp"
#include "viewer/model/story/predicting.hpp"
#include "viewer/model/work/watching.hpp"

namespace glassbox {

namespace {

constexpr double forever = std::numeric_limits<double>::infinity();

/// Advances what moves by itself: the steps that are played, the picture that is watched.
void advance(ViewerState& state, const Results& results, double seconds) {
    go_on_watching(state, seconds);
    go_on_playing(state, results, seconds);
    state.notice = later(state.notice, seconds);
}

/// A bar between two parts that can be dragged; returns by how many pixels it was dragged.
float divider(const char* name, ImVec2 size, bool upright) {
    ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0, 0, 0, 0));
    ImGui::Button(name, size);
    ImGui::PopStyleColor();
    if (ImGui::IsItemHovered() || ImGui::IsItemActive())
        ImGui::SetMouseCursor(upright ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
    if (!ImGui::IsItemActive()) return 0;
    return upright ? ImGui::GetIO().MouseDelta.x : ImGui::GetIO().MouseDelta.y;
}

struct PageTab {
    Page page;
    const char* title;
    void (*draw)(const Frame&);
};
constexpr PageTab pages[] = {
    {Page::inspector, "Inspector", draw_inspector},
    {Page::steps, "Steps", draw_steps},
    {Page::overlay, "Overlay", draw_overlay},
    {Page::controls, "Controls", draw_controls},
    {Page::mine, "Mine", draw_mine},
};

void draw_pages(const Frame& frame) {
    if (!ImGui::BeginTabBar("pages")) return;
    static_assert(std::size(pages) == 5);
    const Page wanted = frame.state.page;
    const bool is_shown = frame.state.page_shown == wanted;
    for (const PageTab& tab : pages) {
        // Bring a page chosen by a key or a script to the front; a click on a tab does so itself.
        const bool bring = wanted == tab.page && !is_shown;
        if (!ImGui::BeginTabItem(tab.title, nullptr, bring ? ImGuiTabItemFlags_SetSelected : 0)) continue;
        if (is_shown || bring) frame.state.page = frame.state.page_shown = tab.page;
        ImGui::BeginChild(tab.title);
        tab.draw(frame);
        ImGui::EndChild();
        ImGui::EndTabItem();
    }
    ImGui::EndTabBar();
}

}  // namespace

Interface::Interface(ViewerState state, float scale, const std::function<void()>& wake)
    : state_(std::move(state)), scale_(scale), wake_(wake), background_(wake) {}

void Interface::prepare() {
    const float text_size = state_.appearance.text_size * scale_;
    if (text_size == loaded_text_size_ && state_.appearance.dark == loaded_dark_) return;
    if (text_size != loaded_text_size_) fonts_ = load_fonts(text_size);
    palette_ = apply_theme(state_.appearance, text_size);
    loaded_text_size_ = text_size;
    loaded_dark_ = state_.appearance.dark;
}

double Interface::draw(const Input& input) {
    for (const KeyPress& press : input.keys)
        if (!ImGui::GetIO().WantTextInput || (takes_keyboard(state_) && !press.control)) obey(press, state_, results_);
    open_dropped(state_, input.dropped);
    watch_files();
    const double seconds = std::clamp(input.time - std::exchange(last_time_, input.time), 0.0, 0.25);
    advance(state_, results_, seconds);
    background_.update(state_, results_);
    follow_story(state_, results_);
    follow_saved(state_, results_);
    thumbnails_.update(results_);
    pictures_.update(state_, results_);
    if (state_.space_shown) {
        space_.update(state_, results_);
        boxes_.update(state_, results_);
    }
    lay_out({state_, results_, pictures_, space_, boxes_, fonts_, palette_, thumbnails_, seconds});
    // Update again, so that what this frame's clicks request starts at once.
    background_.update(state_, results_);
    hand_over();
    const bool moving = state_.playing || state_.watching.running || !state_.notice.text.empty();
    return moving || results_.busy ? 1.0 / 30 : forever;
}

void Interface::hand_over() {
    if (state_.to_copy.empty()) return;
    ImGui::SetClipboardText(state_.to_copy.c_str());
    state_.to_copy.clear();
}

void Interface::watch_files() {
    const auto changed = [this](std::unique_ptr<FileWatch>& watch, const std::vector<std::filesystem::path>& files,
                                FileWatch::Gone gone) {
        if (!watch || watch->files() != files) watch = std::make_unique<FileWatch>(files, gone, wake_);
        return watch->has_changed();
    };
    if (changed(scene_watch_, {state_.file}, FileWatch::Gone::is_no_change)) reload(state_);
    if (!shows_mine(state_)) mine_watch_.reset();
    else if (changed(mine_watch_, files_of(state_.mine), FileWatch::Gone::is_a_change)) ++state_.mine.saved;
}

void Interface::lay_out(const Frame& frame) {
    const ImGuiViewport* viewport = ImGui::GetMainViewport();
    ImGui::SetNextWindowPos(viewport->WorkPos);
    ImGui::SetNextWindowSize(viewport->WorkSize);
    constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                       ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                                       ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoBackground;
    ImGui::Begin("Glassbox", nullptr, flags);
    if (!ImGui::IsAnyItemActive()) state_.setup.end_drag();
    draw_toolbar(frame);

    const ImGuiStyle& style = ImGui::GetStyle();
    const float bar = std::floor(ImGui::GetFontSize() * .4f);
    ImVec2 body = ImGui::GetContentRegionAvail();
    body.y -= ImGui::GetFrameHeight() + style.ItemSpacing.y;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));

    const float right = std::clamp(state_.side_width * body.x, std::min(280.f, body.x / 2), body.x * .75f);
    const float left = body.x - right - bar;
    const float space = state_.space_shown ? std::clamp(state_.space_height, .1f, .8f) * body.y : 0;
    ImGui::BeginGroup();
    ImGui::BeginChild("picture", {left, body.y - space - (state_.space_shown ? bar : 0)}, false,
                      ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    draw_picture(frame);
    ImGui::EndChild();
    if (state_.space_shown) {
        state_.space_height -= divider("##space", {left, bar}, false) / body.y;
        ImGui::BeginChild("space", {left, space}, false,
                          ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
        draw_space(frame);
        ImGui::EndChild();
    }
    ImGui::EndGroup();
    ImGui::SameLine();
    state_.side_width -= divider("##side", {bar, body.y}, true) / body.x;
    ImGui::SameLine();
    ImGui::PopStyleVar();
    ImGui::BeginChild("side", {right, body.y});
    draw_pages(frame);
    ImGui::EndChild();

    draw_status(frame);
    ImGui::End();
    draw_scene_menu(frame);
    draw_save_menu(frame);
    draw_copy_menu(frame);
    draw_keys(frame);
    draw_notice(frame);
}

}  // namespace glassbox
