#include "learn/picture/recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <new>
#include <utility>

#include "learn/picture/reel.hpp"
#include "learn/picture/to_sheet.hpp"
#include "learn/subprocess/shared_memory.hpp"
#include "learn/subprocess/subprocess.hpp"
#include "scene/printable.hpp"

namespace glassbox::learn::mine {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr auto longest_test = 3s;  // no surface's test takes that long

/// A text that ends where its memory ends, if not before.
template <std::size_t size>
std::string text_of(const char (&from)[size]) {
    return printable(std::string(from, std::find(from, from + size, '\0')));
}

/// "my/2-spheres/chord.hpp": short, since it is written beside each line; and the same wherever the learner's folder
/// is.
std::string name_of(const OwnHeader& header) {
    const fs::path folder = header.path.parent_path();
    return (folder.parent_path().filename() / folder.filename() / header.path.filename()).string();
}

/// Reads a reel. The program may have written anything at all: nothing is taken for a place without being checked.
class Reader {
public:
    Reader(const Reel& reel, const fs::path& root, std::span<const OwnHeader> headers)
        : reel_(reel), sources_(std::make_shared<OwnSources>()) {
        for (const OwnHeader& header : headers) sources_->add(name_of(header), header.text);
        const std::uint32_t count = std::min(reel.texts.load(), most_texts - 1);
        texts_.push_back("");
        for (std::uint32_t i = 1; i <= count; ++i)
            texts_.push_back(sources_->keep(as_named(text_of(reel.text[i].text), root, headers)));
    }

    RecordedPixel pixel() const {
        RecordedPixel pixel;
        pixel.sources = sources_;
        const auto vector = [](const double(&from)[3]) { return Vec3<double>{from[0], from[1], from[2]}; };
        pixel.ray = {vector(reel_.ray[0]), vector(reel_.ray[1])};
        pixel.met = static_cast<std::size_t>(std::max<std::int64_t>(reel_.met, 0));
        const ReelStage at = reel_.at;
        if (at == ReelStage::done) pixel.color = Rgb{reel_.color[0], reel_.color[1], reel_.color[2]};
        const std::uint32_t tapes = std::min(reel_.tapes.load(), most_tapes);
        for (std::uint32_t i = 0; i < tapes; ++i) pixel.tests.push_back(surface(reel_.tape[i]));
        return pixel;
    }

private:
    /// The compiler names a header from the folder where it ran.
    static std::string as_named(std::string file, const fs::path& root, std::span<const OwnHeader> headers) {
        const fs::path path = (root / file).lexically_normal();
        for (const OwnHeader& header : headers)
            if (header.path.lexically_normal() == path) return name_of(header);
        return file;
    }

    const char* text(std::uint8_t number) const { return number < texts_.size() ? texts_[number] : ""; }

    Tape tape(const ReelTape& from) const {
        std::vector<Call> calls{Call{}};
        const std::uint32_t call_count = std::min(from.calls.load(), most_calls - 1);
        for (std::uint32_t i = 1; i <= call_count; ++i) {
            const ReelCall call = from.call[i];
            calls.push_back({text(call.header), text(call.function), text(call.file), call.line,
                             call.caller < i ? call.caller : 0});
        }
        std::vector<Step> steps;
        const std::uint32_t step_count = std::min(from.steps.load(), most_steps);
        for (std::uint32_t i = 0; i < step_count; ++i) {
            const ReelStep step = from.step[i];
            auto operation = static_cast<Operation>(
                std::min<std::uint8_t>(step.operation, static_cast<std::uint8_t>(Operation::not_equal)));
            if (operands(operation) > 0 && (step.left >= i || step.right >= i)) operation = Operation::input;
            const bool starts = operands(operation) == 0;
            steps.push_back({operation, starts ? 0 : step.left, starts ? 0 : step.right, step.value, text(step.file),
                             step.line, step.call < calls.size() ? step.call : 0});
        }
        std::vector<StepName> names;
        const std::uint32_t name_count = std::min(from.names.load(), most_names);
        for (std::uint32_t i = 0; i < name_count; ++i)
            if (from.name[i].step < step_count) names.emplace_back(from.name[i].step, text_of(from.name[i].text));
        return {Precision::of<double>(), std::move(steps), std::move(calls), std::move(names)};
    }

