#pragma once
#include <cstddef>
#include <utility>
#include <vector>

namespace glassbox {

/// A value and all its earlier versions: undo and redo.
template <class Value>
class History {
public:
    History() : versions_(1) {}
    explicit History(Value first) : versions_{std::move(first)} {}

    const Value& now() const { return versions_[at_]; }

    /// Adds a new version, unless it equals the present one. Drops what was undone.
    void change(Value next) {
        end_drag();
        push(std::move(next));
    }

    /// Changes the present version without keeping the old one.
    void amend(Value next) {
        versions_.resize(at_ + 1);
        versions_[at_] = std::move(next);
    }

    /// Applies a step of a drag: all steps until end_drag() are one change.
    void drag(Value next) {
        if (dragging_) return amend(std::move(next));
        const std::size_t before = at_;
        push(std::move(next));
        dragging_ = at_ != before;
    }

    /// Ends the drag; one that returned to its start is no change.
    void end_drag() {
        if (std::exchange(dragging_, false) && versions_[at_] == versions_[at_ - 1]) {
            versions_.pop_back();
            --at_;
        }
    }

    /// Returns the version before the present drag; without a drag, the present version.
    const Value& before_drag() const { return versions_[dragging_ ? at_ - 1 : at_]; }

    /// Replaces every version by `follow(version)`; the present position, undo and redo stay.
    template <class Follow>
    void replace_all(const Follow& follow) {
        for (Value& version : versions_) version = follow(version);
    }

    bool can_undo() const { return at_ > 0; }
    bool can_redo() const { return at_ + 1 < versions_.size(); }
    void undo() {
        end_drag();
        at_ -= can_undo() ? 1 : 0;
    }
    void redo() {
        end_drag();
        at_ += can_redo() ? 1 : 0;
    }

private:
    void push(Value next) {
        if (next == now()) return;
        versions_.resize(at_ + 1);
        versions_.push_back(std::move(next));
        at_ = versions_.size() - 1;
    }

    std::vector<Value> versions_;
    std::size_t at_ = 0;
    bool dragging_ = false;
};

}  // namespace glassbox
