#include "viewer/ui/interface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "viewer/model/space/flight.hpp"
#include "viewer/model/state/first_pin.hpp"
#include "viewer/model/state/keys.hpp"
#include "viewer/model/state/playing.hpp"
#include "viewer/model/state/tour.hpp"
#include "viewer/model/story/cursor.hpp"
#include "viewer/model/story/predicting.hpp"
#include "viewer/model/story/stepping.hpp"
#include "viewer/model/work/watching.hpp"
#include "viewer/ui/frame/places.hpp"
#include "viewer/ui/widgets/buttons.hpp"
#include "viewer/ui/widgets/keyboard.hpp"

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

/// Whether another page is shown than in the last frame, or steps in text of another size.
bool must_come_in_sight(Page page) {
    ImGuiStorage* const storage = ImGui::GetStateStorage();
    // A reference holds until the next one is asked for.
    float* const size = storage->GetFloatRef(ImGui::GetID("text size"), ImGui::GetFontSize());
    const bool other_size = std::exchange(*size, ImGui::GetFontSize()) != ImGui::GetFontSize();
    int* const shown = storage->GetIntRef(ImGui::GetID("page"), static_cast<int>(page));
    const bool other_page = std::exchange(*shown, static_cast<int>(page)) != static_cast<int>(page);
    return other_page || (other_size && page == Page::steps);
}

void draw_pages(const Frame& frame) {
    static_assert(std::size(pages) == 5);
    const float top = ImGui::GetCursorScreenPos().y;
    // Dear ImGui's own tab bar cuts titles that do not fit into one line.
    for (const PageTab& tab : pages) {
        if (&tab != pages) flow(tab.title, ImGui::GetStyle().ItemInnerSpacing.x);
        if (toggle(tab.title, frame.state.page == tab.page)) frame.state.page = tab.page;
    }
    ImGui::Separator();
    for (const PageTab& tab : pages) {
        if (frame.state.page != tab.page) continue;
        // Where the text is large and the window small, all that is on the right scrolls: then the page is as high as
        // what is left when the line and the tiles are scrolled away, and if that is little, when the tabs are, too.
        constexpr float least_lines = 12;
        const float room = ImGui::GetContentRegionAvail().y, line = ImGui::GetFontSize();
        const float all = ImGui::GetWindowHeight(), below_tabs = all - (ImGui::GetCursorScreenPos().y - top);
        const bool scrolls = room < least_lines * line;
        begin_part(tab.title, {0, scrolls ? std::max(below_tabs, std::min(all, least_lines * line)) : room});
        if (frame.state.keys_work_buttons) take_keyboard();
        tab.draw(frame);
        ImGui::EndChild();
        if (must_come_in_sight(tab.page) && scrolls) ImGui::SetScrollHereY(1);
    }
}

}  // namespace

Interface::Interface(ViewerState state, float scale, const std::function<void()>& wake)
    : state_(std::move(state)), scale_(scale), wake_(wake), background_(wake) {}

void Interface::prepare() {
    let_keyboard_work(state_.keys_work_buttons);
    const float text_size = state_.appearance.text_size * scale_;
    if (text_size == loaded_text_size_ && state_.appearance.dark == loaded_dark_) return;
    if (text_size != loaded_text_size_) fonts_ = load_fonts(text_size);
    palette_ = apply_theme(state_.appearance, text_size);
    loaded_text_size_ = text_size;
    loaded_dark_ = state_.appearance.dark;
}

