#include "render/shoot.hpp"

#include <memory>

#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/progress.hpp"
#include "output/hits_table.hpp"
#include "output/whole_file.hpp"
#include "scene/rays_file.hpp"

namespace glassbox {

namespace {

struct ShootRequest : Request {
    std::string rays;
    std::string out = "/dev/stdout";
};

void run(const ShootRequest& request, Session& session) {
    check_writable(request.out);
    const Scene scene = load(request);
    const std::vector<Ray<double>> rays = read_rays(request.rays);
    const std::vector<Shot> shots = [&] {
        Progress progress("shooting", static_cast<std::int64_t>(rays.size()));
        return shoot(scene, request.options, rays, {request.threads, session.interrupt.token(), &progress.done()});
    }();
    write_whole(
        request.out, [&](const Sink& sink) { hits_table(shots, request.options.scalar, sink); },
        session.interrupt.token());
}

}  // namespace

void add_shoot(CLI::App& program, Session& session) {
    const auto request = std::make_shared<ShootRequest>();
    CLI::App* command = program.add_subcommand("shoot", "Trace rays of your own and tell what becomes of each");
    add_scene_options(*command, *request);
    command->add_option("--rays", request->rays, "the rays: a table with the header ox,oy,oz,dx,dy,dz")
        ->type_name("RAYS.csv")
        ->required();
    command->add_option("--out", request->out, "where to write what became of them (default: the terminal)")
        ->type_name("HITS.csv");
    command->callback([request, &session] { run(*request, session); });
}

}  // namespace glassbox
