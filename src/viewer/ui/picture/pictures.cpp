#include "viewer/ui/picture/pictures.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "output/coloring.hpp"
#include "viewer/model/overlay/enlarged.hpp"
#include "viewer/model/overlay/laid_over.hpp"
#include "viewer/model/story/cursor.hpp"
#include "viewer/model/work/watching.hpp"

namespace glassbox {

std::vector<Rgba> opaque(const Image& image) {
    std::vector<Rgba> pixels;
    pixels.reserve(image.pixels.size());
    for (const Rgb& c : image.pixels) pixels.push_back({c.red, c.green, c.blue, 255});
    return pixels;
}

namespace {

void fill(Texture& texture, const Image& image) { texture.fill(image.width, image.height, opaque(image)); }

/// Fills a texture with a learner's picture, with colours of their own for what is not a number or not decided, and
/// nothing where nothing is drawn.
void fill(Texture& texture, const learn::mine::Drawing& drawing) {
    std::vector<Rgba> pixels = opaque(drawing.image);
    if (drawing.drawn == 0) std::fill(pixels.begin(), pixels.end(), Rgba{0, 0, 0, 0});
    for (std::size_t i = 0; i < pixels.size(); ++i)
        if (drawing.states[i] == learn::mine::SheetPixel::not_a_number) pixels[i] = {255, 0, 255, 255};
        else if (drawing.states[i] == learn::mine::SheetPixel::undecided) pixels[i] = {255, 160, 0, 255};
    texture.fill(drawing.image.width, drawing.image.height, pixels);
}

/// What the paper's loops have reached after so many pixels: columns from the left, in each the rows from the bottom.
/// The rest is blank.
std::vector<Rgba> watched(const Image& image, std::size_t shown) {
    std::vector<Rgba> pixels(image.pixels.size(), Rgba{0, 0, 0, 0});
    for (std::size_t k = 0; k < std::min(shown, pixels.size()); ++k) {
        const auto [column, row] = loop_place(k, image.height);
        const std::size_t pixel = index_of({column, image.height - 1 - row}, image.width);
        const Rgb c = image.pixels[pixel];
        pixels[pixel] = {c.red, c.green, c.blue, 255};
    }
    return pixels;
}

/// Converts a number of the scene's pixels to pixels of an image of it that may be coarser.
std::size_t on_image(std::size_t shown, const Image& image, const ViewerState& state) {
    return static_cast<std::size_t>(static_cast<double>(shown) * static_cast<double>(image.pixels.size()) /
                                    pixels(state));
}

/// Whether there is a newer version than the one that was had.
bool renewed(std::uint64_t& have, std::uint64_t now) { return std::exchange(have, now) != now; }

/// An overlay's colours as they are drawn: what is brushed stands out, and what must be seen is large enough.
std::vector<Rgba> marked(const Image& colors, const MeasuredChannels& overlay, const Overlay& chosen, int side) {
    constexpr int dimmed = 4;  // as bright as 1/4
    const Channel& channel = overlay.channels.front();
    std::vector<Rgba> pixels = opaque(colors);
    if (overlay.channels.size() > 1) return pixels;
    const Brush* const brush = brush_of(chosen);
    if (brush)
        for (std::size_t i = 0; i < pixels.size(); ++i)
            if (!is_brushed(*brush, channel.values[i])) {
                Rgba& c = pixels[i];
                c = {static_cast<std::uint8_t>(c.red / dimmed), static_cast<std::uint8_t>(c.green / dimmed),
                     static_cast<std::uint8_t>(c.blue / dimmed), 255};
            }
    const std::vector<std::uint8_t> ranks = ranks_of(*overlay.what, channel, chosen);
    if (side <= 1 || std::ranges::all_of(ranks, [](std::uint8_t rank) { return rank == 0; })) return pixels;
    const std::vector<std::uint32_t> drawn = enlarged(ranks, static_cast<std::size_t>(channel.width), side);
    std::vector<Rgba> result;
    result.reserve(pixels.size());
    for (const std::uint32_t pixel : drawn) result.push_back(pixels[pixel]);
    return result;
}

}  // namespace

void Pictures::update_overlay(const ViewerState& state, const Results& results) {
    if (!results.overlay) return distributions_.clear();
    const MeasuredChannels& overlay = *results.overlay;
    const Look look{state.overlay.range, state.overlay.spacing};
    const int side = (side_to_be_seen(state.view.zoom) + overlay.factor - 1) / overlay.factor;
    const Marks marks{state.overlay.brush, side};
    const bool is_new = renewed(overlay_serial_, results.overlay_serial);
    const bool other_look = std::exchange(look_, look) != look;
    const bool other_marks = std::exchange(marks_, marks) != marks;
    const bool recolor = is_new || other_look || distributions_.empty();
    if (recolor) {
        overlay_colors_ = colored({overlay.what, overlay.channels, look.spacing}, look.range);
        distributions_.clear();
        for (const Channel& channel : overlay.channels)
            distributions_.push_back(distribution(*overlay.what, channel, look.range, look.spacing));
    }
    if (!recolor && !other_marks) return;
    overlay_.fill(overlay_colors_.width, overlay_colors_.height, marked(overlay_colors_, overlay, state.overlay, side));
    const Brush* const brush = brush_of(state.overlay);
    brushed_ = !brush ? 0 : std::ranges::count_if(overlay.channels.front().values, [&](double value) {
        return is_brushed(*brush, value);
    });
}

void Pictures::update_outline(const ViewerState& state, const Results& results) {
    const SurfacesInPicture* const seen = surfaces_in_picture(state, results);
    const Outlined now{seen ? lit_surface(state, results) : std::nullopt, results.surfaces_serial};
    if (std::exchange(outlined_, now) == now) return;
    lit_outline_ = now.surface ? outline(seen->numbers, *now.surface) : std::vector<PixelBorder>();
}

void Pictures::update(const ViewerState& state, const Results& results) {
    const auto shown = state.watching.on ? std::optional(static_cast<std::size_t>(state.watching.shown)) : std::nullopt;
    const bool other_watched = std::exchange(watched_, shown) != shown;
    if ((renewed(picture_serial_, results.picture_serial) || other_watched) && results.picture.image) {
        const Image& image = *results.picture.image;
        if (shown) picture_.fill(image.width, image.height, watched(image, on_image(*shown, image, state)));
        else fill(picture_, image);
    }

    update_overlay(state, results);
    update_outline(state, results);

    const Picture &one = results.picture, &other = results.other;
    if (renewed(other_serial_, results.other_serial) && other.image) {
        const bool mine = results.mine && results.mine->drawing && &results.mine->drawing->image == other.image.get();
        if (mine) fill(other_, *results.mine->drawing);
        else fill(other_, *other.image);
    }
    if (!other.image) differing_.reset();
    if (!renewed(difference_serial_, results.picture_serial + results.other_serial)) return;
    differing_.reset();
    if (!one.image || !other.image || one.image->width != other.image->width ||
        one.image->height != other.image->height)
        return;
    const Difference found = picture_difference(*one.image, *other.image);
    fill(difference_, found.magnified);
    if (one.factor == 1 && other.factor == 1) differing_ = {found.pixels, found.greatest, found.where};
}

}  // namespace glassbox
