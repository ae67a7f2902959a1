// How steps are written, from tapes made by hand: what each formula should be follows from the algebra in the comments.
#include "explain/symbols.hpp"

#include <doctest.h>

#include <string>
#include <vector>

using namespace glassbox;

namespace {

/// A tape in the making: each function adds a step, and returns its number.
class Steps {
public:
    StepNumber input(const std::string& name, double value = 1) { return add(Operation::input, 0, 0, name, value); }
    StepNumber constant(double value) { return add(Operation::constant, 0, 0, "", value); }
    StepNumber step(Operation operation, StepNumber a, StepNumber b = 0, const std::string& name = "") {
        return add(operation, a, b, name, 1);
    }
    StepNumber plus(StepNumber a, StepNumber b) { return step(Operation::add, a, b); }
    StepNumber minus(StepNumber a, StepNumber b) { return step(Operation::subtract, a, b); }
    StepNumber times(StepNumber a, StepNumber b) { return step(Operation::multiply, a, b); }

    Symbol at(StepNumber number) const { return symbols(steps_)[static_cast<std::size_t>(number)]; }
    std::string written(StepNumber number) const { return at(number).written; }

private:
    StepNumber add(Operation operation, StepNumber a, StepNumber b, const std::string& name, double value) {
        story::StoryStep told;
        told.step.operation = operation;
        told.step.left = a;
        told.step.right = b;
        told.name = name;
        told.checked.value = value;
        steps_.push_back(told);
        return static_cast<StepNumber>(steps_.size() - 1);
    }

    std::vector<story::StoryStep> steps_;
};

/// The components of a vector.
struct Components {
    StepNumber x, y, z;
};

Components vector(Steps& steps, const std::string& name) {
    return {steps.input(name + ".x"), steps.input(name + ".y"), steps.input(name + ".z")};
}

}  // namespace

TEST_CASE("a single operation is written with its operands' names, and as mathematics writes it further on") {
    Steps steps;
    const StepNumber a = steps.input("a"), b = steps.input("b");
    const auto check = [&](Operation operation, const std::string& formula, const std::string& written) {
        const Symbol symbol = steps.at(steps.step(operation, a, b));
        CHECK(symbol.result == "");
        CHECK(symbol.formula == formula);
        CHECK(symbol.written == written);
    };
    check(Operation::add, "a + b", "a + b");
    check(Operation::subtract, "a − b", "a − b");
    check(Operation::multiply, "a × b", "a b");
    check(Operation::divide, "a ÷ b", "a / b");
    check(Operation::negate, "−a", "−a");
    check(Operation::square_root, "√a", "√a");
    check(Operation::absolute, "|a|", "|a|");
    check(Operation::power, "a to the power b", "a^b");
    check(Operation::round, "a rounded to the scalar", "a");  // rounded or not, it is the same number
    check(Operation::greater_equal, "a ≥ b", "a ≥ b");
    CHECK(steps.at(a).written == "a");
    CHECK(steps.at(a).formula == "");  // it is not computed
}

TEST_CASE("parentheses stand where a formula would mean something else without them, and only there") {
    Steps steps;
    const StepNumber a = steps.input("a"), b = steps.input("b"), c = steps.input("c");
    const StepNumber sum = steps.plus(a, b), difference = steps.minus(a, b), product = steps.times(a, b);
    const StepNumber quotient = steps.step(Operation::divide, a, b), negation = steps.step(Operation::negate, a);
    CHECK(steps.written(steps.plus(sum, c)) == "a + b + c");
    CHECK(steps.written(steps.plus(c, sum)) == "c + (a + b)");  // in floating point not the same
    CHECK(steps.written(steps.minus(c, difference)) == "c − (a − b)");
    CHECK(steps.written(steps.minus(negation, c)) == "−a − c");
    CHECK(steps.written(steps.minus(c, negation)) == "c − (−a)");
    CHECK(steps.written(steps.times(sum, c)) == "(a + b) c");
    CHECK(steps.written(steps.times(product, c)) == "a b c");
    CHECK(steps.written(steps.times(quotient, c)) == "(a / b) c");
    CHECK(steps.written(steps.plus(product, quotient)) == "a b + a / b");
    CHECK(steps.written(steps.step(Operation::divide, quotient, c)) == "a / b / c");
    CHECK(steps.written(steps.step(Operation::divide, c, quotient)) == "c / (a / b)");
    CHECK(steps.written(steps.step(Operation::divide, c, product)) == "c / (a b)");
    CHECK(steps.written(steps.step(Operation::square_root, sum)) == "√(a + b)");
    CHECK(steps.at(steps.step(Operation::absolute, sum)).formula == "|a + b|");  // the bars hold it together
    CHECK(steps.at(steps.times(sum, c)).formula == "(a + b) × c");

    // Numbers: those below 0 begin with a sign.
    CHECK(steps.written(steps.times(steps.constant(-2), c)) == "(−2) c");
    CHECK(steps.written(steps.times(steps.constant(2), c)) == "2 c");

    // Names are read, too: "n·l" is a product, "a+b+c" a sum, "(A − P)" needs no more parentheses.
    CHECK(steps.written(steps.times(steps.input("a+b+c"), c)) == "(a+b+c) c");
    CHECK(steps.written(steps.times(steps.input("n·l"), c)) == "(n·l) c");
    CHECK(steps.written(steps.times(steps.input("(A − P)"), c)) == "(A − P) c");
}

