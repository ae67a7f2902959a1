#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/notes.hpp"
#include "cli/progress.hpp"
#include "cli/tell.hpp"
#include "compare/pictures_report.hpp"
#include "compare/rays_report.hpp"
#include "compare/words.hpp"
#include "output/output_file.hpp"
#include "output/read_picture.hpp"
#include "render/search/surfaces.hpp"
#include "render/typed.hpp"
#include "scene/error.hpp"
#include "scene/rays_file.hpp"
#include "scene/scene_path.hpp"
#include "scene/shipped.hpp"

namespace glassbox {

namespace {

constexpr int beyond_rounding = 1;

struct CompareRequest : Request {
    std::string picture, rays, hits, out;
    Theirs theirs;
    int worst = 5;
    bool json = false;
};

/// The formulas that were typed, where they were; else all that are geometry.
Theirs theirs_of(const CLI::App& command, const CompareRequest& request) {
    Theirs theirs = request.theirs;
    if (command.get_option("--sphere")->count() > 0) theirs.formulas.spheres = {request.setup.options.sphere_rule};
    if (command.get_option("--triangle")->count() > 0)
        theirs.formulas.triangles = {request.setup.options.triangle_rule};
    return theirs;
}

/// Throws WrongWord if it is not clear what is to be compared.
void check_asked(const CompareRequest& request) {
    const bool has_rays = !request.rays.empty(), has_hits = !request.hits.empty();
    if (!request.picture.empty() && (has_rays || has_hits))
        throw wrong(has_rays ? "--rays" : "--hits", "rays or a picture can be compared, one at a time; leave out one");
    if (request.picture.empty() && !has_rays && !has_hits)
        throw wrong("THEIRS.png", "it is missing; or write --rays RAYS.csv --hits THEIRS.csv");
    if (has_rays && !request.out.empty()) throw wrong("--out", "rays have no picture; leave it out");
    if (has_rays != has_hits)
        throw wrong(has_rays ? "--hits" : "--rays", "it is missing; write --rays RAYS.csv --hits THEIRS.csv");
    if (!is_proven(request.setup.options.scalar))
        throw wrong("--scalar",
                    "what theirs is compared with is always proven: certified or exact; what they compute in "
                    "is --precision float or double");
}

/// Whether there are differences that rounding does not explain.
bool compare_rays(const CLI::App& command, const CompareRequest& request, Session& session) {
    const Scene scene = load(request);
    const Options& options = request.setup.options;
    const std::vector<Ray<double>> rays = read_rays(here_or_shipped(request.rays));
    const auto [spheres, triangles] = count_surfaces(scene, options.stage);
    const Claims claims = read_hits(here_or_shipped(request.hits), rays.size(), spheres + triangles);
    note(command, "not used", unused_options(command, Rays::of_ones_own, options));
    const Theirs theirs = theirs_of(command, request);
    const auto compared_in = [&](TheirPrecision precision, std::vector<Shot> truth) {
        const std::int64_t times = truth.empty() ? 2 : 1;  // shot, then judged
        Progress progress("comparing", times * static_cast<std::int64_t>(rays.size()));
        return compare_rays(scene, options, rays, claims, {precision, theirs.formulas},
                            {request.threads, session.interrupt.token(), &progress.done()}, std::move(truth));
    };
    const RayComparison comparison = compared_in(theirs.precision, {});
    const std::size_t beyond = count_beyond_rounding(comparison);
    const auto command_for = [&](std::size_t ray) {
        if (!is_valid(rays[ray])) return std::string();
        return explain_ray_command(words_of_own_rays(request), rays[ray]);
    };
    RaysReport report{comparison, claims, theirs, static_cast<std::size_t>(request.worst), command_for};
    if (beyond > 0 && theirs.precision == TheirPrecision::double_)
        report.beyond_float = count_beyond_rounding(compared_in(TheirPrecision::float_, comparison.ours));
    print_text(request.json ? to_json(report) : to_text(report));
    return beyond > 0;
}

/// Throws Error if the picture of the differences would replace what is read.
void check_keeps_pictures(const CompareRequest& request) {
    check_picture_file(request.out);
    std::error_code none;
    for (const std::filesystem::path& input : {std::filesystem::path(request.picture), scene_path(request.scene)})
        if (std::filesystem::is_regular_file(request.out, none) &&
            std::filesystem::equivalent(request.out, input, none))
            throw error_at({request.out}, "this file is read, and would be lost; name another one for the differences");
}

/// Whether there are differences that rounding does not explain.
bool compare_pictures(const CLI::App& command, const CompareRequest& request, Session& session) {
    if (!request.out.empty()) check_keeps_pictures(request);
    const Scene scene = load(request);
    const Options& options = request.setup.options;
    const Image picture = read_picture(request.picture);
    if (picture.width != scene.width || picture.height != scene.height)
        throw error_at(
            {request.picture},
            fmt::format("it has {}x{} pixels, and the scene's picture {}x{}; write --size {}x{} if that is its "
                        "size, or render theirs anew",
                        picture.width, picture.height, scene.width, scene.height, picture.width, picture.height));
    note(command, "not used", unused_options(command, Rays::of_a_picture, options));
    const Theirs theirs = theirs_of(command, request);
    const auto compared_in = [&](TheirPrecision precision) {
        Progress progress("comparing", 2 * std::int64_t{scene.width} * scene.height);  // drawn, then judged
        return compare_pictures(scene, request.size.has_value(), options, picture, {precision, theirs.formulas},
                                {request.threads, session.interrupt.token(), &progress.done()});
    };
    const PictureComparison comparison = compared_in(theirs.precision);
    const std::size_t beyond = count_beyond_rounding(comparison);
    const auto command_for = [&](Pixel pixel) { return explain_command(scene_words(request), pixel); };
    PicturesReport report{comparison, theirs, static_cast<std::size_t>(request.worst), command_for};
    if (beyond > 0 && theirs.precision == TheirPrecision::double_ && comparison.is_all())
        report.beyond_float = count_beyond_rounding(compared_in(TheirPrecision::float_));
    if (!request.out.empty())
        write_picture(request.out, difference_picture(comparison, picture), {}, session.interrupt.token());
    print_text(request.json ? to_json(report) : to_text(report));
    return beyond > 0;
}

void run(const CLI::App& command, const CompareRequest& request, Session& session) {
    check_asked(request);
    const bool has_mistakes =
        request.picture.empty() ? compare_rays(command, request, session) : compare_pictures(command, request, session);
    check_printed();
    if (has_mistakes) throw CLI::RuntimeError(beyond_rounding);
}

}  // namespace

void add_compare(CLI::App& program, Session& session) {
    const auto request = std::make_shared<CompareRequest>();
    CLI::App* command = program.add_subcommand("compare", "Tell why another tracer's picture or hits differ");
    add_scene_options(*command, *request);
    command->add_option("THEIRS.png", request->picture, "their picture of the scene, .png or .ppm")->type_name(" ");
    add_file(*command, "--rays", "RAYS.csv", "instead of a picture, rays: as shoot reads them", request->rays);
    add_file(*command, "--hits", "THEIRS.csv", "and what they say of each: ray,verdict,surface,t, as shoot writes it",
             request->hits);
    command
        ->add_option_function<std::string>(
            "--precision",
            [request](const std::string& typed) {
                request->theirs.precision = chosen("--precision", typed, precisions);
            },
            "what they compute in: double or float (default: double)")
        ->type_name("P");
    command
        ->add_option_function<std::string>(
            "--worst",
            [request](const std::string& typed) { request->worst = whole_number("--worst", typed, 0, 1000000); },
            "how many differences to tell, the worst first (default: 5)")
        ->type_name("N");
    add_file(*command, "-o,--out", "DIFF.png|.ppm", "a picture of the differences, in bright colours by their cause",
             request->out);
    command->add_flag("--json", request->json, "as JSON (docs/compare.md)");
    command->footer(
        "Example: glassbox compare room theirs.png --precision float -o why.png\n"
        "Exit status: 0 if nothing differs but what rounding may, else 1.");
    command->callback([request, command, &session] { run(*command, *request, session); });
}

}  // namespace glassbox
