#include "output/whole_file.hpp"

#include <doctest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <string>

#include "output/folder.hpp"
#include "render/job.hpp"
#include "scene/error.hpp"

using namespace glassbox;
using namespace glassbox::test;
namespace fs = std::filesystem;

namespace {

std::string failure(const fs::path& path) {
    return message_of<Error>([&] { write_whole(path, bytes("new")); });
}

mode_t mode(const fs::path& path) {
    struct stat found {};
    ::stat(path.c_str(), &found);
    return found.st_mode & 07777;
}

/// Whether write_whole, as it was compiled, can make files without a name in that folder.
bool nameless_files([[maybe_unused]] const fs::path& folder) {
#ifdef GLASSBOX_NAMED_TEMPORARIES
    return false;
#else
    return can_make_nameless_files(folder);
#endif
}

}  // namespace

TEST_CASE("a file holds the bytes, and is alone in its folder") {
    const Folder folder;
    const std::string large(3'500'000, 'x');  // more than three chunks of a MiB
    write_whole(folder / "large", bytes(large));
    CHECK(content(folder / "large") == large);
    write_whole(folder / "large", bytes(""));
    CHECK(content(folder / "large") == "");
    CHECK(folder.entries() == 1);
}

TEST_CASE("pieces arrive in order, whatever their sizes") {
    const Folder folder;
    std::string expected;
    write_whole(folder / "pieces", [&](const Sink& sink) {
        for (const std::size_t size : {1u, 0u, 700'000u, 700'000u, 5u, 2'000'000u, 3u}) {
            const std::string piece(size, static_cast<char>('a' + expected.size() % 26));
            expected += piece;
            sink(bytes(piece));
        }
    });
    CHECK(content(folder / "pieces") == expected);
}

TEST_CASE("nobody sees a file that is half written") {
    const Folder folder;
    std::ptrdiff_t seen = -1;
    write_whole(folder / "file", [&](const Sink& sink) {
        sink(bytes(std::string(2 << 20, 'x')));
        seen = folder.entries();
    });
    // No entry where files without a name can be made: then not even SIGKILL leaves one. Else a hidden one.
    CHECK(seen == (nameless_files(folder.path) ? 0 : 1));
    CHECK(fs::file_size(folder / "file") == 2 << 20);
}

TEST_CASE("a new file has the mode that the umask leaves, an old one keeps its own") {
    const Folder folder;
    const mode_t before = ::umask(027);
    write_whole(folder / "new", bytes("new"));
    ::umask(before);
    CHECK(mode(folder / "new") == 0640);  // 0666 without 027

    fs::permissions(folder / "new", fs::perms(0604));
    write_whole(folder / "new", bytes("newer"));
    CHECK(mode(folder / "new") == 0604);
}

TEST_CASE("a symbolic link stays one, and what it points to is written") {
    const Folder folder;
    write_whole(folder / "target", bytes("old"));
    fs::create_symlink("target", folder / "link");
    write_whole(folder / "link", bytes("new"));
    CHECK(fs::is_symlink(folder / "link"));
    CHECK(content(folder / "target") == "new");

    fs::create_symlink("not-there-yet", folder / "dangling");
    write_whole(folder / "dangling", bytes("new"));
    CHECK(fs::is_symlink(folder / "dangling"));
    CHECK(content(folder / "not-there-yet") == "new");
    CHECK(folder.entries() == 4);
}

TEST_CASE("a device is written to, not replaced") {
    write_whole("/dev/null", bytes("gone"));
    CHECK(fs::is_character_file("/dev/null"));
    CHECK(is_device("/dev/null"));
    CHECK(is_device("/dev/stdout"));
    CHECK_FALSE(is_device("picture.png"));
}

TEST_CASE("a missing folder is named") {
    const Folder folder;
    const std::string out = (folder / "out").string();
    CHECK(failure(folder / "out" / "pic.png") ==
          out + "/pic.png: error: cannot write: No such file or directory; create the folder " + out +
              "/ first, or name another file");
    CHECK(folder.entries() == 0);
}

