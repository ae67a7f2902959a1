#pragma once
// doctest's TEST_CASE, TEST_CASE_TEMPLATE and CAPTURE for a learner's tests, which are compiled for one scalar: each
// becomes one function where doctest's own become eight, since a learner waits for them after each change. The rest is
// in main.cpp.
#include <doctest.h>

#include <memory>
#include <ostream>
#include <type_traits>

namespace glassbox::test {

/// Makes a test case known to doctest.
struct KnownCase {
    KnownCase(void (*test)(), const char* file, int line, const char* name);
};

/// A value of which a failing check tells, as long as this lives: as it is then, if it has a name of its own.
class Captured : public doctest::detail::ContextScopeBase {
public:
    template <class T>
    Captured(const char* name, T&& value) : Captured(name, std::addressof(value), as_text<std::remove_reference_t<T>>) {
        if (!std::is_lvalue_reference_v<T>) settle();
    }
    ~Captured() override;
    void stringify(std::ostream* out) const override;

private:
    using AsText = doctest::String (*)(const void*);

    Captured(const char* name, const void* value, AsText to_text);
    void settle();

    template <class T>
    static doctest::String as_text(const void* value) {
        return doctest::toString(*static_cast<const T*>(value));
    }

    const char* name_;
    const void* value_;  ///< null once it is settled
    AsText as_text_;
    doctest::String text_;
};

}  // namespace glassbox::test

#undef TEST_CASE
#define TEST_CASE(name) GLASSBOX_CASE(DOCTEST_ANONYMOUS(glassbox_case_), name)
#define GLASSBOX_CASE(function, name)                                                                         \
    static void function();                                                                                   \
    static const glassbox::test::KnownCase DOCTEST_CAT(known_, function)(function, __FILE__, __LINE__, name); \
    static void function()

#undef TEST_CASE_TEMPLATE
#define TEST_CASE_TEMPLATE(name, Real, ...) GLASSBOX_CASE_IN(DOCTEST_ANONYMOUS(glassbox_case_), name, Real, __VA_ARGS__)
#define GLASSBOX_CASE_IN(function, name, Real, scalar)                                                         \
    template <class Real>                                                                                      \
    static void function();                                                                                    \
    static const glassbox::test::KnownCase DOCTEST_CAT(known_, function)(function<scalar>, __FILE__, __LINE__, \
                                                                         name "<" #scalar ">");                \
    template <class Real>                                                                                      \
    static void function()

#undef CAPTURE
#define CAPTURE(value) const glassbox::test::Captured DOCTEST_ANONYMOUS(glassbox_captured_)(#value, value)
