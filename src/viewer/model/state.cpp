#include "viewer/model/state.hpp"

#include "scene/error.hpp"
#include "scene/scene_file.hpp"

namespace glassbox {

namespace {

std::optional<Pixel> if_on(const Scene& scene, const std::optional<Pixel>& pixel) {
    if (pixel && pixel->x < scene.width && pixel->y < scene.height) return pixel;
    return {};
}

}  // namespace

ViewerState opened(const std::filesystem::path& file) {
    ViewerState state;
    state.file = file;
    state.scene = std::make_shared<const Scene>(read_scene(file));
    state.setup = History(setup_of(*state.scene));
    state.other.scalar = Scalar::double_;
    return state;
}

Scene present_scene(const ViewerState& state) { return applied(*state.scene, state.setup.now()); }

void reload(ViewerState& state) {
    try {
        auto scene = std::make_shared<const Scene>(read_scene(state.file));
        // What the user has not touched follows the file.
        Setup setup = state.setup.now();
        const Setup before = setup_of(*state.scene), after = setup_of(*scene);
        if (setup.shading == before.shading) setup.shading = after.shading;
        if (setup.light_position == before.light_position) setup.light_position = after.light_position;
        if (setup.light_intensity == before.light_intensity) setup.light_intensity = after.light_intensity;
        state.setup.amend(setup);
        if (scene->width != state.scene->width || scene->height != state.scene->height) state.fit = true;
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
        fresh.appearance = state.appearance;
        fresh.page = state.page;
        fresh.space_shown = state.space_shown;
        fresh.overlay.measurement = state.overlay.measurement;
        fresh.overlay.opacity = state.overlay.opacity;
        fresh.beside = state.beside;
        fresh.split = state.split;
        fresh.other = state.other;
        state = std::move(fresh);
    } catch (const Error& error) {
        state.file_error = error.what();
    }
}

}  // namespace glassbox
