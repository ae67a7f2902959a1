#include <fmt/format.h>

#include <memory>
#include <vector>

#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/progress.hpp"
#include "output/output_file.hpp"
#include "render/render.hpp"
#include "scene/suggestion.hpp"

namespace glassbox {

namespace {

struct MeasureRequest : Request {
    std::vector<const Measurement*> wanted;
    std::string out;
};

const Measurement* named(const std::string& name) {
    if (const Measurement* found = find_measurement(name)) return found;
    std::vector<std::string_view> known;
    for (const Measurement& each : measurements()) known.push_back(each.name);
    throw CLI::ValidationError("--what", fmt::format("'{}' is not known; {}", name, suggestion(name, known)));
}

std::string list() {
    std::string lines = "What can be measured, with its unit in brackets:";
    for (const Measurement& each : measurements())
        lines += fmt::format("\n  {:<14}{}{}", each.name, each.explanation,
                             each.unit.empty() ? "" : fmt::format(" [{}]", each.unit));
    return lines;
}

void run(const MeasureRequest& request, Session& session) {
    check_measurements_file(request.out);
    const Scene scene = load(request);
    std::vector<std::vector<Plane>> planes = [&] {
        Progress progress("measuring", std::int64_t{scene.width} * scene.height);
        return measure(scene, request.options, request.wanted,
                       {request.threads, session.interrupt.token(), &progress.done()});
    }();
    std::vector<Measured> measured;
    for (std::size_t i = 0; i < planes.size(); ++i) measured.push_back({request.wanted[i], planes[i]});
    write_measurements(request.out, measured, session.interrupt.token());
}

}  // namespace

void add_measure(CLI::App& program, Session& session) {
    const auto request = std::make_shared<MeasureRequest>();
    CLI::App* command =
        program.add_subcommand("measure", "Write what the formulas computed at each pixel, as heat maps or numbers");
    add_scene_options(*command, *request);
    command
        ->add_option_function<std::vector<std::string>>(
            "--what",
            [request](const std::vector<std::string>& names) {
                for (const std::string& name : names) request->wanted.push_back(named(name));
            },
            "what to measure; several separated by commas")
        ->delimiter(',')
        ->type_name("NAME[,NAME...]")
        ->required();
    command->add_option("-o", request->out, "a picture with legends, or the numbers")
        ->type_name("OUT.png|.csv|.exr")
        ->required();
    command->footer(list());
    command->callback([request, &session] { run(*request, session); });
}

}  // namespace glassbox
