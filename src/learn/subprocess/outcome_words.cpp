#include <fmt/core.h>
#include <signal.h>

#include <cstring>
#include <string_view>

#include "learn/subprocess/subprocess.hpp"
#include "scene/printable.hpp"

namespace glassbox::learn {
namespace {

constexpr std::uint64_t first_page = 65536;  // never mapped: such an address is an offset from null

std::string in_mebibytes(std::uint64_t bytes) {
    const std::uint64_t mebibytes = bytes >> 20;
    return mebibytes >= 1024 && mebibytes % 1024 == 0 ? fmt::format("{} GiB", mebibytes / 1024)
                                                      : fmt::format("{} MiB", mebibytes);
}

/// Returns the last line that is not blank, made printable.
std::string last_line(std::string_view text) {
    while (!text.empty() && std::strchr("\n\r ", text.back())) text.remove_suffix(1);
    const std::size_t start = text.rfind('\n');
    return printable(start == std::string_view::npos ? text : text.substr(start + 1));
}

std::string after_colon(const std::string& line) { return line.empty() ? "" : ": " + line; }

/// How a program gave up. Of g++'s standard library it tells what the checks mean that learners meet.
std::string abort_words(const std::string& line) {
    if (line.find("Assertion '__n < this->size()'") != std::string::npos)
        return "it reached beyond the end of a vector: is an index too large?";
    if (line.find("Assertion 'this->_M_is_engaged()'") != std::string::npos)
        return "it used the value of an optional that has none: ask first whether there is one";
    return "it gave up (abort)" + after_colon(line);
}

std::string bad_memory(const LastWords& words) {
    if (words.kind != LastWords::crashed)
        return "it touched memory that is not its own: a pointer or an index gone astray?";
#ifdef SI_KERNEL
    if (words.code == SI_KERNEL) return "it followed a pointer that points nowhere: was it ever set?";
#endif
    if (words.address < first_page)
        return fmt::format("it followed a null pointer (address {:#x})", std::uint64_t{words.address});
    return fmt::format("it touched memory that is not its own (address {:#x}): a pointer or an index gone astray?",
                       std::uint64_t{words.address});
}

std::string crash(const Outcome& outcome) {
    const LastWords& words = outcome.last_words;
    if (words.kind == LastWords::threw)
        return fmt::format("it threw an exception that nobody caught: {}", printable(words.text));
    if (words.kind == LastWords::stack_overflow)
        return "its stack overflowed: a function that calls itself without end?";
    switch (outcome.status) {
        case SIGSEGV:
        case SIGBUS:
            return bad_memory(words);
        case SIGFPE:
            return "it divided a whole number by zero";
        case SIGILL:
        case SIGTRAP:
            return "it came to a place that it must never come to: does a function end without return?";
        case SIGABRT:
            return abort_words(last_line(outcome.errors));
        case SIGXFSZ:
            return fmt::format("it wrote a file of more than {}", in_mebibytes(outcome.limits.file));
        default:
            return fmt::format("signal {} ended it ({})", outcome.status, ::strsignal(outcome.status));
    }
}

}  // namespace

std::string how_it_ended(const Outcome& outcome) {
    switch (outcome.end) {
        case End::exited:
            if (outcome.last_words.kind == LastWords::left)
                return fmt::format("it called exit({}) before its work was done", outcome.status);
            if (outcome.status == 0) return "";
            return fmt::format("it ended with exit status {}", outcome.status) + after_colon(last_line(outcome.errors));
        case End::signal:
            return crash(outcome);
        case End::deadline:
            return fmt::format("it ran for {:g} s without ending: an endless loop?",
                               static_cast<double>(outcome.limits.time.count()) / 1000);
        case End::output:
            return fmt::format("it wrote more than {} without ending: an endless loop that prints?",
                               in_mebibytes(outcome.limits.endless));
        case End::memory:
            return outcome.limits.memory == 0
                       ? "it asked for more memory than there is: does something grow without end?"
                       : fmt::format("it asked for more memory than it may have ({}): does something grow without end?",
                                     in_mebibytes(outcome.limits.memory));
        case End::stopped:
            return "it was stopped";
        case End::not_started:
            return last_line(outcome.errors);
    }
    return "";
}

}  // namespace glassbox::learn
