#pragma once
#include <signal.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <string>

namespace glassbox::learn {

/// How a program ended, as it reports itself. It lies in memory shared with whoever runs the program (subprocess.hpp),
/// so that it can be read when the program has ended. This header stands alone: programs made of a learner's code
/// include it.
struct LastWords {
    enum Kind : std::uint32_t {
        none,            ///< it never listened, or something ended it from outside
        running,         ///< it listens; what ended it left it no time to report (SIGKILL)
        finished,        ///< its work is done
        left,            ///< exit was called before that
        threw,           ///< an exception that nobody caught: `text` is its what()
        crashed,         ///< the signal `signal`, with its si_code, and the address that it is about
        cannot_write,    ///< it could not write its output: the disk is full, say
        stack_overflow,  ///< the stack was used up, most likely by a function that calls itself without end
    };
    volatile std::uint32_t kind = none;
    volatile std::int32_t signal = 0;
    volatile std::int32_t code = 0;
    volatile std::uint64_t address = 0;
    char text[480] = "";
};

/// The environment variables that hold the descriptors of the memory for the last words and of the caller's own memory.
inline constexpr const char* last_words_variable = "GLASSBOX_LAST_WORDS";
inline constexpr const char* shared_memory_variable = "GLASSBOX_SHARED_MEMORY";

/// Maps `bytes` bytes of memory that the caller handed down under that name; null if there is none.
inline void* handed_down(const char* variable, std::size_t bytes) {
    const char* descriptor = std::getenv(variable);
    if (descriptor == nullptr) return nullptr;
    void* memory = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, std::atoi(descriptor), 0);
    return memory == MAP_FAILED ? nullptr : memory;
}

/// This program's last words: in the caller's memory, or in its own if nobody listens. (Signal handlers get no
/// context.)
inline LastWords& last_words() {
    static LastWords own;
    static void* shared = handed_down(last_words_variable, sizeof(LastWords));
    return shared ? *static_cast<LastWords*>(shared) : own;
}

namespace last_words_detail {

inline std::uintptr_t& stack_top() {
    static std::uintptr_t top = 0;
    return top;
}

inline std::uintptr_t stack_size() {
    rlimit limit{};
    const bool known = ::getrlimit(RLIMIT_STACK, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
    return known ? static_cast<std::uintptr_t>(limit.rlim_cur) : std::uintptr_t{8} << 20;
}

/// Below the stack's end is its guard page; a large frame may reach past that, too.
inline bool is_beyond_the_stack(std::uintptr_t address) {
    const std::uintptr_t end = stack_top() - stack_size();
    const std::uintptr_t slack = std::uintptr_t{1} << 20;
    return address >= end - slack && address < end + slack / 4;
}

inline void on_signal(int signal, siginfo_t* info, void*) {
    LastWords& words = last_words();
    if (words.kind != LastWords::threw) {  // else std::terminate has reported already, and this is its abort
        const auto address = reinterpret_cast<std::uintptr_t>(info->si_addr);
        const bool memory = signal == SIGSEGV || signal == SIGBUS;
        words.signal = signal;
        words.code = info->si_code;
        words.address = address;
        words.kind = memory && is_beyond_the_stack(address) ? LastWords::stack_overflow : LastWords::crashed;
    }
    ::signal(signal, SIG_DFL);
    ::raise(signal);
}

inline void say(const char* text) {
    LastWords& words = last_words();
    std::strncpy(words.text, text, sizeof(words.text) - 1);
    words.kind = LastWords::threw;
}

[[noreturn]] inline void on_terminate() {
    try {
        if (const std::exception_ptr exception = std::current_exception()) std::rethrow_exception(exception);
        say("std::terminate was called");
    } catch (const std::exception& exception) {
        say(exception.what());
    } catch (const char* text) {
        say(text);
    } catch (const std::string& text) {
        say(text.c_str());
    } catch (int number) {
        say(("the number " + std::to_string(number)).c_str());
    } catch (...) {
        say("something that is not a std::exception");
    }
    std::abort();
}

inline void on_exit() {
    if (last_words().kind == LastWords::running) last_words().kind = LastWords::left;
}

}  // namespace last_words_detail

/// From now on this program's end is reported. Call it first in main(): it notes where the stack begins.
inline void listen_for_the_end() {
    using namespace last_words_detail;
    last_words().kind = LastWords::running;
    stack_top() = reinterpret_cast<std::uintptr_t>(__builtin_frame_address(0));
#ifdef __linux__
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // nobody could stop it after its caller has gone
#endif
    static char handlers_stack[64 * 1024];  // the handler needs a stack when the main one is used up
    stack_t stack{};
    stack.ss_sp = handlers_stack;
    stack.ss_size = sizeof(handlers_stack);
    ::sigaltstack(&stack, nullptr);
    struct sigaction action {};
    action.sa_sigaction = on_signal;
    action.sa_flags = SA_SIGINFO | SA_ONSTACK;
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) ::sigaction(signal, &action, nullptr);
    std::set_terminate(on_terminate);
    std::atexit(on_exit);
}

/// The work is done; from now on an exit is normal.
inline void work_is_done() { last_words().kind = LastWords::finished; }

}  // namespace glassbox::learn
