#include "output/table.hpp"

#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace glassbox {
namespace {

template <class Number>
void append(std::string& text, Number number) {
    char digits[32];  // the longest double, -2.2250738585072014e-308, has 24 characters
    const auto end = std::to_chars(digits, digits + sizeof digits, number).ptr;
    text.append(digits, end);
}

}  // namespace

void table(std::span<const Measured> measured, const Sink& sink) {
    const std::vector<const Channel*> channels = all_channels(measured);
    const int width = channels.empty() ? 0 : channels.front()->width;
    const int height = channels.empty() ? 0 : channels.front()->height;
    std::string text = "x,y";
    for (const Channel* channel : channels) {
        if (channel->width != width || channel->height != height)
            throw std::invalid_argument("channels of different sizes do not fit in one table");
        text += ',' + channel->name;
    }
    text += '\n';

    std::size_t pixel = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x, ++pixel) {
            append(text, x);
            text += ',';
            append(text, y);
            for (const Channel* channel : channels) {
                text += ',';
                if (!std::isnan(channel->values[pixel])) append(text, channel->values[pixel]);
            }
            text += '\n';
        }
        sink(std::as_bytes(std::span(text)));
        text.clear();
    }
    if (!text.empty()) sink(std::as_bytes(std::span(text)));
}

}  // namespace glassbox
