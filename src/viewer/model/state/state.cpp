#include "viewer/model/state/state.hpp"

#include <set>

#include "render/failing.hpp"
#include "scene/error.hpp"
#include "scene/scene_file.hpp"

namespace glassbox {

namespace {

std::optional<Pixel> if_on(const Scene& scene, const std::optional<Pixel>& pixel) {
    if (pixel && pixel->x < scene.width && pixel->y < scene.height) return pixel;
    return {};
}

/// Reads a scene, and checks what it says of a setup that fails.
std::shared_ptr<const Scene> scene_of(const std::filesystem::path& file) {
    auto scene = std::make_shared<const Scene>(read_scene(file));
    failing_setup(*scene, setup_of(*scene));
    return scene;
}

}  // namespace

ViewerState opened(const std::filesystem::path& file) {
    ViewerState state;
    state.file = file;
    state.scene = scene_of(file);
    state.setup = History(setup_of(*state.scene));
    state.other.scalar = Scalar::double_;
    return state;
}

void pin(ViewerState& state, const std::optional<Pixel>& pixel) {
    state.pinned = pixel;
    state.step = 0;
    state.playing = false;
}

std::vector<std::filesystem::path> mesh_files(const Scene& scene) {
    std::set<std::filesystem::path> files;
    for (const Shared<Mesh>& mesh : scene.meshes)
        if (!mesh->file.empty()) files.insert(mesh->file);
    return {files.begin(), files.end()};
}

bool can_show_failing(const ViewerState& state) {
    const std::optional<Setup> failing = failing_setup(*state.scene, state.setup.now());
    return failing && *failing != state.setup.now();
}

void show_failing(ViewerState& state) {
    if (!can_show_failing(state)) return;
    state.setup.change(*failing_setup(*state.scene, state.setup.now()));
    state.overlay.measurement = "verdict";
}

void reload(ViewerState& state) {
    try {
        std::shared_ptr<const Scene> scene = scene_of(state.file);
        state.setup.replace_all([&](const Setup& setup) { return followed(setup, *state.scene, *scene); });
        if (scene->width != state.scene->width || scene->height != state.scene->height) state.fit = Fit::whole_multiple;
        state.scene = std::move(scene);
        state.pinned = if_on(*state.scene, state.pinned);
        state.compared = if_on(*state.scene, state.compared);
        state.file_error.clear();
    } catch (const Error& error) {
        state.file_error = error.what();
    }
}

void open(ViewerState& state, const std::filesystem::path& file) {
    try {
        ViewerState fresh = opened(file);
        fresh.scene_menu = state.scene_menu;
        fresh.saving = state.saving;
        fresh.notice = state.notice;
        fresh.to_copy = state.to_copy;
        fresh.appearance = state.appearance;
        fresh.page = state.page;
        fresh.side_width = state.side_width;
        fresh.space_height = state.space_height;
        fresh.number_form = state.number_form;
        fresh.space_shown = state.space_shown;
        fresh.box_level = state.box_level;
        fresh.overlay.measurement = state.overlay.measurement;
        fresh.overlay.minus = state.overlay.minus;
        fresh.overlay.opacity = state.overlay.opacity;
        fresh.overlay.legend_shown = state.overlay.legend_shown;
        fresh.beside = state.beside;
        fresh.split = state.split;
        fresh.other = state.other;
        fresh.predicting = state.predicting;
        fresh.stepping.pane = state.stepping.pane;
        fresh.mine = state.mine;
        if (fresh.mine.chosen && shows_mine(fresh)) {
            fresh.mine.before = fresh.setup.now().options;
            fresh.setup = History(for_mine(fresh.setup.now(), fresh.mine));
        }
        state = std::move(fresh);
    } catch (const Error& error) {
        state.file_error = error.what();
    }
}

}  // namespace glassbox
