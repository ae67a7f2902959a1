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
#include <support/traced_ray.hpp>
#include <support/ulps.hpp>
#include <vector>

#include "learn/subprocess/last_words.hpp"

namespace {

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

template <std::size_t size>
std::string in_json(const std::array<double, size>& numbers, std::size_t count) {
    std::string list;
    for (std::size_t i = 0; i < count; ++i) list += (i == 0 ? "" : ",") + digits(numbers[i]);
    return "[" + list + "]";
}

/// Returns the ray that was traced last, if it can be written down.
std::string traced_ray() {
    const glassbox::test::TracedRay& last = glassbox::test::last_traced_ray();
    const auto finite = [](double number) { return std::isfinite(number); };
    if (last.numbers == 0 || !std::all_of(last.ray.begin(), last.ray.end(), finite) ||
        !std::all_of(last.surface.begin(), last.surface.begin() + last.numbers, finite))
        return "";
    return member("ray", in_json(last.ray, last.ray.size())) +
           member("surface", in_json(last.surface, static_cast<std::size_t>(last.numbers)));
}

/// Reports each test case, and the first thing that goes wrong in it.
class Reporter : public doctest::IReporter {
public:
    explicit Reporter(const doctest::ContextOptions&) {}

    void test_case_start(const doctest::TestCaseData& test) override {
        subcases_.clear();
        told_ = false;
        glassbox::test::last_traced_ray() = {};
        tell("case", member("name", in_json(test.m_name)));
    }
    void test_case_reenter(const doctest::TestCaseData&) override { subcases_.clear(); }
    void test_case_end(const doctest::CurrentTestCaseStats& end) override {
        tell("end", member("passed", end.failure_flags == 0 ? "true" : "false"));
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
        wrong(member("threw", in_json(exception.error_string.c_str())), contexts);
    }
    void log_assert(const doctest::AssertData& check) override {
        if (!check.m_failed) return;
        std::string members = place(check.m_file, check.m_line) + member("expression", in_json(check.m_expr));
        if (check.m_threw) members += member("threw", in_json(check.m_exception.c_str()));
        else
            members += member("negated", check.m_at & doctest::assertType::is_false ? "true" : "false") +
                       member("got", in_json(check.m_decomp.c_str()));
        wrong(members, active_contexts());
    }
    void log_message(const doctest::MessageData& message) override {
        if (message.m_severity & doctest::assertType::is_warn) return;
        std::string members = place(message.m_file, message.m_line);
        if (difference)
            members += member("expression", in_json(difference->expression)) +
                       member("expected", in_json(difference->expected)) + member("got", in_json(difference->got)) +
                       member("ulps", in_json(digits(difference->ulps)));
        else members += member("expression", in_json(message.m_string.c_str())) + member("got", in_json(""));
        wrong(members, active_contexts());
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

    void wrong(const std::string& members, const std::vector<std::string>& contexts) {
        if (told_) return;
        told_ = true;
        tell("wrong",
             members + member("contexts", in_json(contexts)) + member("subcases", in_json(subcases_)) + traced_ray());
    }

    bool told_ = false;
    std::vector<std::string> subcases_;
};

REGISTER_REPORTER("learn", 1, Reporter);

}  // namespace

namespace glassbox::test {

template std::string shown(float);
template std::string shown(double);
template std::string shown(long double);

void passed() {}

void failed(const Difference& one) {
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
