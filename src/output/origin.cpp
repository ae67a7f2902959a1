#include "output/origin.hpp"

namespace glassbox {

std::vector<std::pair<std::string, std::string>> notes_of(const Origin& origin) {
    if (origin.command.empty()) return {};
    return {{"Software", "Glassbox " GLASSBOX_VERSION}, {"Command", origin.command}};
}

}  // namespace glassbox
