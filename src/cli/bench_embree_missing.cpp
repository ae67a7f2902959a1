#include "cli/bench_embree.hpp"
#include "scene/error.hpp"

namespace glassbox {

bool bench_against_embree(int, std::optional<int>, const std::stop_token&) {
    throw Error(
        "this program was built without Embree, version 3, to compare with. Install it (on Debian: sudo apt-get "
        "install "
        "libembree-dev) and build again");
}

}  // namespace glassbox
