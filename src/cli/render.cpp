#include "render/render.hpp"

#include <filesystem>
#include <memory>

#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/notes.hpp"
#include "cli/progress.hpp"
#include "cli/tell.hpp"
#include "output/output_file.hpp"
#include "scene/scene_path.hpp"

namespace glassbox {

namespace {

namespace fs = std::filesystem;

struct RenderRequest : Request {
    std::string out;
};

void run(const CLI::App& command, const RenderRequest& request, Session& session) {
    const fs::path out = request.out.empty() ? scene_path(request.scene).stem() += ".png" : fs::path(request.out);
    check_picture_file(out);
    const Scene scene = load(request);
    note(command, "not used", unused_options(command, Rays::of_a_picture, request.setup.options));
    const Image image = [&] {
        Progress progress("rendering", std::int64_t{scene.width} * scene.height);
        return render(scene, request.setup.options, {request.threads, session.interrupt.token(), &progress.done()});
    }();
    write_picture(out, image, {render_command(scene_words(request), picture_extension(out))},
                  session.interrupt.token());
    if (request.out.empty()) print_name(fs::absolute(out).string());
}

}  // namespace

void add_render(CLI::App& program, Session& session) {
    const auto request = std::make_shared<RenderRequest>();
    CLI::App* command = program.add_subcommand("render", "Draw a scene's picture into a file");
    add_scene_options(*command, *request);
    add_file(*command, "-o,--out", "OUT.png|.ppm", "the picture to write (default: the scene's name and .png, here)",
             request->out);
    command->footer("Example: glassbox render room --size 800x600 --turn z:10 -o room.png");
    command->callback([request, command, &session] { run(*command, *request, session); });
}

}  // namespace glassbox
