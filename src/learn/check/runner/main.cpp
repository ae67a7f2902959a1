// The main() of a learner's tests. It is compiled once, on the learner's machine, and linked with each test of a
// lesson. It reports how each test case went, one line of JSON each, in a file; each line is flushed at once, so that
// the name of a test that crashes is known. See learn/check/test_report.hpp.
#define DOCTEST_CONFIG_IMPLEMENT
#define DOCTEST_CONFIG_NO_POSIX_SIGNALS  // last_words.hpp reports signals
#include <doctest.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>
#include <support/seen.hpp>
#include <support/traced_ray.hpp>
#include <support/ulps.hpp>
#include <vector>

#include "learn/check/runner/lean_cases.hpp"
#include "learn/subprocess/last_words.hpp"

namespace {

using glassbox::test::Compared, glassbox::test::Named, glassbox::test::Seen, glassbox::test::TracedRay;

/// Of each check in a test case so many passes are kept, and so many failures: with which inputs, and what came out.
constexpr int most_kept = 60;

int report = -1;
std::string nonce;
const glassbox::test::Difference* difference = nullptr;  ///< the check that is just failing, if it is one of ours

std::string in_json(std::string_view text) {
    std::string quoted = "\"";
    for (const char c : text) {
        char code[8];
        std::snprintf(code, sizeof code, "\\u%04x", static_cast<unsigned>(static_cast<unsigned char>(c)));
        if (c == '"' || c == '\\') quoted += '\\', quoted += c;
        else if (static_cast<unsigned char>(c) < ' ') quoted += code;
        else quoted += c;
    }
    return quoted + '"';
}

std::string in_json(const std::vector<std::string>& texts) {
    std::string list;
    for (const std::string& text : texts) list += (list.empty() ? "" : ",") + in_json(text);
    return "[" + list + "]";
}

/// Writes a line of the report: what it is, and its members as JSON.
void tell(std::string_view what, const std::string& members = "") {
    const std::string line = "{\"nonce\":" + in_json(nonce) + ",\"is\":" + in_json(what) + members + "}\n";
    for (std::string_view rest = line; !rest.empty();) {
        const ssize_t count = ::write(report, rest.data(), rest.size());
        if (count <= 0) {
            glassbox::learn::last_words().kind = glassbox::learn::LastWords::cannot_write;
            ::_exit(1);
        }
        rest.remove_prefix(static_cast<std::size_t>(count));
    }
}

std::string member(std::string_view name, const std::string& json) { return "," + in_json(name) + ":" + json; }

/// Returns a number with all its digits.
std::string digits(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.17g", number);
    return text;
}

/// Numbers that JSON does not have become texts.
template <std::size_t size>
std::string in_json(const std::array<double, size>& numbers, std::size_t count) {
    std::string list;
    for (std::size_t i = 0; i < count; ++i) {
        const std::string number = digits(numbers[i]);
        list += (i == 0 ? "" : ",") + (std::isfinite(numbers[i]) ? number : in_json(number));
    }
    return "[" + list + "]";
}

std::string in_json(const Compared& one) { return in_json(one.numbers, static_cast<std::size_t>(one.count)); }

std::string in_json(const std::vector<Named>& inputs) {
    std::string list;
    for (const Named& one : inputs)
        list += (list.empty() ? "" : ",") + in_json(one.name) + ":" +
                in_json(one.numbers, static_cast<std::size_t>(one.count));
    return "{" + list + "}";
}

/// Returns a ray, if it can be written down.
std::string in_json(const TracedRay& traced) {
    const auto finite = [](double number) { return std::isfinite(number); };
    if (traced.numbers == 0 || !std::all_of(traced.ray.begin(), traced.ray.end(), finite) ||
        !std::all_of(traced.surface.begin(), traced.surface.begin() + traced.numbers, finite))
        return "";
    return member("ray", in_json(traced.ray, traced.ray.size())) +
           member("surface", in_json(traced.surface, static_cast<std::size_t>(traced.numbers)));
}

std::vector<Named> inputs_now() { return Seen::now() ? Seen::now()->named() : std::vector<Named>{}; }

/// How hard a number is to read: its binary digits, and how far its point is from them.
int length_of(double number) {
    if (number == 0 || !std::isfinite(number)) return 0;
    int exponent = 0, digits = 0;
    double rest = std::abs(std::frexp(number, &exponent));
    for (; rest != 0 && digits < 53; ++digits) rest = 2 * rest - std::floor(2 * rest);
    return digits + std::abs(exponent);
}

/// The same for all that a check is given.
int length_of(const std::vector<Named>& inputs) {
    const TracedRay& traced = glassbox::test::last_traced_ray();
    int length = 0;
    for (const Named& one : inputs)
        for (int i = 0; i < one.count; ++i) length += length_of(one.numbers[static_cast<std::size_t>(i)]);
    for (const double number : traced.ray) length += traced.numbers > 0 ? length_of(number) : 0;
    for (int i = 0; i < traced.numbers; ++i) length += length_of(traced.surface[static_cast<std::size_t>(i)]);
    return length;
}

/// A check as it was made once.
struct Made {
    bool passed, is_condition;
    std::string expression;
    Compared should_be, is;
    std::vector<Named> inputs;
    TracedRay traced;
};

/// A check of a test case, by its line: how often it passed and failed, and some of those times.
struct Line {
    int number, passed = 0, failed = 0;
    std::vector<Made> made;
};

/// The checks of a test case, in the order in which they were made first.
struct Case {
    std::string name;
    std::vector<Line> lines;
};

std::vector<Case> cases;

void keep(const char* expression, int number, bool passed, const Compared& should_be, const Compared& is,
          bool is_condition = false) {
    if (cases.empty()) return;
    std::vector<Line>& lines = cases.back().lines;
    auto line = std::find_if(lines.rbegin(), lines.rend(), [&](const Line& one) { return one.number == number; });
    if (line == lines.rend()) {
        lines.push_back({number, 0, 0, {}});
        line = lines.rbegin();
    }
    if (++(passed ? line->passed : line->failed) <= most_kept)
        line->made.push_back(
            {passed, is_condition, expression, should_be, is, inputs_now(), glassbox::test::last_traced_ray()});
}

/// How the checks of a case went, a sign for each: "++-~", the last one failed only sometimes.
std::string signs(const Case& one) {
    std::string all;
    for (const Line& line : one.lines) all += line.failed == 0 ? '+' : line.passed == 0 ? '-' : '~';
    return all;
}

/// Tells of the checks that were kept, of all cases so far that were not told; only where one has failed, as they are
/// many.
void tell_checks() {
    static std::size_t told = 0;
    static bool any_failed = false;
    for (const Line& line : cases.back().lines) any_failed |= line.failed > 0;
    if (!any_failed) return;
    for (; told < cases.size(); ++told)
        for (const Line& line : cases[told].lines)
            for (const Made& made : line.made)
                tell("check", member("case", in_json(cases[told].name)) + member("line", std::to_string(line.number)) +
                                  member("passed", made.passed ? "true" : "false") +
                                  member("condition", made.is_condition ? "true" : "false") +
                                  member("expression", in_json(made.expression)) +
                                  member("expected", in_json(made.should_be)) + member("got", in_json(made.is)) +
                                  member("inputs", in_json(made.inputs)) + in_json(made.traced));
}

/// Reports each test case, and the first check that goes wrong in it; of those of one line the one that is made of the
/// shortest numbers.
class Reporter : public doctest::IReporter {
public:
    explicit Reporter(const doctest::ContextOptions&) {}