    RecordedSurface surface(const ReelTape& from) const {
        RecordedSurface surface;
        surface.number = static_cast<std::size_t>(std::max<std::int64_t>(from.surface, 0));
        surface.tape = tape(from);
        const std::size_t count = surface.tape.steps().size();
        surface.test_steps = std::min<std::size_t>(from.test_steps, count);
        surface.is_finished = from.finished != 0;
        surface.open_call = from.open_call < surface.tape.calls().size() ? from.open_call : 0;
        surface.met = from.met != 0;
        surface.t = from.t;
        if (from.t_step >= 0 && static_cast<std::size_t>(from.t_step) < count)
            surface.t_step = static_cast<StepNumber>(from.t_step);
        return surface;
    }

    const Reel& reel_;
    std::shared_ptr<OwnSources> sources_;
    std::vector<const char*> texts_;
};

std::string where(ReelStage at) {
    switch (at) {
        case ReelStage::view:
            return "while it made the view, ";
        case ReelStage::choice:
            return "while it chose the nearest, ";
        default:
            return "";
    }
}

/// How it ended early; "" if it did not.
std::string end_of(const Outcome& outcome, const Reel& reel) {
    if (reel.endless != 0)
        return where(reel.at) + fmt::format(
                                    "it did not come to an end in {} steps: an endless loop, or a function that "
                                    "calls itself without end?",
                                    most_steps);
    if (reel.not_written != 0) return printable(outcome.last_words.text);
    if (outcome.well() && reel.at == ReelStage::done) return "";
    const std::string how = how_it_ended(outcome);
    return where(reel.at) + (how.empty() ? "it ended before its work was done" : how);
}

}  // namespace

RecordingUpdate record(const fs::path& stepper, const ToRecord& what, const fs::path& root,
                       std::span<const OwnHeader> headers, const std::stop_token& stop) {
    const auto& [scene, options, at, listed] = what;
    const std::size_t sheet_size =
        aligned(sheet_bytes(options.turns.size(), scene.spheres.size(), triangles_of(scene), 0));
    const SharedMemory memory(sheet_size + sizeof(Reel));
    auto& sheet = *new (memory.data()) Sheet{};
    write(scene, options, sheet);
    // Not Reel{}: it would touch all of its pages. New memory is 0.
    auto& reel = *reinterpret_cast<Reel*>(static_cast<std::byte*>(memory.data()) + sheet_size);
    reel.x = at.x;
    reel.y = at.y;
    reel.listed_count = static_cast<std::uint32_t>(std::min<std::size_t>(listed.size(), most_listed));
    for (std::uint32_t i = 0; i < reel.listed_count; ++i) reel.listed[i] = static_cast<std::int64_t>(listed[i]);

    Command command{stepper, {std::to_string(sheet_size)}};
    command.shared = &memory;
    command.limits.time = longest_test;
    command.limits.memory = (std::uint64_t{1} << 30) + 2 * memory.size();
    command.limits.output = 4096;
    std::int64_t before = -1;
    command.has_got_on = [&] {
        const std::int64_t now = reel.tested.load(std::memory_order_acquire);
        return std::exchange(before, now) != now;
    };
    const Outcome outcome = run(command, stop);

    RecordingUpdate update;
    update.words = end_of(outcome, reel);
    update.stand = update.words.empty() ? Stand::drawn : reel.not_written != 0 ? Stand::not_written : Stand::failed;
    update.said = outcome.output + outcome.errors;
    if (reel.at < ReelStage::ray_color || reel.at > ReelStage::done) return update;
    RecordedPixel pixel = Reader(reel, root, headers).pixel();
    pixel.ended = update.words;
    const bool is_hit = reel.has_hit != 0 && !pixel.tests.empty();
    if (is_hit || (options.stage == 1 && !pixel.tests.empty())) {
        RecordedSurface last = std::move(pixel.tests.back());
        pixel.tests.pop_back();
        if (is_hit) pixel.hit = std::move(last);
        else pixel.ray_color = std::move(last.tape);
    }
    update.pixel = std::make_shared<const RecordedPixel>(std::move(pixel));
    return update;
}

}  // namespace glassbox::learn::mine
