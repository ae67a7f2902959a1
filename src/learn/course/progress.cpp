#include "learn/course/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>

#include "output/whole_file.hpp"
#include "scene/error.hpp"
#include "scene/named.hpp"
#include "scene/text_file.hpp"

namespace glassbox::learn {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int version = 1;
constexpr NameTable<State, 5> states{{{"unknown", State::unknown, ""},
                                      {"not written", State::not_written, ""},
                                      {"waiting", State::waiting, ""},
                                      {"failing", State::failing, ""},
                                      {"passed", State::passed, ""}}};

/// Throws the exceptions of nlohmann's library, or Error, for anything that is not in the form that we write.
Progress progress_from(const Json& json) {
    if (json.at("version").get<int>() != version) throw Error("it is of another version of Glassbox");
    Progress progress;
    for (const auto& [name, saved] : json.at("lessons").items()) {
        LessonProgress& lesson = progress.lessons[name];
        lesson.passed = saved.at("passed").get<bool>();
        lesson.gave_up = saved.at("gave_up").get<bool>();
        lesson.runs = saved.at("runs").get<int>();
        lesson.tested = saved.at("tested").get<std::string>();
        for (const auto& [function, shown] : saved.at("hints").items())
            lesson.hints[function] = std::clamp(shown.get<int>(), 0, 3);
        for (const auto& [function, state] : saved.at("functions").items())
            lesson.functions[function] = find_named(states, state.get<std::string>()).value_or(State::unknown);
    }
    return progress;
}

}  // namespace

Progress read_progress(const fs::path& file, std::string& complaint) {
    std::error_code failed;
    if (!fs::exists(fs::symlink_status(file, failed))) return {};
    std::string why;
    try {
        return progress_from(Json::parse(read_text(file)));
    } catch (const Json::exception&) {
        why = "it is not as it was written";
    } catch (const Error& error) {
        why = error.what();
    }
    const fs::path aside = file.string() + ".unreadable";
    fs::remove_all(aside, failed);
    fs::rename(file, aside, failed);
    complaint =
        fmt::format("{}: note: this memory of your progress cannot be read ({}); it is now {}, and a new one begins",
                    file.string(), why, aside.filename().string());
    return {};
}

const Exercise& present_exercise(const Workspace& workspace, const Progress& progress) {
    const auto passed = [&](const Exercise& exercise) {
        const auto found = progress.lessons.find(exercise.name);
        return found != progress.lessons.end() && found->second.passed;
    };
    std::error_code none;
    for (const Exercise& exercise : workspace.exercises)
        if (!passed(exercise) && std::filesystem::is_directory(workspace.headers_of(exercise), none)) return exercise;
    for (const Exercise& exercise : workspace.exercises)
        if (!passed(exercise)) return exercise;
    return workspace.exercises.back();
}

void write_progress(const fs::path& file, const Progress& progress) {
    Json lessons = Json::object();
    for (const auto& [name, lesson] : progress.lessons) {
        Json functions = Json::object();
        for (const auto& function : lesson.functions)
            functions[function.first] = name_where(states, [&](State one) { return one == function.second; });
        lessons[name] = {{"passed", lesson.passed},     {"gave_up", lesson.gave_up}, {"runs", lesson.runs},
                         {"hints", Json(lesson.hints)}, {"functions", functions},    {"tested", lesson.tested}};
    }
    const std::string text = Json{{"version", version}, {"lessons", lessons}}.dump(1) + '\n';
    std::error_code failed;
    fs::create_directories(file.parent_path(), failed);
    write_whole(file, std::as_bytes(std::span(text)));
}

}  // namespace glassbox::learn