TEST_CASE("what is multiplied by itself is squared") {
    Steps steps;
    const StepNumber a = steps.input("a"), b = steps.input("b"), sum = steps.plus(a, b);
    CHECK(steps.written(steps.times(a, a)) == "a²");
    CHECK(steps.written(steps.times(sum, steps.plus(a, b))) == "(a + b)²");
    CHECK(steps.at(steps.times(a, a)).formula == "a × a");
}

TEST_CASE("three products of components of the same axes are a dot product") {
    Steps steps;
    const Components v = vector(steps, "v"), w = vector(steps, "w");
    const StepNumber x = steps.times(v.x, w.x), y = steps.times(v.y, w.y), z = steps.times(v.z, w.z);
    const StepNumber xy = steps.plus(x, y), xyz = steps.plus(xy, z);
    CHECK(steps.written(x) == "v.x w.x");
    CHECK(steps.at(x).result == "");
    CHECK(steps.written(xy) == "v.x w.x + v.y w.y");
    CHECK(steps.at(xy).result == "");
    CHECK(steps.written(xyz) == "v·w");
    CHECK(steps.at(xyz).result == "v·w");  // here it ends
    CHECK(steps.at(xyz).formula == "v.x w.x + v.y w.y + v.z w.z");
    CHECK(steps.written(steps.plus(x, steps.plus(y, z))) == "v·w");
    // It holds tighter than a sum, and looser than a product.
    const StepNumber a = steps.input("a");
    CHECK(steps.written(steps.minus(a, xyz)) == "a − v·w");
    CHECK(steps.written(steps.times(a, xyz)) == "a (v·w)");

    // Not in another order, not without a product, not of other vectors.
    CHECK(steps.written(steps.plus(steps.plus(y, x), z)) == "v.y w.y + v.x w.x + v.z w.z");
    CHECK(steps.written(steps.plus(xy, a)) == "v.x w.x + v.y w.y + a");
    CHECK(steps.written(steps.plus(xy, steps.times(w.z, v.z))) == "v.x w.x + v.y w.y + w.z v.z");
    CHECK(steps.written(steps.minus(xy, z)) == "v.x w.x + v.y w.y − v.z w.z");
}

TEST_CASE("a vector's dot product with itself is its square, and the root of that its length") {
    Steps steps;
    const Components v = vector(steps, "v"), p = vector(steps, "(A − P)");
    const auto square = [&](const Components& of) {
        return steps.plus(steps.plus(steps.times(of.x, of.x), steps.times(of.y, of.y)), steps.times(of.z, of.z));
    };
    CHECK(steps.written(steps.times(v.x, v.x)) == "v.x v.x");  // a part of v·v, not a square
    const StepNumber v2 = square(v), p2 = square(p);
    CHECK(steps.written(v2) == "v²");
    CHECK(steps.written(steps.step(Operation::square_root, v2)) == "|v|");
    CHECK(steps.at(steps.step(Operation::square_root, v2)).formula == "√v²");
    CHECK(steps.written(p2) == "(A − P)²");
    CHECK(steps.written(steps.step(Operation::square_root, p2)) == "|A − P|");  // the bars do for the parentheses
    CHECK(steps.written(steps.step(Operation::square_root, v.x)) == "√v.x");
}

