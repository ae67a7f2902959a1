// Where lessons are found in folders that learners hand in.
#include "learn/report/handed_in.hpp"

#include <doctest.h>

#include <fstream>

#include "output/folder.hpp"
#include "scene/error.hpp"

using namespace glassbox;
using namespace glassbox::learn;
using glassbox::test::Folder;
using glassbox::test::message_of;
namespace fs = std::filesystem;

namespace {

/// A folder of handed-in folders, and the teacher who grades them.
struct Hand {
    Folder folder;
    Workspace teacher = open_workspace(ROOT, folder.path / "teacher");
    std::vector<std::string> told;

    fs::path file(const std::string& name) const {
        fs::create_directories((folder / name).parent_path());
        std::ofstream(folder / name) << "#pragma once\n";
        return folder / name;
    }
    const Exercise& lesson(int number) const { return exercise_called(teacher, std::to_string(number)); }
    HandedIn in(const std::string& name) const { return handed_in(teacher, folder / name); }
    std::vector<HandedIn> all(const std::vector<std::string>& names) {
        std::vector<fs::path> paths;
        for (const std::string& name : names) paths.push_back(folder / name);
        return all_handed_in(teacher, paths, [&](const std::string& line) { told.push_back(line); });
    }
};

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("a folder as it should be is taken as it is, without a note") {
    Hand hand;
    const fs::path header = hand.file("ada/1-rays/vec3.hpp");
    const HandedIn ada = hand.in("ada");
    CHECK(ada.learner == "ada");
    CHECK(ada.workspace.header(hand.lesson(1), "vec3.hpp") == header);
    CHECK(ada.notes.empty());
    CHECK(hand.in("ada/").learner == "ada");
}

TEST_CASE("lessons are found in a folder within the folder, and it is noted") {
    Hand hand;
    const fs::path header = hand.file("bo/my/1-rays/vec3.hpp");
    const HandedIn bo = hand.in("bo");
    CHECK(bo.learner == "bo");
    CHECK(bo.workspace.header(hand.lesson(1), "vec3.hpp") == header);
    REQUIRE(bo.notes.size() == 1);
    CHECK(has(bo.notes[0], "bo: note: its lessons are in "));
    CHECK(bo.notes[0].ends_with("bo/my"));

    hand.file("bo/old/1-rays/vec3.hpp");  // the first in order is used, and the other is noted
    REQUIRE(hand.in("bo").notes.size() == 1);
    CHECK(has(hand.in("bo").notes[0], "and others in "));
    CHECK(has(hand.in("bo").notes[0], "bo/old"));
    hand.file("bo/1-rays/vec3.hpp");  // the higher level has precedence
    CHECK(hand.in("bo").workspace.folder == (hand.folder / "bo"));
}

TEST_CASE("of all of Glassbox only my/ is a learner's: neither our solutions nor our starters count as theirs") {
    Hand hand;
    for (const char* ours : {"di/glassbox/src/core/1-rays/vec3.hpp", "di/glassbox/lessons/1-rays/exercise.toml"})
        hand.file(ours);
    CHECK(hand.in("di").workspace.folder == (hand.folder / "di"));
    REQUIRE(hand.in("di").notes.size() == 1);
    CHECK(has(hand.in("di").notes[0], "there is no lesson in it"));
    const fs::path header = hand.file("di/glassbox/my/1-rays/vec3.hpp");
    CHECK(hand.in("di").workspace.header(hand.lesson(1), "vec3.hpp") == header);
}

TEST_CASE("a lesson's folder may have capitals, another sign between its words, or no number") {
    Hand hand;
    for (const char* name : {"1-Rays", "1_rays", "1 rays", "Rays", "1"}) {
        CAPTURE(name);
        const fs::path header = hand.file(std::string("cy/") + name + "/vec3.hpp");
        const HandedIn cy = hand.in("cy");
        CHECK(fs::equivalent(cy.workspace.header(hand.lesson(1), "vec3.hpp"), header));
        CHECK(cy.notes.empty());
        fs::remove_all(hand.folder / "cy");
    }
    hand.file("cy/3-rays/vec3.hpp");  // ambiguous: lesson 1 or lesson 3
    CHECK(hand.in("cy").workspace.called_otherwise.empty());
}

TEST_CASE("headers that lie elsewhere than in a lesson's folder are not looked at, and it is said where they belong") {
    Hand hand;
    hand.file("eve/vec3.hpp");
    hand.file("eve/6-rounding/numerics/bounded.hpp");  // where it was in version 0.1
    const HandedIn eve = hand.in("eve");
    REQUIRE(eve.notes.size() == 2);
    CHECK(has(eve.notes[0], "eve/vec3.hpp: note: this is not looked at: lesson 1 is in "));
    CHECK(has(eve.notes[0], "eve/1-rays; move it there"));
    CHECK(has(eve.notes[1], "eve/6-rounding/numerics/bounded.hpp: note: this is not looked at: lesson 6 is in "));
    CHECK(has(eve.notes[1], "eve/6-rounding; move it there"));
    hand.file("fay/1-rays/Vec3.hpp");  // no include finds this name
    REQUIRE(hand.in("fay").notes.size() == 1);
    CHECK(has(hand.in("fay").notes[0], "Vec3.hpp: note: this is not looked at"));
}

TEST_CASE("what is no folder is left out; what is not there, or no folder at all, is refused before any work") {
    Hand hand;
    hand.file("ada/1-rays/vec3.hpp");
    hand.file("notes.txt");
    hand.file("bo/my/1-rays/vec3.hpp");
    const std::vector<HandedIn> all = hand.all({"ada", "bo", "notes.txt"});
    REQUIRE(all.size() == 2);
    CHECK(all[0].learner == "ada");
    CHECK(all[1].learner == "bo");
    REQUIRE(hand.told.size() == 2);
    CHECK(has(hand.told[0], "notes.txt: note: this is no folder; it is left out"));
    CHECK(has(hand.told[1], "bo: note: its lessons are in "));
    CHECK(has(message_of<Error>([&] { hand.all({"ada", "bob"}); }), "bob: error: there is no such folder"));
    CHECK(has(message_of<Error>([&] { hand.all({"notes.txt"}); }), "notes.txt: error: there is no such folder"));
}

TEST_CASE("learners whose folders have one name are told apart") {
    Hand hand;
    hand.file("ada/my/1-rays/vec3.hpp");
    hand.file("bo/my/1-rays/vec3.hpp");
    const std::vector<HandedIn> all = hand.all({"ada/my", "bo/my"});
    REQUIRE(all.size() == 2);
    CHECK(all[0].learner.ends_with("ada/my"));
    CHECK(all[1].learner.ends_with("bo/my"));
}
