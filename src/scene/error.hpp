#pragma once
#include <stdexcept>
#include <string>

namespace glassbox {

/// An error that stops the work. Its message says in one line where, what is wrong, and what would be right.
/// "scenes/room.toml:12:9: error: radius is -3; it must be greater than 0"
struct Error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A place in a text file. Line and column count from 1; 0 stands for the whole file.
struct Place {
    std::string file;
    std::size_t line = 0;
    std::size_t column = 0;
};

/// "file:line:column: error: message", without the parts that are not known.
inline Error error_at(const Place& place, const std::string& message) {
    std::string where = place.file;
    if (place.line != 0) where.append(":").append(std::to_string(place.line));
    if (place.line != 0) where.append(":").append(std::to_string(place.column));
    return Error(where.append(": error: ").append(message));
}

}  // namespace glassbox