TEST_CASE("two products across are a component of a cross product") {
    // (v × w).x = v.y w.z − v.z w.y, and the others by going round x, y, z
    Steps steps;
    const Components v = vector(steps, "v"), w = vector(steps, "w");
    const StepNumber yz = steps.times(v.y, w.z), zy = steps.times(v.z, w.y);
    const StepNumber x = steps.minus(yz, zy);
    CHECK(steps.at(yz).result == "");
    CHECK(steps.at(x).result == "(v × w).x");
    CHECK(steps.at(x).formula == "v.y w.z − v.z w.y");
    const StepNumber y = steps.minus(steps.times(v.z, w.x), steps.times(v.x, w.z));
    const StepNumber z = steps.minus(steps.times(v.x, w.y), steps.times(v.y, w.x));
    CHECK(steps.written(y) == "(v × w).y");
    CHECK(steps.written(z) == "(v × w).z");
    CHECK(steps.written(steps.minus(yz, steps.times(v.x, w.y))) == "v.y w.z − v.x w.y");
    CHECK(steps.written(steps.plus(yz, zy)) == "v.y w.z + v.z w.y");

    // The triple product, as a side product is computed.
    const Components d = vector(steps, "D");
    const StepNumber dot = steps.plus(steps.plus(steps.times(d.x, x), steps.times(d.y, y)), steps.times(d.z, z));
    CHECK(steps.written(dot) == "D·(v × w)");
}

TEST_CASE("what is done to all components alike is done to the vector") {
    Steps steps;
    const Components a = vector(steps, "A"), p = vector(steps, "P");
    const StepNumber t = steps.input("t"), difference = steps.minus(a.x, p.x);
    CHECK(steps.written(difference) == "(A − P).x");
    CHECK(steps.at(difference).formula == "A.x − P.x");
    CHECK(steps.written(steps.plus(a.y, p.y)) == "(A + P).y");
    CHECK(steps.written(steps.times(t, a.z)) == "(t A).z");
    CHECK(steps.written(steps.times(a.z, t)) == "(A t).z");
    CHECK(steps.written(steps.step(Operation::divide, a.x, t)) == "(A / t).x");
    CHECK(steps.written(steps.step(Operation::divide, t, a.x)) == "t / A.x");  // no vector
    CHECK(steps.written(steps.step(Operation::negate, a.x)) == "(−A).x");
    CHECK(steps.written(steps.times(t, difference)) == "(t (A − P)).x");
    CHECK(steps.written(steps.plus(a.x, p.y)) == "A.x + P.y");
}

TEST_CASE("a step with a name is told with it, and written by it from then on") {
    Steps steps;
    const StepNumber a = steps.input("a"), b = steps.input("b");
    const StepNumber named = steps.step(Operation::multiply, a, b, "c");
    CHECK(steps.at(named).result == "c = a × b");
    CHECK(steps.written(named) == "c");
    CHECK(steps.written(steps.plus(named, a)) == "c + a");

    // What ends a vector operation is told as that; unless the name says so much already.
    const Components n = vector(steps, "n"), l = vector(steps, "l");
    const StepNumber xy = steps.plus(steps.times(n.x, l.x), steps.times(n.y, l.y)), z = steps.times(n.z, l.z);
    CHECK(steps.at(steps.step(Operation::add, xy, z, "cos")).result == "cos = n·l");
    CHECK(steps.at(steps.step(Operation::add, xy, z, "n·l")).result == "n·l = n.x l.x + n.y l.y + n.z l.z");
}

TEST_CASE("what would be too long is written as its value") {
    Steps steps;
    const StepNumber a = steps.input(std::string(45, 'a')), b = steps.input(std::string(44, 'b'));
    const StepNumber c = steps.input(std::string(45, 'c'));
    const StepNumber fits = steps.times(a, b), too_long = steps.times(a, c);  // 45 + 1 + 44 = 90 bytes, and 91
    CHECK(steps.written(fits).size() == 90);
    CHECK(steps.written(too_long) == "1");
    CHECK(steps.at(too_long).formula == std::string(45, 'a') + " × " + std::string(45, 'c'));
    // What goes on from there shows the value, and what goes on from that, until it has a name.
    const StepNumber next = steps.plus(too_long, a), named = steps.step(Operation::add, next, b, "n");
    CHECK_FALSE(steps.at(too_long).has_values);
    CHECK(steps.at(next).has_values);
    CHECK(steps.at(named).has_values);
    CHECK_FALSE(steps.at(steps.plus(named, a)).has_values);
}
