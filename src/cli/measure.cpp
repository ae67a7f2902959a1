#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/notes.hpp"
#include "cli/progress.hpp"
#include "output/output_file.hpp"
#include "render/measure/measure_difference.hpp"
#include "render/render.hpp"
#include "render/typed.hpp"
#include "scene/suggestion.hpp"

namespace glassbox {

namespace {

struct MeasureRequest : Request {
    std::vector<const Measurement*> wanted;
    std::optional<Minus> minus;
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

/// What was measured, with what keeps it.
struct Kept {
    std::vector<std::vector<Channel>> channels;
    std::vector<MeasuredDifference> differences;
    std::vector<Measured> measured;
};

/// Throws WrongWord where a difference, or its scale, has no meaning.
void check_difference(const MeasureRequest& request) {
    if (!request.minus) return;
    for (const Measurement* what : request.wanted)
        if (const std::string why = why_no_difference(*what); !why.empty()) throw wrong("--minus", why);
    if (request.spacing == Spacing::log || request.spacing == Spacing::percentile)
        throw wrong("--scale", "a difference has both signs; linear and symlog show them");
}

/// By what is measured; the scene has its part of it already.
Setup setup_of(const MeasureRequest& request, const Scene& scene) {
    Setup setup = setup_of(scene);
    setup.options = request.setup.options;
    return setup;
}

Kept measured(const Scene& scene, const MeasureRequest& request, Session& session) {
    const std::int64_t times = request.minus ? 2 : 1;
    Progress progress("measuring", times * scene.width * scene.height);
    const Job job{request.threads, session.interrupt.token(), &progress.done()};
    Kept kept;
    if (request.minus) {
        kept.differences = measure_difference(scene, setup_of(request, scene), *request.minus, request.wanted, job);
        for (const MeasuredDifference& each : kept.differences)
            kept.measured.push_back({each.what.get(), {&each.channel, 1}, request.spacing});
    } else {
        kept.channels = measure(scene, request.setup.options, request.wanted, job);
        for (std::size_t i = 0; i < kept.channels.size(); ++i)
            kept.measured.push_back({request.wanted[i], kept.channels[i], request.spacing});
    }
    return kept;
}

void run(const CLI::App& command, const MeasureRequest& request, Session& session) {
    check_difference(request);
    check_measurements_file(request.out);
    const Scene scene = load(request);
    note(command, "not used", unused_options(command, Rays::of_a_picture, request.setup.options));
    if (request.minus && changed_by(*request.minus, setup_of(request, scene)) == setup_of(request, scene))
        note(command, "--minus changes nothing", {"every difference is 0"});
    const Kept kept = measured(scene, request, session);
    note(command, "no value at any pixel", without_value(kept.measured));
    std::vector<std::string_view> names;
    for (const Measurement* what : request.wanted) names.emplace_back(what->name);
    const MeasureWords words{names, request.spacing, request.minus ? &*request.minus : nullptr};
    const Origin origin{measure_command(scene_words(request), words, measurements_extension(request.out))};
    write_measurements(request.out, kept.measured, origin, session.interrupt.token());
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
    command
        ->add_option_function<std::string>(
            "--minus", [request](const std::string& typed) { request->minus = minus("--minus", typed); },
            "what is measured so, minus the same with these settings changed: scalar:certified")
        ->type_name("NAME:VALUE[,...]");
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
