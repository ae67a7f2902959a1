#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace glassbox::learn::mine {

/// The memory that Glassbox and a learner's renderer share: what is to be drawn, and what has been. Plain numbers only,
/// no type of the core's: the learner's own may be laid out differently. Behind the Sheet lie its lists, one after the
/// other: turns, spheres, triangles, and the pixels, row by row from the top left.
struct SheetTurn {
    std::int32_t axis;  ///< 0 x, 1 y, 2 z
    double degrees;
};
struct SheetSphere {
    double center[3], radius;
    std::uint8_t color[3];
};
struct SheetTriangle {
    double vertices[3][3];
    std::uint8_t color[3];
};
struct SheetPixel {
    std::uint8_t red, green, blue;
    /// What became of it.
    enum State : std::uint8_t {
        not_drawn,  ///< the renderer did not get there
        drawn,
        not_a_number,  ///< drawn, but one of the numbers that made it is none
        undecided,     ///< drawn, but bounds left open what is seen there
    } state;
};

/// Where the renderer is.
enum class Stage : std::int32_t { starting, view, light, pixels, done };

inline constexpr int most_coefficients = 16;

struct Sheet {
    std::int32_t width, height;
    std::int32_t stage;
    double tolerance;  ///< of the triangle rule, if it has one
    std::int32_t accumulated;

    std::int32_t pinhole;  ///< whether `view` is eye, look_at, up; else it is corner, right, up, direction
    double view[4][3];
    double field_of_view;
    double pivot[3];

    double light[3], intensity;
    std::int32_t shading_model;
    double coefficients[most_coefficients];  ///< of the shading, in the order of their table
    double colors[most_coefficients][3];     ///< of their terms
    std::uint8_t background[3];

    std::int64_t turns, spheres, triangles;  ///< how many

    // What the renderer writes.
    std::atomic<Stage> at;
    std::atomic<std::int32_t> x, y;  ///< the pixel that is being drawn
    std::atomic<std::int64_t> pixels_done;
    std::int32_t not_written;  ///< whether it ended by NotWritten; the last words say of what
};
static_assert(std::atomic<Stage>::is_always_lock_free && std::atomic<std::int64_t>::is_always_lock_free);

/// Where the lists of a sheet lie, and how many bytes there are in all.
struct SheetLists {
    SheetTurn* turns;
    SheetSphere* spheres;
    SheetTriangle* triangles;
    SheetPixel* pixels;
};
constexpr std::size_t aligned(std::size_t bytes) { return (bytes + 15) / 16 * 16; }

constexpr std::size_t sheet_bytes(std::size_t turns, std::size_t spheres, std::size_t triangles, std::size_t pixels) {
    return aligned(sizeof(Sheet)) + aligned(turns * sizeof(SheetTurn)) + aligned(spheres * sizeof(SheetSphere)) +
           aligned(triangles * sizeof(SheetTriangle)) + pixels * sizeof(SheetPixel);
}

inline SheetLists lists_of(Sheet& sheet) {
    auto* at = reinterpret_cast<std::byte*>(&sheet) + aligned(sizeof(Sheet));
    SheetLists lists;
    lists.turns = reinterpret_cast<SheetTurn*>(at);
    at += aligned(static_cast<std::size_t>(sheet.turns) * sizeof(SheetTurn));
    lists.spheres = reinterpret_cast<SheetSphere*>(at);
    at += aligned(static_cast<std::size_t>(sheet.spheres) * sizeof(SheetSphere));
    lists.triangles = reinterpret_cast<SheetTriangle*>(at);
    at += aligned(static_cast<std::size_t>(sheet.triangles) * sizeof(SheetTriangle));
    lists.pixels = reinterpret_cast<SheetPixel*>(at);
    return lists;
}

/// The pixels that are drawn first lie so far apart.
inline constexpr int coarsest = 16;

/// Calls `draw(x, y)` for each pixel, once: first a few all over the picture, then those between them, and those
/// between these. So there is soon something to see, and what a crash leaves is a whole picture, if a coarse one.
template <class Draw>
void coarse_first(int width, int height, const Draw& draw) {
    for (int apart = coarsest; apart > 0; apart /= 2)
        for (int y = 0; y < height; y += apart)
            for (int x = 0; x < width; x += apart) {
                const bool drawn_before = apart < coarsest && x % (2 * apart) == 0 && y % (2 * apart) == 0;
                if (!drawn_before) draw(x, y);
            }
}

}  // namespace glassbox::learn::mine
