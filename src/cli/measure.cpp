#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/notes.hpp"
#include "cli/progress.hpp"
#include "output/output_file.hpp"
#include "render/render.hpp"
#include "render/typed.hpp"
#include "scene/suggestion.hpp"

namespace glassbox {

namespace {

struct MeasureRequest : Request {
    std::vector<const Measurement*> wanted;
    SetSpacing spacing;
    std::string out;
};

/// The measurements that "depth,n.l" names.
std::vector<const Measurement*> read_wanted(const std::string& typed) {
    std::vector<const Measurement*> wanted;
    for (const std::string& name : between_commas(typed)) {
        wanted.push_back(&measurement("--what", name));
        if (std::count(wanted.begin(), wanted.end(), wanted.back()) > 1)
            throw wrong("--what", fmt::format("'{}' is there twice; name it once", name));
    }
    return wanted;
}

std::string list() {
    std::string lines = "What can be measured, with its unit in brackets:";
    for (const Measurement& each : measurements())
        lines += fmt::format("\n  {:<14}{}{}", each.name, each.explanation,
                             each.unit.empty() ? "" : fmt::format(" [{}]", each.unit));
    return lines + "\n\nExample: glassbox measure room --what depth,n.l -o room-depth.png";
}

/// "n.h (phong has no half vector)" for each measurement without a value at any pixel.
std::vector<std::string> without_value(const std::vector<Measured>& all) {
    std::vector<std::string> names;
    for (const Measured& measured : all)
        if (const std::string& why = measured.channels.front().why_no_value; !why.empty())
            names.push_back(fmt::format("{} ({})", measured.what->name, why));
    return names;
}

void run(const CLI::App& command, const MeasureRequest& request, Session& session) {
    check_measurements_file(request.out);
    const Scene scene = load(request);
    note(command, "not used", unused_options(command, Rays::of_a_picture, request.setup.options));
    std::vector<std::vector<Channel>> channels = [&] {
        Progress progress("measuring", std::int64_t{scene.width} * scene.height);
        return measure(scene, request.setup.options, request.wanted,
                       {request.threads, session.interrupt.token(), &progress.done()});
    }();
    std::vector<Measured> measured;
    for (std::size_t i = 0; i < channels.size(); ++i)
        measured.push_back({request.wanted[i], channels[i], request.spacing});
    note(command, "no value at any pixel", without_value(measured));
    std::vector<std::string_view> names;
    for (const Measurement* what : request.wanted) names.emplace_back(what->name);
    const Origin origin{measure_command(scene_words(request), names, measurements_extension(request.out))};
    write_measurements(request.out, measured, origin, session.interrupt.token());
}

}  // namespace

void add_measure(CLI::App& program, Session& session) {
    const auto request = std::make_shared<MeasureRequest>();
    CLI::App* command =
        program.add_subcommand("measure", "Write what the formulas computed at each pixel, as heat maps or numbers");
    add_scene_options(*command, *request);
    command
        ->add_option_function<std::string>(
            "--what", [request](const std::string& typed) { request->wanted = read_wanted(typed); },
            "what to measure; several separated by commas")
        ->type_name("NAME[,NAME...]")
        ->required();
    const std::vector<std::string_view> known = names(spacings);
    command
        ->add_option_function<std::string>(
            "--scale", [request](const std::string& typed) { request->spacing = chosen("--scale", typed, spacings); },
            fmt::format("of the heat maps' colours: {} (default: the measurement's own)",
                        either({known.begin(), known.end()})))
        ->type_name("SCALE");
    add_file(*command, "-o,--out", "OUT.png|.ppm|.csv|.exr", "heat maps with legends, or the numbers", request->out)
        ->required();
    command->footer(list());
    command->callback([request, command, &session] { run(*command, *request, session); });
}

}  // namespace glassbox
