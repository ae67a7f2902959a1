// A program that ends in the way named by its first argument, for tests/learn/child.cpp.
#include <sys/types.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "learn/subprocess/last_words.hpp"

using namespace glassbox::learn;

namespace {

struct Point {
    double x, y;
};

volatile int depth_reached = 0;
volatile int zero = 0;
Point* volatile nowhere = nullptr;

int call_myself(int n) {
    volatile char room[4096];
    room[0] = static_cast<char>(n);
    depth_reached = n;
    return call_myself(n + 1) + room[0];
}

void wait_for_ever() {
    while (true) std::this_thread::sleep_for(std::chrono::seconds(1));
}

void print_environment(const char* name) {
    const char* value = std::getenv(name);
    std::printf("%s\n", value ? value : "(not set)");
}

int end(const std::string& kind, const std::vector<std::string>& more) {
    if (kind == "well") {
        std::puts("out");
        std::fputs("err\n", stderr);
        work_is_done();
        return 0;
    }
    if (kind == "arguments")
        for (const std::string& one : more) std::printf("[%s]", one.c_str());
    if (kind == "environment") print_environment(more.at(0).c_str());
    if (kind == "folder") {
        char folder[4096];
        std::puts(::getcwd(folder, sizeof folder));
    }
    if (kind == "input") std::printf("%d\n", std::getchar());
    if (kind == "status") return std::stoi(more.at(0));
    if (kind == "null") std::printf("%g", nowhere->y);
    if (kind == "astray") std::printf("%g", reinterpret_cast<Point*>(0x7ff000000000)->y);
    if (kind == "stack") return call_myself(0);
    if (kind == "divide") return depth_reached / zero;
    if (kind == "abort") std::abort();
    if (kind == "assertion") {
        std::fputs("vec3.hpp:12: Assertion 'i < 3' failed.\n", stderr);
        std::abort();
    }
    // As g++'s library says it where assertions are on.
    if (kind == "beyond-a-vector") {
        std::fputs("stl_vector.h:1123: … [with _Tp = float]: Assertion '__n < this->size()' failed.\n", stderr);
        std::abort();
    }
    if (kind == "empty-optional") {
        std::fputs("optional:484: … [with _Tp = Hit]: Assertion 'this->_M_is_engaged()' failed.\n", stderr);
        std::abort();
    }
    if (kind == "exit") std::exit(0);
    if (kind == "exception") throw std::runtime_error("h is not a unit vector");
    if (kind == "number") throw 42;
    if (kind == "loop") wait_for_ever();
    if (kind == "ignores-signals") {
        for (int signal = 1; signal < 32; ++signal) std::signal(signal, SIG_IGN);
        wait_for_ever();
    }
    if (kind == "print")
        while (true) std::puts("again and again and again and again and again and again and again and again");
    if (kind == "much") {  // more than is kept, less than the limit
        std::fputs("the beginning", stdout);
        for (int i = 0; i < 1'000'000; ++i) std::putchar('.');
    }
    if (kind == "memory") {
        std::vector<std::vector<char>> all;
        while (true) all.emplace_back(std::size_t{64} << 20, 'x');
    }
    if (kind == "file") {
        std::ofstream file(more.at(0));
        while (file << std::string(1 << 20, 'x') << std::flush) {
        }
        wait_for_ever();
    }
    if (kind == "shared") {
        auto* number = static_cast<volatile int*>(handed_down(shared_memory_variable, sizeof(int)));
        *number = *number * 2;
    }
    if (kind == "family") {  // prints the id of a process of its own, which runs for ever
        const pid_t child = ::fork();
        if (child == 0) wait_for_ever();
        std::printf("%d\n", static_cast<int>(child));
    }
    work_is_done();
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    listen_for_the_end();
    return end(argv[1], {argv + 2, argv + argc});
}
