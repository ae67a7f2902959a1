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

namespace {

Error not_printed(int number) {
    const std::string why = number == 0 ? "some of it was not taken" : std::generic_category().message(number);
    const char* remedy =
        number == EFBIG ? "raise the limit on the size of files (ulimit -f)" : "send it to a file or a terminal";
    return error_at({"standard output"}, fmt::format("cannot write: {}; {}", why, remedy));
}

}  // namespace

void tell(std::string_view line) { std::fputs((printable(line) + '\n').c_str(), stderr); }

void print_bytes(std::string_view bytes) {
    if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) != bytes.size()) throw not_printed(errno);
}

void print_text(std::string_view text) { print_bytes(printable_lines(text)); }

void print_name(const std::string& name) {
    print_bytes((::isatty(STDOUT_FILENO) == 1 ? printable(name) : name) + '\n');
}

void check_printed() {
    errno = 0;
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) throw not_printed(errno);
}

void keep_stderr_open() {
    if (::fcntl(STDERR_FILENO, F_GETFD) != -1) return;
    const int null = ::open("/dev/null", O_WRONLY);
    if (null < 0 || null == STDERR_FILENO) return;
    ::dup2(null, STDERR_FILENO);
    ::close(null);
}

}  // namespace glassbox
