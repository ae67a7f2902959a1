#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "learn/build/first_error.hpp"
#include "learn/picture/sheet.hpp"
#include "render/image.hpp"
#include "render/pixel.hpp"

namespace glassbox::learn::mine {

/// What a learner's renderer has drawn, perhaps not all of the picture. A pixel that it did not get to has the colour
/// of the one of a coarser picture that it belongs to, if that is there, or else is black.
struct Drawing {
    Image image;
    std::vector<SheetPixel::State> states;  ///< what became of each pixel, as `image` has them
    std::int64_t drawn = 0;
    std::int64_t not_numbers = 0;             ///< of those drawn: made of something that is not a number
    std::optional<Pixel> first_not_a_number;  ///< from the top left
    std::int64_t undecided = 0;               ///< of those drawn: bounds left open what is seen there
    std::optional<Pixel> first_undecided;     ///< from the top left
};

/// How a learner's picture stands.
enum class Stand {
    not_there,  ///< a header is not there: the lesson is not begun, or a file was deleted
    compiling,
    does_not_compile,  ///< `error` says where, if the compiler does
    drawing,           ///< what is drawn already is in `drawing`
    drawn,
    not_written,  ///< a function was called that is not written yet
    failed,       ///< it crashed, or did not end
};

/// A learner's picture, and what there is to say of it: values alone, nothing of the programs that made it.
struct PictureUpdate {
    Stand stand = Stand::compiling;
    std::string words;                       ///< one or two sentences; no full stop
    std::string by_whom;                     ///< which lessons draw, and which do not yet; "" if one was asked for
    std::optional<CompileError> error;       ///< with does_not_compile
    std::optional<Pixel> spot;               ///< the pixel that the words are about
    std::shared_ptr<const Drawing> drawing;  ///< as far as it is drawn; null: not begun
    std::string said;                        ///< what the code printed, from the beginning
    double compile_seconds = 0;              ///< 0 where nothing needed compiling
    double draw_seconds = 0;
};

}  // namespace glassbox::learn::mine
