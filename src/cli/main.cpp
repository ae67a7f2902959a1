#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <new>

#include "cli/commands.hpp"
#include "cli/refusal.hpp"
#include "cli/tell.hpp"
#include "render/job.hpp"
#include "render/typed.hpp"
#include "scene/error.hpp"

namespace {

constexpr int work_failed = 1;
constexpr int bad_command_line = 2;

void add_commands(CLI::App& program, glassbox::Session& session) {
    program.set_version_flag("--version", "glassbox " GLASSBOX_VERSION);
    program.require_subcommand(1);
    program.footer("'glassbox COMMAND --help' tells more. To begin with: glassbox render levental-2014");
    glassbox::add_render(program, session);
    glassbox::add_measure(program, session);
    glassbox::add_shoot(program, session);
    glassbox::add_explain(program);
    glassbox::add_again(program);
    glassbox::add_view(program, session);
    glassbox::add_compare(program, session);
    glassbox::add_scene(program);
    glassbox::add_learn(program, session);
    glassbox::add_bench(program, session);
    glassbox::add_doctor(program);
}

/// Runs the command line. Throws CLI::ParseError if it cannot be parsed.
int obey(CLI::App& program, int argc, char** argv) {
    try {
        program.parse(argc, argv);
        return 0;
    } catch (const CLI::Success& wanted) {  // --help, --version
        return program.exit(wanted);
    } catch (const CLI::RuntimeError& ended) {
        return ended.get_exit_code();
    } catch (const glassbox::WrongWord& wrong) {
        throw CLI::ValidationError(wrong.what());
    }
}

int run(CLI::App& program, int argc, char** argv) {
    glassbox::Session session;
    add_commands(program, session);
    try {
        const int status = obey(program, argc, argv);
        glassbox::check_printed();
        return status;
    } catch (const glassbox::Cancelled&) {
        const auto [message, status] = session.interrupt.ending();
        glassbox::tell(message);
        return status;
    }
}

}  // namespace

int main(int argc, char** argv) {
    using glassbox::tell;
    glassbox::keep_stderr_open();
    CLI::App program("A ray tracer that you can see through: renders a scene, and shows every number behind it.",
                     "glassbox");
    try {
        return run(program, argc, argv);
    } catch (const CLI::ParseError& error) {
        tell(glassbox::refusal(program, error));
        return bad_command_line;
    } catch (const glassbox::Error& error) {
        tell(error.what());
        return work_failed;
    } catch (const std::bad_alloc&) {
        tell("glassbox: error: out of memory; ask for a smaller picture with --size");
        return work_failed;
    } catch (const std::exception& error) {
        tell(fmt::format("glassbox: error: {}", error.what()));
        return work_failed;
    }
}
