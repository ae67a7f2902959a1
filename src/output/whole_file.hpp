#pragma once
#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <stop_token>

namespace glassbox {

/// Takes the next bytes of a file that is being written.
using Sink = std::function<void(std::span<const std::byte>)>;

/// Writes a file completely or not at all: into a temporary file beside it, which then takes its name. An existing file
/// keeps its content until then, and its permissions; a symbolic link stays one. Anything but a plain file
/// (/dev/stdout, a pipe) is written to directly. Throws Error, which says what would help; Cancelled when asked to
/// stop.
void write_whole(const std::filesystem::path& path, std::span<const std::byte> bytes, std::stop_token stop = {});

/// The same for a file made piece by piece: `produce` passes its pieces to the sink that it is given.
void write_whole(const std::filesystem::path& path, const std::function<void(const Sink&)>& produce,
                 std::stop_token stop = {});

/// Whether the path is a device or a pipe, or a name that refers to an open file, such as /dev/stdout.
bool is_device(const std::filesystem::path& path);

/// Throws the Error that writing would throw, as far as it is known without writing; call it before long work.
void check_writable(const std::filesystem::path& path);

}  // namespace glassbox
