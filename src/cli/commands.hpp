#pragma once
#include <CLI/CLI.hpp>

#include "cli/interrupt.hpp"

namespace glassbox {

/// What a subcommand needs besides its own arguments.
struct Session {
    Interrupt interrupt;
};

// Each function adds a subcommand to the program; it runs if the command line names it. Its work throws Error (exit
// status 1) or Cancelled (130).
void add_render(CLI::App& program, Session& session);
void add_measure(CLI::App& program, Session& session);
void add_shoot(CLI::App& program, Session& session);
void add_compare(CLI::App& program, Session& session);
void add_bench(CLI::App& program, Session& session);
void add_explain(CLI::App& program);
void add_again(CLI::App& program);
void add_scene(CLI::App& program);
void add_view(CLI::App& program, Session& session);
void add_learn(CLI::App& program, Session& session);
void add_doctor(CLI::App& program);

}  // namespace glassbox
