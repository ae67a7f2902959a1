#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <ray.hpp>

#include "scene/scene.hpp"

namespace glassbox {

// A cliff: something harmless about a scene, or about rays, that makes an answer cost many times what it should. Each
// is timed beside an ordinary scene with as many surfaces and as many rays.

/// What is traced: rays of one's own, as `shoot` does; or a picture, as `render` does; or what `measure` measures.
struct Traced {
    Scene scene;
    std::vector<Ray<double>> rays = {};  ///< none: the picture's
    std::string_view measured = {};      ///< a measurement's name; empty: the picture
};

struct Cliff {
    std::string name;
    double goal;           ///< it should cost no more than so many times the ordinary
    std::string ordinary;  ///< what it is compared with
    /// Both make side × side rays.
    std::function<Traced(int side)> make, make_ordinary;
};

// By what is hard about them.
std::vector<Cliff> cliffs_of_ties();    ///< surfaces or edges met at the same t, or exactly at their border
std::vector<Cliff> cliffs_of_scale();   ///< very large, very small, very far
std::vector<Cliff> cliffs_of_shapes();  ///< surfaces whose boxes tell little
std::vector<Cliff> cliffs_of_rays();    ///< rays of one's own
std::vector<Cliff> cliffs_of_measurements();

/// All of them, in this order.
std::vector<Cliff> all_cliffs();

}  // namespace glassbox
