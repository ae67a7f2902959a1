#include "render/render.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/progress.hpp"
#include "output/output_file.hpp"

namespace glassbox {

namespace {

namespace fs = std::filesystem;

struct RenderRequest : Request {
    std::string out;
};

void run(const RenderRequest& request, Session& session) {
    const fs::path out(request.out.empty() ? fs::path(request.scene).stem().replace_extension(".png")
                                           : fs::path(request.out));
    check_picture_file(out);
    const Scene scene = load(request);
    const Image image = [&] {
        Progress progress("rendering", std::int64_t{scene.width} * scene.height);
        return render(scene, request.options, {request.threads, session.interrupt.token(), &progress.done()});
    }();
    write_picture(out, image, session.interrupt.token());
    if (request.out.empty()) fmt::print("{}\n", fs::absolute(out).string());
}

}  // namespace

void add_render(CLI::App& program, Session& session) {
    const auto request = std::make_shared<RenderRequest>();
    CLI::App* command = program.add_subcommand("render", "Draw a scene's picture into a file");
    add_scene_options(*command, *request);
    command->add_option("-o", request->out, "the picture to write (default: the scene's name and .png)")
        ->type_name("OUT.png|.ppm");
    command->callback([request, &session] { run(*request, session); });
}

}  // namespace glassbox
