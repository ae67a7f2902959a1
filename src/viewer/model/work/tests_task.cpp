#include "viewer/model/work/tests_task.hpp"

#include <string>
#include <utility>

#include "learn/tell_tests.hpp"
#include "viewer/model/work/mine_task.hpp"

namespace glassbox {

void TestMine::perform(const Request& request, const Run& run, const std::function<void(Result)>& deliver) {
    const auto tell = [&](learn::ToldTests tests) {
        deliver(std::make_shared<const learn::ToldTests>(std::move(tests)));
    };
    const learn::Exercise& exercise = learn::exercise_called(*request.workspace, std::to_string(request.lesson));
    learn::ToldTests waiting;
    waiting.lesson = request.lesson;
    waiting.words = "the tests come after the picture";
    tell(std::move(waiting));
    wait_for_picture(run);
    learn::tell_tests(*request.workspace, exercise, tell, run.stop);
}

void TestMine::tidy(const ViewerState& state, Results& results, bool) {
    const bool is_shown =
        runs_tests(state) && results.tests && results.tests->lesson == exercise_of(state.mine)->number;
    if (!is_shown) results.tests = nullptr;
}

void TestMine::show(Result tests, Results& results) {
    const bool is_first_word = tests->stand == learn::ToldTests::Stand::running && tests->functions.empty();
    if (is_first_word && results.tests && results.tests->lesson == tests->lesson) {
        learn::ToldTests kept = *results.tests;
        kept.stand = tests->stand;
        kept.words = tests->words;
        results.tests = std::make_shared<const learn::ToldTests>(std::move(kept));
        return;
    }
    results.tests = std::move(tests);
}

}  // namespace glassbox