double Interface::draw(const Input& input) {
    for (const KeyPress& press : input.keys)
        if (!ImGui::GetIO().WantTextInput || is_obeyed_while_typing(press) ||
            (takes_keyboard(state_) && !press.control))
            obey(press, state_, results_);
    open_dropped(state_, input.dropped);
    watch_files();
    const double seconds = std::clamp(input.time - std::exchange(last_time_, input.time), 0.0, 0.25);
    advance(state_, results_, seconds);
    begin_pointing(state_);
    background_.update(state_, results_);
    pin_at_first(state_, results_);
    follow_story(state_, results_);
    follow_steps(state_, results_);
    follow_saved(state_, results_);
    thumbnails_.update(results_);
    pictures_.update(state_, results_);
    if (state_.space_shown) {
        space_.update(state_, results_);
        boxes_.update(state_, results_);
    }
    fly_on(state_, space_.drawing().near, seconds);
    lay_out({state_, results_, pictures_, space_, boxes_, inspector_, fonts_, palette_, thumbnails_, seconds});
    // Update again, so that what this frame's clicks request starts at once.
    background_.update(state_, results_);
    hand_over();
    const bool moving = state_.playing || state_.watching.running || state_.flight || !state_.notice.text.empty();
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
    const bool scene_changed = changed(scene_watch_, {state_.file}, FileWatch::Gone::is_no_change);
    if (std::exchange(scene_of_meshes_, state_.scene) != state_.scene) mesh_files_ = mesh_files(*state_.scene);
    if (mesh_files_.empty()) mesh_watch_.reset();
    const bool mesh_changed = !mesh_files_.empty() && changed(mesh_watch_, mesh_files_, FileWatch::Gone::is_a_change);
    if (scene_changed || mesh_changed) reload(state_);
    if (!shows_mine(state_) && !state_.mine.is_stepped) mine_watch_.reset();
    else if (changed(mine_watch_, files_of(state_.mine), FileWatch::Gone::is_a_change)) ++state_.mine.saved;
}

void Interface::lay_out(const Frame& frame) {
    const ImGuiViewport* viewport = ImGui::GetMainViewport();
    ImGui::SetNextWindowPos(viewport->WorkPos);
    ImGui::SetNextWindowSize(viewport->WorkSize);
    constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                       ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                                       ImGuiWindowFlags_NoBackground;
    ImGui::Begin("Glassbox", nullptr, flags);
    if (!ImGui::IsAnyItemActive()) state_.setup.end_drag();
    Places places{};
    const auto from_here = [](ImVec2 size) {
        const ImVec2 from = ImGui::GetCursorScreenPos();
        return Area{from, {from.x + size.x, from.y + size.y}};
    };
    places.toolbar = from_here({ImGui::GetContentRegionAvail().x, 0});
    draw_toolbar(frame);
    places.toolbar.to.y = ImGui::GetItemRectMax().y;

    const ImGuiStyle& style = ImGui::GetStyle();
    const float bar = std::floor(ImGui::GetFontSize() * .4f);
    ImVec2 body = ImGui::GetContentRegionAvail();
    body.y -= ImGui::GetFrameHeight() + style.ItemSpacing.y;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));

    const float right = std::clamp(state_.side_width * body.x, std::min(280.f, body.x / 2), body.x * .75f);
    const float left = body.x - right - bar;
    const float space = state_.space_shown ? std::clamp(state_.space_height, .1f, .8f) * body.y : 0;
    ImGui::BeginGroup();
    constexpr ImGuiWindowFlags drawn =
        ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoNav;
    const ImVec2 picture{left, body.y - space - (state_.space_shown ? bar : 0)};
    places.picture = from_here(picture);
    ImGui::BeginChild("picture", picture, false, drawn);
    draw_picture(frame);
    ImGui::EndChild();
    if (state_.space_shown) {
        state_.space_height -= divider("##space", {left, bar}, false) / body.y;
        places.space = from_here({left, space});
        ImGui::BeginChild("space", {left, space}, false, drawn);
        draw_space(frame);
        ImGui::EndChild();
    }
    ImGui::EndGroup();
    ImGui::SameLine();
    state_.side_width -= divider("##side", {bar, body.y}, true) / body.x;
    ImGui::SameLine();
    ImGui::PopStyleVar();
    const Area side = from_here({right, body.y});
    begin_part("side", {right, body.y});
    if (state_.tour && tour()[*state_.tour].part == WindowPart::truth) ImGui::SetScrollY(0);
    draw_truth(frame);
    const float pages_top = ImGui::GetCursorScreenPos().y;
    places.truth = {side.from, {side.to.x, pages_top}};
    places.page = {{side.from.x, pages_top}, side.to};
    draw_pages(frame);
    ImGui::EndChild();

    draw_status(frame);
    ImGui::End();
    draw_scene_menu(frame);
    draw_save_menu(frame);
    draw_copy_menu(frame);
    draw_keys(frame);
    draw_tour(frame, places);
    draw_notice(frame);
}

}  // namespace glassbox
