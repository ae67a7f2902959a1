#include "output/sheet.hpp"

#include <algorithm>

namespace glassbox {

void paste(Image& onto, const Image& picture, int x, int y) {
    for (int row = 0; row < picture.height; ++row)
        std::copy_n(&picture.at(0, row), picture.width, &onto.at(x, y + row));
}

Image enlarged(const Image& image, int factor) {
    Image large(image.width * factor, image.height * factor);
    for (int y = 0; y < large.height; ++y)
        for (int x = 0; x < large.width; ++x) large.at(x, y) = image.at(x / factor, y / factor);
    return large;
}

int enlargement(int width, int height) {
    const int longer = std::max({width, height, 1});
    return longer < 200 ? (200 + longer - 1) / longer : 1;
}

}  // namespace glassbox
