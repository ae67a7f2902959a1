// The main() of a lesson's program when `glassbox learn picture` runs it: the lesson's own main() is renamed, and this
// one reports how it ends.
#include "learn/subprocess/last_words.hpp"

int lesson_main(int argc, char** argv);

int main(int argc, char** argv) {
    glassbox::learn::listen_for_the_end();
    const int status = lesson_main(argc, argv);
    glassbox::learn::work_is_done();
    return status;
}
