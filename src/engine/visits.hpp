#pragma once
#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "engine/hierarchy.hpp"

namespace glassbox::engine {

/// A child to look into, and where it begins: no ray that is under way meets it earlier.
struct Visit {
    std::uint32_t child;
    float entry;
};

/// What is still to be visited on a way through a hierarchy; of what was pushed last the nearest lies on top.
template <class AVisit>
class VisitStack {
public:
    explicit VisitStack(const AVisit& first) { visits_[depth_++] = first; }

    bool is_empty() const { return depth_ == 0; }
    const AVisit& top() const { return visits_[depth_ - 1]; }
    AVisit pop() { return visits_[--depth_]; }
    void put(const AVisit& one) { visits_[depth_++] = one; }

    /// Of a node's children those whose bits are set, `visit_of(i)` for the i-th.
    template <class VisitOf>
    void push(std::uint32_t children, const VisitOf& visit_of) {
        const std::size_t first = depth_;
        for (; children != 0; children &= children - 1)
            insert(visit_of(static_cast<std::uint32_t>(__builtin_ctz(children))), first);
    }

    /// How many there are, and puts one among those from `first` on where it belongs.
    std::size_t depth() const { return depth_; }
    void insert(const AVisit& one, std::size_t first) {
        std::size_t place = depth_++;
        for (; place > first && visits_[place - 1].entry < one.entry; --place) visits_[place] = visits_[place - 1];
        visits_[place] = one;
    }

private:
    AVisit visits_[(fan_out - 1) * most_levels + fan_out];
    std::size_t depth_ = 0;
};

/// The same for a ray by itself.
class Visits {
public:
    explicit Visits(const Visit& first) : stack_(first) {}

    bool is_empty() const { return stack_.is_empty(); }
    const Visit& top() const { return stack_.top(); }
    Visit pop() { return stack_.pop(); }

    /// The children whose bits are set.
    void push(const Node& node, std::uint32_t children, const float (&entries)[fan_out]) {
        stack_.push(children, [&](std::uint32_t i) { return Visit{node.child[i], entries[i]}; });
    }

    /// The same for two or more with entries ≥ 0, of which the nearest is not pushed but returned. Up to four are
    /// sorted without a branch: which of them is the nearest nobody can foresee.
    std::uint32_t push_all_but_nearest(const Node& node, std::uint32_t children, const float (&entries)[fan_out]) {
        Ordered a = take(node, children, entries), b = take(node, children, entries);
        sort(a, b);
        if (children == 0) {
            put(b);
            return visit_of(a).child;
        }
        Ordered c = take(node, children, entries);
        sort(b, c);
        sort(a, b);
        if (children == 0) {
            put(c);
            put(b);
            return visit_of(a).child;
        }
        Ordered d = take(node, children, entries);
        sort(c, d);
        sort(b, c);
        sort(a, b);
        const std::size_t first = stack_.depth();
        for (const Ordered one : {d, c, b, a}) put(one);
        while (children != 0) stack_.insert(visit_of(take(node, children, entries)), first);
        return pop().child;
    }

    /// The same for one or more in whatever order, entries not told.
    std::uint32_t push_all_but_one(const Node& node, std::uint32_t children) {
        const auto one = static_cast<std::uint32_t>(__builtin_ctz(children));
        for (children &= children - 1; children != 0; children &= children - 1)
            stack_.put({node.child[__builtin_ctz(children)], 0});
        return node.child[one];
    }

private:
    /// A visit as a whole number that is larger the later the child is entered: floats ≥ 0 are ordered as their bits.
    using Ordered = std::uint64_t;

    static Visit visit_of(Ordered one) {
        return {static_cast<std::uint32_t>(one), std::bit_cast<float>(static_cast<std::uint32_t>(one >> 32))};
    }

    /// The next child whose bit is set; clears it.
    static Ordered take(const Node& node, std::uint32_t& children, const float (&entries)[fan_out]) {
        const auto i = static_cast<std::uint32_t>(__builtin_ctz(children));
        children &= children - 1;
        return Ordered{std::bit_cast<std::uint32_t>(entries[i])} << 32 | node.child[i];
    }

    static void sort(Ordered& nearer, Ordered& farther) {
        const Ordered least = std::min(nearer, farther);
        farther = std::max(nearer, farther);
        nearer = least;
    }

    void put(Ordered one) { stack_.put(visit_of(one)); }

    VisitStack<Visit> stack_;
};

}  // namespace glassbox::engine
