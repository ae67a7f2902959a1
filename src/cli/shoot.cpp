#include "render/shoot.hpp"

#include <filesystem>
#include <memory>

#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/notes.hpp"
#include "cli/progress.hpp"
#include "cli/tell.hpp"
#include "output/hits_table.hpp"
#include "output/whole_file.hpp"
#include "scene/error.hpp"
#include "scene/rays_file.hpp"
#include "scene/scene_path.hpp"
#include "scene/shipped.hpp"

namespace glassbox {

namespace {

namespace fs = std::filesystem;

struct ShootRequest : Request {
    std::string rays;
    std::string out;  ///< empty: stdout
};

/// Throws Error if the table would replace one of its own inputs.
void check_keeps_inputs(const ShootRequest& request) {
    std::error_code none;
    for (const fs::path& input : {here_or_shipped(request.rays), scene_path(request.scene)})
        if (fs::is_regular_file(request.out, none) && fs::equivalent(request.out, input, none))
            throw error_at({request.out}, "this file is read, and would be lost; name another one for the hits");
}

void print(const std::vector<Shot>& shots, Scalar scalar, const std::stop_token& stop) {
    const auto sink = [&](std::span<const std::byte> piece) {
        if (stop.stop_requested()) throw Cancelled{};
        print_bytes({reinterpret_cast<const char*>(piece.data()), piece.size()});
    };
    hits_table(shots, scalar, sink);
    check_printed();
}

void run(const CLI::App& command, const ShootRequest& request, Session& session) {
    if (!request.out.empty()) {
        check_writable(request.out);
        check_keeps_inputs(request);
    }
    const Scene scene = load(request);
    const std::vector<Ray<double>> rays = read_rays(here_or_shipped(request.rays));
    note(command, "not used", unused_options(command, Rays::of_ones_own, request.setup.options));
    const std::stop_token stop = session.interrupt.token();
    const std::vector<Shot> shots = [&] {
        Progress progress("shooting", static_cast<std::int64_t>(rays.size()));
        return shoot(scene, request.setup.options, rays, {request.threads, stop, &progress.done()});
    }();
    const Scalar scalar = request.setup.options.scalar;
    if (request.out.empty()) print(shots, scalar, stop);
    else
        write_whole(
            request.out, [&](const Sink& sink) { hits_table(shots, scalar, sink); }, stop);
}

/// A command to copy, and a file to start from.
constexpr const char* example = R"(Example: glassbox shoot room --rays rays.csv --out hits.csv
where rays.csv, say, holds a ray's origin and direction in each line after the first:
  ox,oy,oz,dx,dy,dz
  500,250,250,-1,0,0
  0x1p9,250,0.5,-1,1e-3,0)";

}  // namespace

void add_shoot(CLI::App& program, Session& session) {
    const auto request = std::make_shared<ShootRequest>();
    CLI::App* command = program.add_subcommand("shoot", "Trace rays of your own and tell what becomes of each");
    add_scene_options(*command, *request);
    add_file(*command, "--rays", "RAYS.csv", "the rays: a table with the header ox,oy,oz,dx,dy,dz", request->rays)
        ->required();
    add_file(*command, "-o,--out", "HITS.csv", "where to write what became of them (default: the terminal)",
             request->out);
    command->footer(example);
    command->callback([request, command, &session] { run(*command, *request, session); });
}

}  // namespace glassbox
