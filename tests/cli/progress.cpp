// Progress: a bar on a terminal, erased at the end; plain lines elsewhere; nothing for short work.
#include <doctest.h>
#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <unistd.h>

#include <future>

#include "cli/program.hpp"

using namespace glassbox::test;
using std::chrono::milliseconds;

namespace {

const Arguments long_work{"render", "room", "--size", "8000x6000", "-o", "o.png"};

/// A pseudo-terminal: what is written to `name` can be read here.
class Terminal {
public:
    Terminal() : descriptor_(::posix_openpt(O_RDWR | O_NOCTTY)) {
        if (descriptor_ < 0 || ::grantpt(descriptor_) != 0 || ::unlockpt(descriptor_) != 0)
            throw std::runtime_error("cannot make a terminal");
        name_ = ::ptsname(descriptor_);
        kept_open_ = ::open(name_.c_str(), O_RDWR | O_NOCTTY);
    }
    Terminal(const Terminal&) = delete;
    Terminal& operator=(const Terminal&) = delete;
    ~Terminal() {
        ::close(kept_open_);
        ::close(descriptor_);
    }

    const char* name() const { return name_.c_str(); }

    /// All that was written to it and is not read yet.
    std::string text() const {
        std::string text;
        pollfd ready{descriptor_, POLLIN, 0};
        char piece[4096];
        while (::poll(&ready, 1, 100) > 0) {
            const ssize_t size = ::read(descriptor_, piece, sizeof piece);
            if (size <= 0) break;
            text.append(piece, static_cast<std::size_t>(size));
        }
        return text;
    }

private:
    int descriptor_, kept_open_ = -1;
    std::string name_;
};

}  // namespace

TEST_CASE("on a terminal: a bar with the time left, redrawn in its line, and gone at the end") {
    const Folder folder;
    const Terminal terminal;
    const Ran ran =
        run_glassbox(long_work, {.folder = folder.path, .err = terminal.name(), .signal_at = milliseconds(1500)});
    CHECK(ran.status == 130);
    const std::string shown = terminal.text();
    const std::string erased = "\r\x1b[K";
    CHECK(shown.starts_with(erased + "rendering ["));
    CHECK(shown.find(" %, ") != std::string::npos);
    CHECK(shown.ends_with(erased + "glassbox: interrupted; no half-written file is left\r\n"));
}

TEST_CASE("elsewhere: a plain line now and then") {
    const Folder folder;
    const Ran ran = run_glassbox(long_work, {.folder = folder.path, .signal_at = milliseconds(1500)});
    CHECK(ran.err.starts_with("rendering: "));
    CHECK(ran.err.find(" % done, ") != std::string::npos);
    CHECK(ran.err.find('\r') == std::string::npos);
    CHECK(ran.err.find('\x1b') == std::string::npos);
}

TEST_CASE("nothing for work that is done in under a second") {
    const Folder folder;
    const Terminal terminal;
    const Ran ran = run_glassbox({"render", "sphere", "--size", "10x10", "-o", "o.png"},
                                 {.folder = folder.path, .err = terminal.name()});
    CHECK(ran.status == 0);
    CHECK(terminal.text() == "");
}