    void test_case_start(const doctest::TestCaseData& test) override {
        subcases_.clear();
        threw_.clear();
        told_line_ = none_told;
        glassbox::test::last_traced_ray() = {};
        cases.push_back({test.m_name, {}});
        tell("case", member("name", in_json(test.m_name)));
    }
    void test_case_reenter(const doctest::TestCaseData&) override { subcases_.clear(); }
    void test_case_end(const doctest::CurrentTestCaseStats& end) override {
        tell("end", member("passed", end.failure_flags == 0 ? "true" : "false") +
                        member("checks", in_json(signs(cases.back()))) + member("threw", in_json(threw_)));
        tell_checks();
    }
    void subcase_start(const doctest::SubcaseSignature& subcase) override {
        subcases_.emplace_back(subcase.m_name.c_str());
    }
    void subcase_end() override {
        if (!subcases_.empty()) subcases_.pop_back();
    }

    void test_case_exception(const doctest::TestCaseException& exception) override {
        std::vector<std::string> contexts;
        for (int i = 0; i < get_num_stringified_contexts(); ++i)
            contexts.emplace_back(get_stringified_contexts()[i].c_str());
        threw_ = exception.error_string.c_str();
        wrong(thrown, member("threw", in_json(threw_)), contexts);
    }
    void log_assert(const doctest::AssertData& check) override {
        keep_condition(check);
        if (!check.m_failed) return;
        std::string members = place(check.m_file, check.m_line) + member("expression", in_json(check.m_expr));
        if (check.m_threw) members += member("threw", in_json(check.m_exception.c_str()));
        else
            members += member("negated", check.m_at & doctest::assertType::is_false ? "true" : "false") +
                       member("got", in_json(check.m_decomp.c_str()));
        wrong(check.m_line, members, active_contexts());
    }
    void log_message(const doctest::MessageData& message) override {
        if (message.m_severity & doctest::assertType::is_warn) return;
        std::string members = place(message.m_file, message.m_line);
        if (difference)
            members += member("expression", in_json(difference->expression)) +
                       member("expected", in_json(difference->expected)) + member("got", in_json(difference->got)) +
                       member("ulps", in_json(digits(difference->ulps)));
        else members += member("expression", in_json(message.m_string.c_str())) + member("got", in_json(""));
        wrong(message.m_line, members, active_contexts());
    }

