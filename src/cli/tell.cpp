#include "cli/tell.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <system_error>

#include "scene/error.hpp"
#include "scene/printable.hpp"

namespace glassbox {

void tell(std::string_view line) { std::fputs((printable(line) + '\n').c_str(), stderr); }

void print_text(std::string_view text) { fmt::print("{}", printable_lines(text)); }

void print_name(const std::string& name) { fmt::print("{}\n", ::isatty(STDOUT_FILENO) == 1 ? printable(name) : name); }

void check_printed() {
    errno = 0;
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return;
    const std::string why = errno == 0 ? "some of it was not taken" : std::generic_category().message(errno);
    throw error_at({"standard output"}, fmt::format("cannot write: {}; send it to a file or a terminal", why));
}

void keep_stderr_open() {
    if (::fcntl(STDERR_FILENO, F_GETFD) != -1) return;
    const int null = ::open("/dev/null", O_WRONLY);
    if (null < 0 || null == STDERR_FILENO) return;
    ::dup2(null, STDERR_FILENO);
    ::close(null);
}

}  // namespace glassbox
