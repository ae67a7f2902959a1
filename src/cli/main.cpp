#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <new>

#include "cli/commands.hpp"
#include "render/job.hpp"
#include "scene/error.hpp"

namespace {

constexpr int work_failed = 1;
constexpr int bad_command_line = 2;

int refuse(const CLI::App& program, const CLI::ParseError& error) {
    std::string name = "glassbox";
    for (const CLI::App* command : program.get_subcommands()) name += " " + command->get_name();
    fmt::print(stderr, "{}: error: {}; see '{} --help'\n", name, error.what(), name);
    return bad_command_line;
}

}  // namespace

int main(int argc, char** argv) {
    glassbox::Session session;
    CLI::App program("A ray tracer that you can see through: renders a scene, and shows every number behind it.",
                     "glassbox");
    program.set_version_flag("--version", "glassbox " GLASSBOX_VERSION);
    program.require_subcommand(1);
    glassbox::add_render(program, session);
    glassbox::add_measure(program, session);
    glassbox::add_shoot(program, session);
    glassbox::add_bench(program, session);
    glassbox::add_doctor(program);
    try {
        program.parse(argc, argv);
        return 0;
    } catch (const CLI::Success& wanted) {
        return program.exit(wanted);
    } catch (const CLI::RuntimeError& ended) {
        return ended.get_exit_code();
    } catch (const CLI::ParseError& error) {
        return refuse(program, error);
    } catch (const glassbox::Cancelled&) {
        fmt::print(stderr, "glassbox: interrupted; nothing was written\n");
        return glassbox::Interrupt::exit_status;
    } catch (const glassbox::Error& error) {
        fmt::print(stderr, "{}\n", error.what());
        return work_failed;
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "glassbox: error: out of memory; ask for a smaller picture with --size\n");
        return work_failed;
    } catch (const std::exception& error) {
        fmt::print(stderr, "glassbox: error: {}\n", error.what());
        return work_failed;
    }
}
