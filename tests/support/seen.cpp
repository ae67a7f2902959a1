#include <support/seen.hpp>

namespace glassbox::test {
namespace {

const Seen* last = nullptr;

}  // namespace

void NamedNumbers::enter(const char* name) { entered_.push_back(name); }
void NamedNumbers::leave() { entered_.pop_back(); }
void NamedNumbers::add(double number) { all_.push_back({name(), {number}, 1}); }
void NamedNumbers::add(double x, double y, double z) { all_.push_back({name(), {x, y, z}, 3}); }

std::string NamedNumbers::name() const {
    std::string name;
    for (const char* part : entered_) name += (name.empty() ? "" : ".") + std::string(part);
    return name;
}

Seen::Seen(int line, std::initializer_list<SeenVariable> variables) : line_(line), before_(last) {
    for (const SeenVariable& one : variables)
        if (count_ < variables_.size()) variables_[count_++] = one;
    last = this;
}

Seen::~Seen() { last = before_; }

const Seen* Seen::now() { return last; }

std::vector<Named> Seen::named() const {
    NamedNumbers numbers;
    for (std::size_t i = 0; i < count_; ++i) {
        numbers.enter(variables_[i].name);
        variables_[i].add(numbers, variables_[i].at);
        numbers.leave();
    }
    return std::move(numbers).all();
}

}  // namespace glassbox::test
