#pragma once
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "learn/subprocess/isolation.hpp"
#include "learn/subprocess/last_words.hpp"
#include "learn/subprocess/shared_memory.hpp"

namespace glassbox::learn {

/// Limits on what a program may use.
struct Limits {
    std::chrono::milliseconds time{10'000};         ///< until it is ended, with all processes that it started
    std::uint64_t memory = std::uint64_t{2} << 30;  ///< bytes of address space; 0: no limit (sanitizers need terabytes)
    std::size_t output = std::size_t{64} << 10;     ///< bytes kept of each of its two outputs
    std::size_t endless = std::size_t{16} << 20;    ///< bytes of output after which it is ended
    std::uint64_t file = std::uint64_t{256} << 20;  ///< bytes of a file that it writes
};

/// A program to be run.
struct Command {
    std::filesystem::path program;                                      ///< looked up in PATH if it has no /
    std::vector<std::string> arguments;                                 ///< without the program's name
    std::vector<std::pair<std::string, std::string>> environment = {};  ///< added to ours, or replacing it
    std::filesystem::path folder = {};                                  ///< where it runs; empty: where we do
    Limits limits = {};
    /// Called about every 50 ms while it runs. Whenever it returns that the program has made progress, Limits::time
    /// starts again.
    std::function<bool()> has_got_on = {};
    std::optional<Isolation> isolation = {};  ///< runs isolated, with access to no more than this
    const SharedMemory* shared = nullptr;     ///< handed down as shared_memory_variable; must live until run() returns
};

/// What ended a program.
enum class End {
    exited,       ///< it ended by itself: Outcome::status is its exit status
    signal,       ///< it crashed: Outcome::status is the signal's number
    deadline,     ///< Limits::time ran out
    output,       ///< it wrote more than Limits::endless
    memory,       ///< it probably needed more than Limits::memory: std::bad_alloc, or the system ended it
    stopped,      ///< we were asked to stop
    not_started,  ///< there is no such program: Outcome::errors says why
};

/// How a program ended, and what it printed.
struct Outcome {
    End end = End::not_started;
    int status = 0;
    LastWords last_words = {};  ///< of programs that listen_for_the_end()
    std::string output;         ///< its standard output, from the beginning, as far as kept
    std::string errors;         ///< its standard error, in the same way
    std::chrono::duration<double> took{};
    Limits limits = {};

    /// It ended by itself with exit status 0, and not by an exit() before its work was done.
    bool well() const { return end == End::exited && status == 0 && last_words.kind != LastWords::left; }
};

/// Runs a program in a process and a session of its own, with an empty input, and waits for its end. When it ends, in
/// whatever way, all processes that it started and that have not left its session are ended, too. Never throws for what
/// the program does; throws Error if the system has no process, pipe or memory to give. May be called by several
/// threads at once.
Outcome run(const Command& command, const std::stop_token& stop = {});

/// Describes an abnormal end, in words for someone who learns to program, without a full stop: "it followed a null
/// pointer (address 0x8)", "it ran for 5 s without ending: an endless loop?". Empty if all was well.
std::string how_it_ended(const Outcome& outcome);

}  // namespace glassbox::learn