    void report_query(const doctest::QueryData&) override {}
    void test_run_start() override {}
    void test_run_end(const doctest::TestRunStats&) override {}
    void test_case_skipped(const doctest::TestCaseData&) override {}

private:
    static std::string place(const char* file, int line) {
        return member("file", in_json(file)) + member("line", std::to_string(line));
    }

    static std::vector<std::string> active_contexts() {
        std::vector<std::string> contexts;
        for (int i = 0; i < get_num_active_contexts(); ++i) {
            std::ostringstream text;
            get_active_contexts()[i]->stringify(&text);
            contexts.push_back(text.str());
        }
        return contexts;
    }

    /// A condition counts as a number, 1 for true.
    static void keep_condition(const doctest::AssertData& check) {
        if (!(check.m_at & doctest::assertType::is_normal) || check.m_threw) {
            keep(check.m_expr, check.m_line, !check.m_failed, {}, {}, true);
            return;
        }
        const double right = check.m_at & doctest::assertType::is_false ? 0 : 1;
        keep(check.m_expr, check.m_line, !check.m_failed, {{right}, 1}, {{check.m_failed ? 1 - right : right}, 1},
             true);
    }

    void wrong(int line, const std::string& members, const std::vector<std::string>& contexts) {
        const std::vector<Named> inputs = inputs_now();
        const int length = length_of(inputs);
        if (told_line_ != none_told && (line != told_line_ || length >= told_length_)) return;
        told_line_ = line;
        told_length_ = length;
        tell("wrong", members + member("contexts", in_json(contexts)) + member("subcases", in_json(subcases_)) +
                          member("inputs", in_json(inputs)) + in_json(glassbox::test::last_traced_ray()));
    }

    static constexpr int none_told = -1, thrown = -2;
    int told_line_ = none_told, told_length_ = 0;
    std::vector<std::string> subcases_;
    std::string threw_;  ///< what ended the case
};

REGISTER_REPORTER("learn", 1, Reporter);

}  // namespace

namespace glassbox::test {

KnownCase::KnownCase(void (*test)(), const char* file, int line, const char* name) {
    using namespace doctest::detail;
    regTest(TestCase(test, file, static_cast<unsigned>(line), doctest_detail_test_suite_ns::getCurrentTestSuite()) *
            name);
}

Captured::Captured(const char* name, const void* value, AsText to_text)
    : name_(name), value_(value), as_text_(to_text) {}
Captured::~Captured() { destroy(); }
void Captured::settle() {
    text_ = as_text_(value_);
    value_ = nullptr;
}
void Captured::stringify(std::ostream* out) const {
    *out << name_ << " := " << (value_ ? as_text_(value_) : text_).c_str();
}

void passed() { passed("", Seen::now() ? Seen::now()->line() : 0, {}); }
void passed(const char* expression, int line, const Compared& should_be) {
    keep(expression, line, true, should_be, should_be);
}

void failed(const Difference& one) {
    keep(one.expression, one.line, false, one.should_be, one.is);
    difference = &one;
    ADD_FAIL_CHECK_AT(one.file, one.line, "");
    difference = nullptr;
}

}  // namespace glassbox::test

/// main REPORT NONCE: runs all tests. Each line of the report carries the nonce, which detects lines that others write.
int main(int argc, char** argv) {
    glassbox::learn::listen_for_the_end();
    if (argc != 3) return 2;
    nonce = argv[2];
    report = ::open(argv[1], O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0666);
    if (report < 0) return 2;
    doctest::Context context;
    context.setOption("reporters", "learn");
    context.setOption("no-breaks", true);
    context.setOption("order-by", "file");
    const int status = context.run();
    tell("done");
    glassbox::learn::work_is_done();
    return status == 0 ? 0 : 1;
}
