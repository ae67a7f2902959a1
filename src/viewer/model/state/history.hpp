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

    /// A new version, unless it is the present one. What had been undone is forgotten.
    void change(Value next) {
        end_drag();
        push(std::move(next));
    }

    /// Changes the present version and keeps no trace of what it was.
    void amend(Value next) {
        versions_.resize(at_ + 1);
        versions_[at_] = std::move(next);
    }

    /// A step of a drag: all steps until end_drag() are one change.
    void drag(Value next) {
        if (dragging_) return amend(std::move(next));
        const std::size_t before = at_;
        push(std::move(next));
        dragging_ = at_ != before;
    }

    /// The drag is over; one that came back to where it began was no change.
    void end_drag() {
        if (std::exchange(dragging_, false) && versions_[at_] == versions_[at_ - 1]) {
            versions_.pop_back();
            --at_;
        }
    }

    /// The version that the present drag began with; without one, the present version.
    const Value& before_drag() const { return versions_[dragging_ ? at_ - 1 : at_]; }

    /// Replaces every version by `follow(version)`; which is the present one, and undo and redo, stay.
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
