#include "explain/reading_order.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>

namespace glassbox {

namespace {

/// Reads a tape call by call, line by line.
class TapeReader {
public:
    TapeReader(std::span<const story::StoryStep> steps, std::span<const Call> calls) : steps_(steps), calls_(calls) {}

    std::vector<StepNumber> read() && {
        std::vector<StepNumber> all;
        for (std::size_t i = 0; i < steps_.size(); ++i)
            if (operands(steps_[i].step.operation) > 0) all.push_back(static_cast<StepNumber>(i));
        read_call(all, 0);
        return std::move(order_);
    }

private:
    using Steps = std::span<const StepNumber>;

    /// An operation of the call that is read, or all of a call made by it.
    struct Item {
        Steps steps;
        CallNumber call;
        std::string_view file;
        int line;
        bool used = false, read = false;  ///< by another item of the line; already
    };

    /// The call made by `caller` in which a step is done; `caller` itself if it does the step.
    CallNumber made_by(CallNumber caller, StepNumber step) const {
        CallNumber call = steps_[step].step.call;
        while (call != caller && calls_[call].caller != caller) call = calls_[call].caller;
        return call;
    }

    /// Reads what a call does, line by line.
    void read_call(Steps steps, CallNumber caller) {
        std::vector<Item> line;
        while (!steps.empty()) {
            const CallNumber call = made_by(caller, steps[0]);
            std::size_t size = 1;
            if (call != caller)
                while (size < steps.size() && made_by(caller, steps[size]) == call) ++size;
            const Step& first = steps_[steps[0]].step;
            Item item = call == caller ? Item{steps.first(size), call, first.file, first.line}
                                       : Item{steps.first(size), call, calls_[call].file, calls_[call].line};
            if (!line.empty() && (line[0].line != item.line || line[0].file != item.file)) read_line(line, caller);
            line.push_back(item);
            steps = steps.subspan(size);
        }
        read_line(line, caller);
    }

    void read_line(std::vector<Item>& line, CallNumber caller) {
        std::vector<Item*> results;
        for (const Item& item : line) for_each_operand(line, item, [&](Item& other) { other.used |= &other != &item; });
        for (Item& item : line)
            if (!item.used) results.push_back(&item);
        const auto step = [&](const Item* item) -> const Step& { return steps_[item->steps[0]].step; };
        if (std::ranges::all_of(results, [&](const Item* item) { return is_comparison(step(item).operation); }))
            std::ranges::stable_sort(results, {}, [&](const Item* item) { return step(item).left; });
        for (Item* const result : results) read_item(line, *result, caller);
        line.clear();
    }

    void read_item(std::vector<Item>& line, Item& item, CallNumber caller) {
        if (std::exchange(item.read, true)) return;
        for_each_operand(line, item, [&](Item& other) { read_item(line, other, caller); });
        if (item.call == caller) order_.push_back(item.steps[0]);
        else read_call(item.steps, item.call);
    }

    /// Calls `use` with the items of a line that one of them takes operands from, itself perhaps among them.
    template <class Use>
    void for_each_operand(std::vector<Item>& line, const Item& item, const Use& use) const {
        const auto use_maker = [&](StepNumber made) {
            const auto after = std::ranges::upper_bound(line, made, {}, [](const Item& one) { return one.steps[0]; });
            if (after != line.begin() && made <= std::prev(after)->steps.back()) use(*std::prev(after));
        };
        for (const StepNumber number : item.steps) {
            const Step& step = steps_[number].step;
            use_maker(step.left);
            if (operands(step.operation) > 1) use_maker(step.right);
        }
    }

    std::span<const story::StoryStep> steps_;
    std::span<const Call> calls_;
    std::vector<StepNumber> order_;
};

}  // namespace

std::vector<StepNumber> in_reading_order(std::span<const story::StoryStep> steps, std::span<const Call> calls) {
    return TapeReader(steps, calls).read();
}

}  // namespace glassbox
