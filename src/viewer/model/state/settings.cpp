#include "viewer/model/state/settings.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "output/whole_file.hpp"

namespace glassbox {

namespace {

using Json = nlohmann::ordered_json;

/// Returns a number of that name if it is within its range, else the default.
template <class Number>
Number number(const Json& json, const char* name, Number usual, Number least, Number most) {
    const auto found = json.find(name);
    return found != json.end() && found->is_number() ? std::clamp(found->get<Number>(), least, most) : usual;
}

bool flag(const Json& json, const char* name, bool usual) {
    const auto found = json.find(name);
    return found != json.end() && found->is_boolean() ? found->get<bool>() : usual;
}

/// The absolute paths of that name; others are left out.
std::vector<std::filesystem::path> paths(const Json& json, const char* name) {
    std::vector<std::filesystem::path> all;
    const auto found = json.find(name);
    if (found == json.end() || !found->is_array()) return all;
    for (const Json& path : *found)
        if (path.is_string() && all.size() < most_recent &&
            std::filesystem::path(path.get<std::string>()).is_absolute())
            all.emplace_back(path.get<std::string>());
    return all;
}

}  // namespace

std::filesystem::path settings_file() {
    if (const char* config = std::getenv("XDG_CONFIG_HOME"); config && *config)
        return std::filesystem::path(config) / "glassbox" / "viewer.json";
    if (const char* home = std::getenv("HOME"); home && *home)
        return std::filesystem::path(home) / ".config" / "glassbox" / "viewer.json";
    return {};
}

Settings read_settings(const std::filesystem::path& file) {
    std::ifstream in(file);
    const Json json = in ? Json::parse(in, nullptr, false) : Json::object();
    if (!json.is_object()) return {};
    const Settings usual;
    Settings read;
    read.appearance.dark = flag(json, "dark", usual.appearance.dark);
    read.appearance.text_size =
        number(json, "text_size", usual.appearance.text_size, least_text_size, greatest_text_size);
    read.side_width = number(json, "side_width", usual.side_width, .1f, .8f);
    read.space_height = number(json, "space_height", usual.space_height, .1f, .8f);
    read.space_shown = flag(json, "space_shown", usual.space_shown);
    read.window_width = number(json, "window_width", usual.window_width, 320, 16384);
    read.window_height = number(json, "window_height", usual.window_height, 240, 16384);
    read.recent = paths(json, "recent");
    return read;
}

void write_settings(const std::filesystem::path& file, const Settings& settings) {
    std::vector<std::string> recent;
    for (const std::filesystem::path& path : settings.recent) recent.push_back(path.string());
    const Json json = {
        {"dark", settings.appearance.dark},        {"text_size", settings.appearance.text_size},
        {"side_width", settings.side_width},       {"space_height", settings.space_height},
        {"space_shown", settings.space_shown},     {"window_width", settings.window_width},
        {"window_height", settings.window_height}, {"recent", recent},
    };
    std::error_code failed;  // then writing fails too, and reports why
    std::filesystem::create_directories(file.parent_path(), failed);
    // A file's name may be no UTF-8: then it is not found again, and not listed.
    const std::string text = json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
    write_whole(file, std::as_bytes(std::span(text)));
}

Settings settings_of(const ViewerState& state, int window_width, int window_height) {
    return {state.appearance, state.side_width, state.space_height,     state.space_shown,
            window_width,     window_height,    state.scene_menu.recent};
}

void remember(ViewerState& state, const Settings& settings) {
    state.appearance = settings.appearance;
    state.side_width = settings.side_width;
    state.space_height = settings.space_height;
    state.space_shown = settings.space_shown;
    state.scene_menu.recent = settings.recent;
}

}  // namespace glassbox
