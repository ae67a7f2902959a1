#include "bench/cliffs/cliff.hpp"
#include "render/view.hpp"
#include "scene/scene_file.hpp"
#include "scene/scene_path.hpp"

namespace glassbox {

namespace {

Scene room(int side) { return resized(read_scene(scene_path("room")), side, side); }

Cliff measuring(const char* what) {
    return {std::string("measure room --what ") + what, 10, "its picture",
            [what](int side) {
                return Traced{room(side), {}, what};
            },
            [](int side) { return Traced{room(side)}; }};
}

}  // namespace

std::vector<Cliff> cliffs_of_measurements() { return {measuring("margin"), measuring("tests"), measuring("side")}; }

std::vector<Cliff> all_cliffs() {
    std::vector<Cliff> all;
    for (const auto& some :
         {cliffs_of_ties(), cliffs_of_scale(), cliffs_of_shapes(), cliffs_of_rays(), cliffs_of_measurements()})
        all.insert(all.end(), some.begin(), some.end());
    return all;
}

}  // namespace glassbox
