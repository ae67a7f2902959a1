#include "learn/picture/drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <new>

#include "learn/picture/to_sheet.hpp"
#include "learn/subprocess/shared_memory.hpp"
#include "render/render.hpp"
#include "scene/printable.hpp"

namespace glassbox::learn::mine {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto longest_pixel = 3s;       // no pixel takes that long, nor what comes before the first
constexpr auto between_pictures = 60ms;  // while it draws

/// What is there now. The renderer may be writing meanwhile: then some pixels are one picture later than others. It may
/// write anything at all, so nothing but the pixels is read, at places that we know ourselves.
Drawing read(const SheetPixel* pixels, const Scene& scene) {
    Drawing drawing{Image(scene.width, scene.height), {}, 0, 0, {}, 0, {}};
    const auto all = drawing.image.pixels.size();
    drawing.states.resize(all, SheetPixel::not_drawn);
    for (std::size_t i = 0; i < all; ++i) {
        const SheetPixel pixel = pixels[i];
        const auto width = static_cast<std::size_t>(scene.width);
        const Pixel spot{static_cast<int>(i % width), static_cast<int>(i / width)};
        switch (pixel.state) {
            case SheetPixel::drawn:
                break;
            case SheetPixel::not_a_number:
                if (drawing.not_numbers++ == 0) drawing.first_not_a_number = spot;
                break;
            case SheetPixel::undecided:
                if (drawing.undecided++ == 0) drawing.first_undecided = spot;
                break;
            default:
                continue;
        }
        drawing.image.pixels[i] = {pixel.red, pixel.green, pixel.blue};
        drawing.states[i] = pixel.state;
        ++drawing.drawn;
    }
    if (drawing.drawn == 0) return drawing;
    if (static_cast<std::size_t>(drawing.drawn) < all)
        for (int y = 0; y < scene.height; ++y)
            for (int x = 0; x < scene.width; ++x) {
                const auto state = [&](int at_x, int at_y) {
                    return drawing.states[index_of({at_x, at_y}, scene.width)];
                };
                for (int apart = 1; apart <= coarsest; apart *= 2) {
                    const int of_x = x - x % apart, of_y = y - y % apart;
                    if (state(of_x, of_y) == SheetPixel::not_drawn) continue;
                    drawing.image.at(x, y) = drawing.image.at(of_x, of_y);
                    break;
                }
            }
    if (scene.border) paint_border(drawing.image, *scene.border);
    return drawing;
}

std::string where(const Drawn& drawn) {
    switch (drawn.at) {
        case Stage::view:
            return "while it made the view, ";
        case Stage::light:
            return "while it made the light, ";
        case Stage::pixels:
            return drawn.spot ? fmt::format("at pixel ({}, {}) ", drawn.spot->x, drawn.spot->y) : "";
        case Stage::starting:
        case Stage::done:
            break;
    }
    return "";
}

}  // namespace

Drawn draw(const std::filesystem::path& renderer, const Scene& scene, const Options& options,
           const std::function<void(std::shared_ptr<const Drawing>)>& show, const std::stop_token& stop) {
    const std::size_t bytes = sheet_bytes(options.turns.size(), scene.spheres.size(), triangles_of(scene),
                                          pixel_count(scene.width, scene.height));
    const SharedMemory memory(bytes);
    auto& sheet = *new (memory.data()) Sheet{};
    write(scene, options, sheet);
    const SheetPixel* const pixels = lists_of(sheet).pixels;

    Command command{renderer, {std::to_string(bytes)}};
    command.shared = &memory;
    command.limits.time = longest_pixel;
    command.limits.memory = (std::uint64_t{1} << 30) + 2 * bytes;
    command.limits.output = 4096;
    command.limits.endless = std::size_t{128} << 20;  // a line for each pixel is much, and not endless
    std::int64_t before = -1;
    auto shown = Clock::now();
    command.has_got_on = [&] {
        const std::int64_t now = sheet.pixels_done.load(std::memory_order_acquire);
        if (now > 0 && now != before && Clock::now() - shown > between_pictures) {
            show(std::make_shared<const Drawing>(read(pixels, scene)));
            shown = Clock::now();
        }
        return std::exchange(before, now) != now;
    };
    Drawn drawn;
    drawn.outcome = run(command, stop);
    drawn.drawing = std::make_shared<const Drawing>(read(pixels, scene));
    drawn.at = sheet.at;
    drawn.not_written = sheet.not_written != 0;
    if (drawn.at == Stage::pixels)
        drawn.spot =
            Pixel{std::clamp(sheet.x.load(), 0, scene.width - 1), std::clamp(sheet.y.load(), 0, scene.height - 1)};
    return drawn;
}

std::string what_became_of(const Drawn& drawn) {
    const Outcome& outcome = drawn.outcome;
    if (drawn.not_written) return printable(outcome.last_words.text);
    if (outcome.well() && drawn.at == Stage::done) return "";
    const std::string what = how_it_ended(outcome);
    if (what.empty()) return where(drawn) + "it ended before the picture was done";
    return where(drawn) + what;
}

}  // namespace glassbox::learn::mine
