#include "learn/build/plain_words.hpp"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace glassbox::learn {
namespace {

/// Returns what a pattern's % match in a text; none if the pattern does not match. A % matches as little as possible,
/// the last one all the rest.
std::optional<std::vector<std::string>> matched(std::string_view text, std::string_view pattern) {
    std::vector<std::string> taken;
    std::size_t percent = pattern.find('%');
    if (!text.starts_with(pattern.substr(0, percent))) return {};
    text.remove_prefix(pattern.substr(0, percent).size());
    while (percent != std::string_view::npos) {
        pattern.remove_prefix(percent + 1);
        percent = pattern.find('%');
        const std::string_view next = pattern.substr(0, percent);
        const std::size_t end = next.empty() ? text.size() : text.find(next);
        if (end == std::string_view::npos) return {};
        taken.emplace_back(text.substr(0, end));
        text.remove_prefix(end + next.size());
    }
    return taken;
}

void replace_all(std::string& text, std::string_view old, std::string_view by) {
    for (std::size_t at = text.find(old); at != std::string::npos; at = text.find(old, at + by.size()))
        text.replace(at, old.size(), by);
}

/// Simplifies a type for a learner: "const glassbox::Vec3<double>&" becomes "Vec3<double>".
std::string simple(std::string type) {
    for (const std::string_view noise :
         {"glassbox::", "engine::", "std::__cxx11::", "const ", "struct ", " const", "&"})
        replace_all(type, noise, "");
    return type;
}

/// g++ prints a type and then what it is an alias of: 'std::type_identity_t<double>' {aka 'double'}.
std::string without_aliases(std::string_view message) {
    std::string text(message);
    for (std::size_t aka = text.find("' {aka '"); aka != std::string::npos; aka = text.find("' {aka '")) {
        const std::size_t open = aka == 0 ? std::string::npos : text.rfind('\'', aka - 1);
        const std::size_t close = text.find("'}", aka);
        if (open == std::string::npos || close == std::string::npos) break;
        const std::string real = text.substr(aka + 8, close - aka - 8);
        text.replace(open + 1, close + 2 - open - 1, real + '\'');
    }
    return text;
}

/// Unlike g++, clang++ does not name the missing operator: turns clang++'s message into g++'s form.
std::string with_operator(std::string message, const std::string& sign) {
    constexpr std::string_view nameless = "invalid operands to binary expression (";
    if (sign.empty() || !message.starts_with(nameless)) return message;
    return fmt::format("no match for 'operator{}' (operand types are {}", sign, message.substr(nameless.size()));
}

struct Meaning {
    std::string_view pattern;  ///< of a message, % standing for anything
    std::string_view plain;    ///< {1}, {2} … are what the % stood for, {left} and {right} the operation's
};

constexpr std::string_view no_bool =
    "What a comparison answers may be undecided, and is no bool: keep it as Truth<Real>, and ask possibly(…) or "
    "surely(…) "
    "of it.";
constexpr std::string_view between_truths =
    "There is no {1} between what two comparisons answer. There is a & b for and, !a for not, and a != b; a or b is "
    "!(!a & !b), and a equal to b is !(a != b).";

// The first match is used. Patterns of g++ and clang++ for the same mistake stand together.
constexpr std::array meanings{
    Meaning{"%xpected ';'%", "A semicolon is missing here, at the end of this statement."},
    Meaning{"expected ',' or ';'%", "A semicolon is missing, here or at the end of the line before."},
    Meaning{"expected initializer before%", "Something is missing before this word: a = with a value, or a semicolon."},
    Meaning{"%'%' was not declared in this scope; did you mean '%'?%", "Nothing is called {2} here; did you mean {3}?"},
    Meaning{"use of undeclared identifier '%'; did you mean '%'?%", "Nothing is called {1} here; did you mean {2}?"},
    Meaning{"unknown type name '%'; did you mean '%'?%", "No type is called {1} here; did you mean {2}?"},
    Meaning{"'%' is not a member of '%'; did you mean '%'?%", "There is no {1} in {2}; did you mean {3}?"},
    Meaning{"no member named '%' in %; did you mean '%'?%", "There is no {1} in {2}; did you mean {3}?"},
    Meaning{"'%' was not declared in this scope%",
            "Nothing is called {1} here: is it spelt right, and is it declared further up, or in a header that is "
            "included?"},
    Meaning{"there are no arguments to '%' that depend on a template parameter%",
            "No function is called {1} here: is it spelt right?"},
    Meaning{"use of undeclared identifier '%'%",
            "Nothing is called {1} here: is it spelt right, and is it declared further up, or in a header that is "
            "included?"},
    Meaning{"unknown type name 'Real'%",
            "Real is the template's parameter: write 'template <class Real>' in the line above the function."},
    Meaning{"'Real' does not name a type%",
            "Real is the template's parameter: write 'template <class Real>' in the line above the function."},
    Meaning{"no template named '%'%",
            "Nothing is called {1} here: is it spelt right, is its header included, and does 'namespace glassbox' end "
            "too early, by one } too many?"},
    Meaning{"unknown type name '%'%", "No type is called {1} here: is it spelt right?"},
    Meaning{
        "'Vec3' does not name a type%",
        "Vec3 is not known here: is vec3.hpp included, is it empty, and does 'namespace glassbox' end too early, by "
        "one } too many?"},
    Meaning{
        "'%' does not name a type%",
        "No type is called {1} here: is it spelt right? Or is one } too many further up, so that a function ends too "
        "early?"},
    Meaning{"%'operator^'%", "^ is no power in C++: a square is {left} * {left}, any other power pow({left}, e)."},
    Meaning{"no match for 'operator^' (operand%",
            "^ is no power in C++: a square is {left} * {left}, any other power pow({left}, e)."},
    Meaning{"no match for 'operator%' (operand types are '%Truth' and%", between_truths},
    Meaning{"no match for 'operator%' (operand types are '%Kleene' and%", between_truths},
    Meaning{"no match for 'operator[]' (operand types are '%Vec3<%",
            "A vector's components are called, and not counted: write .x, .y or .z, as in a.x."},
    Meaning{"type '%Vec3<%>' does not provide a subscript operator%",
            "A vector's components are called, and not counted: write .x, .y or .z, as in a.x."},
    Meaning{"no match for 'operator==' (operand types are '%Vec3<%>' and '%')%",
            "A vector is compared with a vector; whether it is zero: {left} == Vec3<Real>{}."},
    Meaning{"no match for 'operator!=' (operand types are '%Vec3<%>' and '%')%",
            "A vector is compared with a vector; whether it is not zero: {left} != Vec3<Real>{}."},
    Meaning{"no match for 'operator%' (operand types are '%std::optional<%",
            "There is no {1} between these: what an optional holds is reached by ->, as in best->t, where it holds "
            "something."},
    Meaning{"no match for 'operator*' (operand types are '%Vec3<%>' and '%Rotation<%>')%",
            "A rotation stands on the left of what it rotates: write {right} * {left}."},
    Meaning{
        "no match for 'operator*' (operand types are '%Vec3<%>' and '%Vec3<%>')%",
        "There is no vector * vector here; do you mean dot({left}, {right}), a number, or cross({left}, {right}), a "
        "vector?"},
    Meaning{"no match for 'operator*' (operand types are '%Vec3<%>' and '%')%",
            "There is no vector * number here; write the number first: {right} * {left}."},
    Meaning{"no match for 'operator%' (operand types are '%' and '%')%",
            "There is no {1} between {2} and {3}. What there is: Vec3 + Vec3, Vec3 - Vec3, number * Vec3 (the number "
            "first), Vec3 / number, == and != between vectors, and dot and cross for two vectors."},
    Meaning{
        "invalid operands to binary expression ('%' and '%')%",
        "There is no such operator between {1} and {2}. What there is: Vec3 + Vec3, Vec3 - Vec3, number * Vec3 (the "
        "number first), Vec3 / number, == and != between vectors, and dot and cross for two vectors."},
    Meaning{"no matching function for call to 'max%",
            "All that max is given must be of one type: write Real(0) for 0."},
    Meaning{"no matching function for call to 'min%",
            "All that min is given must be of one type: write Real(0) for 0."},
    Meaning{
        "no matching function for call to 'sqrt%",
        "sqrt takes a number. If it has one: write 'using std::sqrt;' before, and sqrt without std::, as Real may be "
        "no built-in number."},
    Meaning{
        "no matching function for call to 'abs%",
        "abs takes a number. If it has one: write 'using std::abs;' before, and abs without std::, as Real may be no "
        "built-in number."},
    Meaning{"no matching function for call to '%(%)'%",
            "There is a function {1}, but it does not take these: {2}. Count them, and compare their types with its "
            "declaration."},
    Meaning{"no matching function for call to '%'%",
            "There is a function {1}, but it does not take what it is given here: compare with its declaration."},
    Meaning{"too few arguments%", "The function takes more than it is given here: compare with its declaration."},
    Meaning{"too many arguments%", "The function takes less than it is given here: compare with its declaration."},
    Meaning{"no return statement%", "The function promises a result, but comes to its end without 'return'."},
    Meaning{"non-void function does not return a value in all control paths%",
            "On some way through the function there is no 'return': what if the condition is false, or no case of the "
            "switch fits? Write a return at the end, or 'default:' for the last case."},
    Meaning{"non-void function does not return a value%",
            "The function promises a result, but comes to its end without 'return'."},
    Meaning{"control reaches end of non-void function%",
            "On some way through the function there is no 'return': what if the condition is false, or no case of the "
            "switch fits? Write a return at the end, or 'default:' for the last case."},
    Meaning{
        "void function '%' should not return a value%",
        "This function is declared to give nothing (void), but returns something: what is its result in the starter?"},
    Meaning{
        "return-statement with a value, in function returning 'void'%",
        "This function is declared to give nothing (void), but returns something: what is its result in the starter?"},
    Meaning{"invalid use of void expression%",
            "A function is used here that gives nothing (void): what is its result in the starter?"},
    Meaning{"cannot convert '%Truth' to '%bool'%", no_bool},
    Meaning{"cannot convert '%Kleene' to '%bool'%", no_bool},
    Meaning{"could not convert '%' from '%Kleene' to 'bool'%", no_bool},
    Meaning{"no viable conversion from '%Truth' to '%bool'%", no_bool},
    Meaning{"no viable conversion from '%Kleene' to '%bool'%", no_bool},
    Meaning{"value of type '%Kleene' is not contextually convertible to 'bool'%", no_bool},
    Meaning{"no viable conversion from returned value of type '%Truth' to%", no_bool},
    Meaning{"no viable conversion from returned value of type '%Kleene' to%", no_bool},
    Meaning{"cannot convert '%' to '%' in return%", "The function must return {2}, and this is {1}."},
    Meaning{"no viable conversion from returned value of type '%' to function return type '%'%",
            "The function must return {2}, and this is {1}."},
    Meaning{"could not convert '%' from '%' to '%'%", "A {3} is needed here, and this is {2}."},
    Meaning{"cannot convert '%' to '%'%", "A {2} is needed here, and this is {1}."},
    Meaning{"no viable conversion from '%' to '%'%", "A {2} is needed here, and this is {1}."},
    Meaning{"conversion from '%' to non-scalar type '%' requested%", "A {2} is needed here, and this is {1}."},
    Meaning{"narrowing conversion of '%' from '%' to '%'%",
            "Within braces a {2} does not become {3} by itself, as digits could be lost: write static_cast<{3}>(…)."},
    Meaning{"type '%' cannot be narrowed to '%'%",
            "Within braces a {1} does not become {2} by itself, as digits could be lost: write static_cast<{2}>(…)."},
    Meaning{"non-constant-expression cannot be narrowed from type '%' to '%'%",
            "Within braces a {1} does not become {2} by itself, as digits could be lost: write static_cast<{2}>(…)."},
    Meaning{"'%' has no member named '%'%", "There is no member {2} in {1}: is it spelt right?"},
    Meaning{"no member named '%' in '%'%", "There is no member {1} in {2}: is it spelt right?"},
    Meaning{"'%' is not a member of '%'%", "There is no {1} in {2}: is it spelt right, and is its header included?"},
    Meaning{"%: No such file or directory%",
            "There is no header {1}: is it spelt right? Ours are in angle brackets, such as <vec3.hpp>."},
    Meaning{"'%' file not found%",
            "There is no header {1}: is it spelt right? Ours are in angle brackets, such as <vec3.hpp>."},
    Meaning{"#include nested%", "The file includes itself, or another one that includes it: is '#pragma once' gone?"},
    Meaning{"template instantiation depth exceeds%", "A template needs itself without end."},
    Meaning{"recursive template instantiation exceeded%", "A template needs itself without end."},
    Meaning{"%constexpr% evaluation depth exceeds%", "A function calls itself without end."},
    Meaning{"a template declaration cannot appear at block scope%",
            "A function begins before the one above has ended: a } is missing there."},
    Meaning{"a function-definition is not allowed here%",
            "A function begins before the one above has ended: a } is missing there."},
    Meaning{"function definition is not allowed here%",
            "A function begins before the one above has ended: a } is missing there."},
    Meaning{"%namespace%definition is not allowed here%", "A } is missing further up: something has not ended."},
    Meaning{"namespaces can only be defined in global or namespace scope%",
            "A } is missing further up: something has not ended."},
    Meaning{"expected '}'%", "A { is never closed: its } is missing."},
    Meaning{"extraneous closing brace%", "There is one } too many, here or further up."},
    Meaning{"expected declaration before '}'%", "There is one } too many, here or further up."},
    Meaning{"expected ')'%", "A ( is not closed: its ) is missing before this."},
    Meaning{"expected ']'%", "A [ is not closed: its ] is missing before this."},
    Meaning{"expected '(' %", "A ( is missing here: a condition stands in parentheses, if (a > b)."},
    Meaning{
        "'else' without a previous 'if'%",
        "This else has no if before it: is there a ; after the if's parenthesis, or are there two statements without "
        "{ }?"},
    Meaning{"unterminated%comment%", "A comment that begins here with /* never ends: write */ where it does."},
    Meaning{"unterminated #%", "This #{1} never ends: its #endif is missing."},
    Meaning{"unterminated conditional directive%", "This # directive never ends: its #endif is missing."},
    Meaning{"#% without #if%", "There is no #if before this #{1}: one must go, or the #if is missing."},
    Meaning{"missing terminating%", "A quotation mark is not closed."},
    Meaning{"%extended character % is not valid%",
            "C++ does not know the character {2}: write * for × and ·, - for −, sqrt(…) for √."},
    Meaning{"unexpected character%", "C++ does not know this character: write * for × and ·, - for −, sqrt(…) for √."},
    Meaning{"stray '%' in program%", "C++ does not know the character {1}; delete it."},
    Meaning{"%non-ASCII characters are not allowed%",
            "C++ does not know this character: write * for × and ·, - for −, sqrt(…) for √."},
    Meaning{"redefinition of '%'%", "{1} is written twice; one must go."},
    Meaning{"redeclaration of '%'%", "{1} is declared twice; one must go, or have another name."},
    Meaning{"%previously defined%", "This is written twice; one must go."},
    Meaning{"assignment of % in read-only object%",
            "A single = changes what stands to its left. To compare, write ==. To change it is not possible: what the "
            "function is given is const. Make a variable of your own."},
    Meaning{"assignment of read-only%",
            "A single = changes what stands to its left. To compare, write ==. To change it is not possible: it is "
            "const."},
    Meaning{"cannot assign to%",
            "A single = changes what stands to its left. To compare, write ==. To change it is not possible: it is "
            "const."},
    Meaning{"lvalue required as left operand of assignment%",
            "A single = changes what stands to its left, and only a variable can be changed. To compare, write ==."},
    Meaning{"expression is not assignable%",
            "A single = changes what stands to its left, and only a variable can be changed. To compare, write ==."},
    Meaning{"invalid type argument of unary '*'%", "Something is missing before this *, or the * is one too many."},
    Meaning{"indirection requires pointer operand%", "Something is missing before this *, or the * is one too many."},
    Meaning{"expected primary-expression before%",
            "Something is missing before this: a value, or an operator is too many."},
    Meaning{"expected expression%",
            "A value is missing here, or something before it is one too many; or a } is missing further up."},
    Meaning{"expected unqualified-id%",
            "This cannot begin anything here: is there one } too many further up, or text that is no C++?"},
    Meaning{"call of overloaded '%' is ambiguous%",
            "There are several functions {1}, and none fits best: give it numbers of one type, such as Real(2)."},
    Meaning{"call to '%' is ambiguous%",
            "There are several functions {1}, and none fits best: give it numbers of one type, such as Real(2)."},
    Meaning{"deduced conflicting types%", "Two numbers of different types meet here: write both as Real, Real(2)."},
    Meaning{"static assertion failed%", "A condition that must hold when compiling does not."},
};

}  // namespace

std::string in_our_names(std::string message) {
    for (const auto& [tests, ours] : {std::pair{"glassbox::test::UnsureTruth", "Truth"},
                                      {"test::UnsureTruth", "Truth"},
                                      {"glassbox::test::Unsure", "Real"},
                                      {"test::Unsure", "Real"}})
        replace_all(message, tests, ours);
    return message;
}

std::string in_plain_words(std::string_view message, const OperatorInSource& operation) {
    const std::string text = with_operator(in_our_names(without_aliases(message)), operation.sign);
    for (const Meaning& meaning : meanings) {
        const auto taken = matched(text, meaning.pattern);
        if (!taken) continue;
        std::string plain(meaning.plain);
        for (std::size_t i = 0; i < taken->size(); ++i)
            replace_all(plain, fmt::format("{{{}}}", i + 1), simple((*taken)[i]));
        replace_all(plain, "{left}", operation.left);
        replace_all(plain, "{right}", operation.right);
        return plain;
    }
    return "";
}

}  // namespace glassbox::learn
