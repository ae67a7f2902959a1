#include "viewer/model/files/save_menu.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "output/output_file.hpp"
#include "render/command.hpp"
#include "render/job.hpp"
#include "render/measure/measure_difference.hpp"
#include "render/render.hpp"
#include "scene/error.hpp"
#include "viewer/model/overlay/difference.hpp"
#include "viewer/model/overlay/subtracted.hpp"
#include "viewer/model/state/command.hpp"
#include "viewer/model/state/state.hpp"
#include "viewer/model/work/results.hpp"

namespace glassbox {

namespace fs = std::filesystem;

namespace {

bool is_measured(SaveWhat what) { return what == SaveWhat::overlay || what == SaveWhat::numbers; }

/// "room-depth.png", or with a number where that is taken.
std::string free_name(const ViewerState& state, SaveWhat what) {
    const Minus* const minus = subtracted(state.overlay);
    const std::string& name_of_what = state.overlay.measurement;
    const std::string measured = minus ? difference_file_name(name_of_what, *minus) : name_of_what;
    constexpr std::string_view beside = "beside";
    std::vector<std::string_view> parts;
    if (is_measured(what)) parts.push_back(measured);
    if (what == SaveWhat::beside) parts.push_back(beside);
    const std::string extension = what == SaveWhat::numbers ? ".csv" : ".png";
    std::error_code none;
    std::string name = usual_name(state.file, parts, extension);
    for (int next = 2; fs::exists(name, none); ++next)
        name = usual_name(state.file, parts, fmt::format("-{}{}", next, extension));
    return name;
}

/// A picture that is there as a whole. Throws Error while it is not.
std::shared_ptr<const Image> whole(const Picture& picture) {
    if (!picture.image || picture.factor != 1)
        throw Error("error: it is still being drawn; save it when the whole of it is there");
    return picture.image;
}

std::shared_ptr<const Image> difference_beside(const Results& results) {
    const auto one = whole(results.picture), other = whole(results.other);
    if (one->width != other->width || one->height != other->height)
        throw Error("error: the two pictures differ in size; save it when both are drawn");
    return std::make_shared<const Image>(picture_difference(*one, *other).magnified);
}

/// Fills in what stands beside the picture.
Saving of_beside(Saving saving, const ViewerState& state, const Results& results) {
    switch (state.beside) {
        case Beside::other:
            saving.setup.options.scalar = state.other.scalar;
            saving.setup.options.sphere_rule = state.other.sphere_rule;
            saving.setup.options.triangle_rule = state.other.triangle_rule;
            saving.command = command_to_render(state, saving.setup, picture_extension(saving.file));
            return saving;
        case Beside::mine:
            saving.drawn = whole(results.other);
            return saving;
        case Beside::difference:
        case Beside::mine_difference:
            saving.drawn = difference_beside(results);
            return saving;
        default:
            throw Error("error: nothing stands beside the picture; choose it on the page Overlay");
    }
}

}  // namespace

std::vector<SaveChoice> save_choices(const ViewerState& state) {
    std::vector<SaveChoice> all{{SaveWhat::picture, "the picture (.png, .ppm)"}};
    if (find_measurement(state.overlay.measurement)) {
        const std::string what = name_of(state.overlay);
        all.push_back({SaveWhat::overlay, fmt::format("{}, coloured, with its legend (.png, .ppm)", what)});
        all.push_back({SaveWhat::numbers, fmt::format("{}, in numbers (.csv, .exr)", what)});
    }
    constexpr const char* besides[] = {"",
                                       "",
                                       "the picture beside, by the other scalar and rules (.png, .ppm)",
                                       "the difference of the two pictures (.png, .ppm)",
                                       "your own code's picture (.png, .ppm)",
                                       "your own code's difference from ours (.png, .ppm)"};
    if (const std::string label = besides[static_cast<int>(state.beside)]; !label.empty())
        all.push_back({SaveWhat::beside, label});
    return all;
}

void choose(ViewerState& state, SaveWhat what) {
    SaveMenu& menu = state.save_menu;
    menu.what = what;
    menu.typed = free_name(state, what);
    menu.asked.clear();
    menu.error.clear();
    ++menu.renewed;
}

void show_save_menu(ViewerState& state) {
    state.scene_menu.shown = state.copy_menu.shown = state.keys_shown = false;
    state.save_menu.shown = true;
    std::error_code none;
    state.save_menu.folder = fs::current_path(none);
    choose(state, state.overlay.measurement.empty() ? SaveWhat::picture : SaveWhat::overlay);
}

void type(SaveMenu& menu, const std::string& typed) {
    if (typed == menu.typed) return;
    menu.typed = typed;
    menu.asked.clear();
    menu.error.clear();
}

Saving saving(const ViewerState& state, const Results& results, SaveWhat what, const fs::path& file) {
    std::error_code none;
    Saving saving{fs::absolute(file, none), "", state.scene, state.setup.now()};
    if (is_measured(what)) {
        check_measurements_file(file);
        saving.measured = find_measurement(state.overlay.measurement);
        if (!saving.measured) throw Error("error: no overlay is laid over the picture; choose one on the page Overlay");
        if (const Minus* const minus = subtracted(state.overlay)) saving.minus = *minus;
        saving.command = command_to_measure(state, measurements_extension(file));
        return saving;
    }
    check_picture_file(file);
    if (what == SaveWhat::beside) return of_beside(std::move(saving), state, results);
    saving.command = command_to_render(state, picture_extension(file));
    return saving;
}

void save(ViewerState& state, const Results& results) {
    SaveMenu& menu = state.save_menu;
    fs::path file(menu.typed);
    if (file.has_filename() && !file.has_extension()) file += menu.what == SaveWhat::numbers ? ".csv" : ".png";
    try {
        if (state.saving && results.saved.number != state.saving->number)
            throw Error(fmt::format("{}: error: it is still being written; save the next one when it is there",
                                    state.saving->file.string()));
        Saving wanted = saving(state, results, menu.what, file);
        std::error_code none;
        if (fs::exists(file, none) && menu.asked != file.string()) {
            menu.asked = file.string();
            return;
        }
        wanted.number = results.saved.number + 1;
        state.saving = std::move(wanted);
        menu.shown = false;
    } catch (const Error& error) {
        menu.error = error.what();
    }
}

namespace {

void write_difference(const Saving& saving, const Job& job) {
    const std::vector<MeasuredDifference> differences =
        measure_difference(*saving.scene, saving.setup, *saving.minus, std::span(&saving.measured, 1), job);
    const Measured measured{differences.front().what.get(), {&differences.front().channel, 1}};
    write_measurements(saving.file, {&measured, 1}, {saving.command}, job.stop);
}

}  // namespace

void write(const Saving& saving, const Job& job) {
    if (saving.drawn) return write_picture(saving.file, *saving.drawn, {saving.command}, job.stop);
    const Scene scene = applied(*saving.scene, saving.setup);
    const Options& options = saving.setup.options;
    if (!saving.measured) return write_picture(saving.file, render(scene, options, job), {saving.command}, job.stop);
    if (saving.minus) return write_difference(saving, job);
    const std::vector<Channel> channels = measure(scene, options, std::span(&saving.measured, 1), job).front();
    const Measured measured{saving.measured, channels};
    write_measurements(saving.file, {&measured, 1}, {saving.command}, job.stop);
}

void follow_saved(ViewerState& state, const Results& results) {
    if (!state.saving || results.saved.number != state.saving->number) return;
    const Saving& saved = *state.saving;
    state.notice = results.saved.error.empty() ? done("saved: " + saved.file.string()) : refused(results.saved.error);
    state.saving.reset();
}

void obey_in_save_menu(const KeyPress& press, ViewerState& state, const Results& results) {
    SaveMenu& menu = state.save_menu;
    if (press.key == Key::escape) menu.shown = false;
    if (press.key == Key::enter) save(state, results);
    if (press.key != Key::up && press.key != Key::down) return;
    const std::vector<SaveChoice> all = save_choices(state);
    auto chosen = std::find_if(all.begin(), all.end(), [&](const SaveChoice& one) { return one.what == menu.what; });
    if (press.key == Key::down && chosen != all.end() && std::next(chosen) != all.end())
        choose(state, std::next(chosen)->what);
    if (press.key == Key::up && chosen != all.begin()) choose(state, std::prev(chosen)->what);
}

}  // namespace glassbox
