#include "viewer/model/files/thumbnail.hpp"

#include <algorithm>
#include <utility>

#include "render/job.hpp"
#include "render/render.hpp"
#include "render/setup.hpp"
#include "render/view.hpp"
#include "scene/error.hpp"
#include "scene/scene_file.hpp"

namespace glassbox {

Thumbnail thumbnail(const std::filesystem::path& file, const FileVersion& version, const Job& job) {
    Thumbnail made{version, nullptr, "", ""};
    try {
        Scene scene = read_scene(file);
        made.title = scene.title;
        const double shrunk =
            std::min({1.0, 1.0 * thumbnail_width / scene.width, 1.0 * thumbnail_height / scene.height});
        const auto side = [&](int whole) { return std::max(1, static_cast<int>(shrunk * whole)); };
        const int width = side(scene.width), height = side(scene.height);
        made.image = std::make_shared<const Image>(render(resized(std::move(scene), width, height), Options{}, job));
    } catch (const Error& error) {
        made.error = error.what();
    }
    return made;
}

}  // namespace glassbox