TEST_CASE("a folder is no file, and a file no folder") {
    const Folder folder;
    fs::create_directory(folder / "out");
    write_whole(folder / "file", bytes("old"));
    CHECK(failure(folder / "out") == (folder / "out").string() +
                                         ": error: cannot write: Is a directory; name a file in it, such as " +
                                         (folder / "out").string() + "/picture.png");
    CHECK(failure(folder / "file" / "pic.png") ==
          (folder / "file").string() + "/pic.png: error: cannot write: Not a directory; " + (folder / "file").string() +
              " is not a folder; name another file");
    CHECK(failure("").find("name a file, such as picture.png") != std::string::npos);
    CHECK(failure(folder / "nowhere/").find("name a file, such as picture.png") != std::string::npos);
    CHECK(failure(folder / "out/").find("Is a directory") != std::string::npos);
    CHECK(content(folder / "file") == "old");
    CHECK(folder.entries() == 2);
}

TEST_CASE("a name too long is said to be so") {
    const Folder folder;
    CHECK(failure(folder / std::string(300, 'n')).find("choose a shorter name") != std::string::npos);
    const std::string longest(255, 'n');  // what most file systems allow: the temporary's name may not be longer
    write_whole(folder / longest, bytes("new"));
    CHECK(content(folder / longest) == "new");
}

TEST_CASE("where writing is not allowed, nothing changes") {
    if (::geteuid() == 0) return;  // root may write everywhere
    const Folder folder;
    write_whole(folder / "file", bytes("old"));
    fs::permissions(folder / "file", fs::perms(0444));
    CHECK(failure(folder / "file").find("allow writing there") != std::string::npos);
    CHECK(content(folder / "file") == "old");
    fs::permissions(folder.path, fs::perms(0555));
    CHECK(failure(folder / "new").find("Permission denied") != std::string::npos);
    fs::permissions(folder.path, fs::perms(0755));
    CHECK(folder.entries() == 1);
}

TEST_CASE("a full disk is reported" * doctest::skip(!fs::exists("/dev/full"))) {
    CHECK(failure("/dev/full") ==
          "/dev/full: error: cannot write: No space left on device; free some space, or name a file on another disk");
}

TEST_CASE("a write that fails half way leaves the old file and no temporary") {
    const Folder folder;
    write_whole(folder / "file", bytes("old"));
    const std::string large(3 << 20, 'x');

    // A limit on the size of files stands in for a disk that fills up after the first MiB.
    rlimit before{};
    ::getrlimit(RLIMIT_FSIZE, &before);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit low{1 << 20, before.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &low);
    const std::string message = message_of<Error>([&] { write_whole(folder / "file", bytes(large)); });
    ::setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);

    CHECK(message == (folder / "file").string() +
                         ": error: cannot write: File too large; raise the limit on the size of files (ulimit -f), or "
                         "name a file on another disk");
    CHECK(content(folder / "file") == "old");
    CHECK(folder.entries() == 1);
}

TEST_CASE("work that fails or is stopped leaves the old file and no temporary") {
    const Folder folder;
    write_whole(folder / "file", bytes("old"));
    const auto give_up = [](const Sink& sink) {
        sink(bytes(std::string(2 << 20, 'x')));
        throw Error("the numbers ran out");
    };
    CHECK_THROWS_AS(write_whole(folder / "file", give_up), Error);

    std::stop_source source;
    const auto stopped = [&](const Sink& sink) {
        sink(bytes("some"));
        source.request_stop();
        sink(bytes("more"));
    };
    CHECK_THROWS_AS(write_whole(folder / "file", stopped, source.get_token()), Cancelled);
    CHECK_THROWS_AS(write_whole(folder / "file", bytes("new"), source.get_token()), Cancelled);
    CHECK(content(folder / "file") == "old");
    CHECK(folder.entries() == 1);
}

TEST_CASE("what would fail is known before the work") {
    const Folder folder;
    CHECK(message_of<Error>([&] { check_writable(folder / "out" / "pic.png"); }) ==
          failure(folder / "out" / "pic.png"));
    CHECK_THROWS_AS(check_writable(folder.path), Error);
    check_writable(folder / "pic.png");
    CHECK(folder.entries() == 0);
}
