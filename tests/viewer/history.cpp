// Undo and redo, and drags that are one step of them.
#include "viewer/model/state/history.hpp"

#include <doctest.h>

using namespace glassbox;

TEST_CASE("undo and redo go through the changes, and a new change forgets what was undone") {
    History<int> history(0);
    CHECK_FALSE(history.can_undo());
    CHECK_FALSE(history.can_redo());
    history.undo();  // nothing to undo: nothing happens
    history.redo();
    CHECK(history.now() == 0);
    history.change(1);
    history.change(2);
    history.undo();
    CHECK(history.now() == 1);
    CHECK(history.can_redo());
    history.redo();
    CHECK(history.now() == 2);
    history.undo();
    history.undo();
    CHECK(history.now() == 0);
    CHECK_FALSE(history.can_undo());
    history.change(3);
    CHECK_FALSE(history.can_redo());
    CHECK(history.now() == 3);
    history.undo();
    CHECK(history.now() == 0);
}

TEST_CASE("a change to what is there already is none") {
    History<int> history(5);
    history.change(5);
    CHECK_FALSE(history.can_undo());
}

TEST_CASE("a drag is one change, however many steps it has") {
    History<int> history(0);
    history.change(1);
    for (const int step : {2, 3, 4}) history.drag(step);
    CHECK(history.now() == 4);
    CHECK(history.before_drag() == 1);
    history.end_drag();
    CHECK(history.before_drag() == 4);
    for (const int step : {5, 6}) history.drag(step);
    history.end_drag();
    history.undo();
    CHECK(history.now() == 4);
    history.undo();
    CHECK(history.now() == 1);
    history.redo();
    CHECK(history.now() == 4);
}

TEST_CASE("a drag that comes back to where it began is no change") {
    History<int> history(1);
    for (const int step : {2, 3, 1}) history.drag(step);
    history.end_drag();
    CHECK(history.now() == 1);
    CHECK_FALSE(history.can_undo());
    CHECK_FALSE(history.can_redo());
    history.drag(1);  // a press that moves nothing
    history.end_drag();
    CHECK_FALSE(history.can_undo());
}

TEST_CASE("undo and change end a drag") {
    History<int> history(0);
    history.drag(1);
    history.undo();
    CHECK(history.now() == 0);
    history.drag(2);  // the mouse is still down: a change of its own
    history.drag(3);
    history.change(4);
    history.undo();
    CHECK(history.now() == 3);
    history.undo();
    CHECK(history.now() == 0);
}

TEST_CASE("replacing all versions keeps undo and redo") {
    History<int> history(1);
    history.change(2);
    history.change(3);
    history.undo();
    history.replace_all([](int version) { return 10 * version; });
    CHECK(history.now() == 20);
    history.redo();
    CHECK(history.now() == 30);
    history.undo();
    history.undo();
    CHECK(history.now() == 10);
}
