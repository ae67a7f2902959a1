#include "scene/obj_file.hpp"

#include "scene/files.hpp"

using namespace glassbox;
using glassbox::test::complaint;
using glassbox::test::Folder;

namespace {

using Faces = std::vector<std::array<std::uint32_t, 3>>;

Mesh read(std::string_view obj) {
    const Folder folder;
    return read_obj(folder.write("a.obj", obj), {1, 2, 3});
}

std::string complaint_about(std::string_view obj) {
    const Folder folder;
    const auto file = folder.write("a.obj", obj);
    return complaint(folder, [&] { read_obj(file, {}); });
}

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

}  // namespace

TEST_CASE("Vertices, a face, a colour") {
    const Mesh mesh = read("# one triangle\nv 0 0 0\nv 1.5 0 -2e3\nv 0 +1 .5\n\nf 1 2 3\n");
    CHECK(mesh.vertices == std::vector<Vec3<double>>{{0, 0, 0}, {1.5, 0, -2000}, {0, 1, 0.5}});
    CHECK(mesh.faces == Faces{{0, 1, 2}});
    CHECK(mesh.color == Rgb{1, 2, 3});
}

TEST_CASE("All four ways to write a corner") {
    CHECK(read(square + "vt 0 0\nvn 0 0 1\nf 1 2 3\nf 1/1 2/1 3/1\nf 1//1 2//1 3//1\nf 1/1/1 2/1/1 3/1/1\n").faces ==
          Faces{{0, 1, 2}, {0, 1, 2}, {0, 1, 2}, {0, 1, 2}});
}

TEST_CASE("Negative numbers count back from the face, not from the file's end") {
    // When the face is read there are 3 vertices: -3 is the first.
    CHECK(read("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 5 5\nf -1 1 -2\n").faces == Faces{{0, 1, 2}, {3, 0, 2}});
}

TEST_CASE("A face may name a vertex that comes later") {
    CHECK(read("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n").faces == Faces{{0, 1, 2}});
}

TEST_CASE("Faces keep file order across groups, objects and materials, whose files need not exist") {
    CHECK(read("mtllib none.mtl\no one\n" + square +
               "g a\nusemtl red\nf 1 2 3\no two\ng b\nusemtl blue\ns 1\nf 2 3 4\ng a\nusemtl red\nf 3 4 1\n")
              .faces == Faces{{0, 1, 2}, {1, 2, 3}, {2, 3, 0}});
}

TEST_CASE("A square is a fan of two; a dart is cut at its inner corner") {
    CHECK(read(square + "f 1 2 3 4\n").faces == Faces{{0, 1, 2}, {0, 2, 3}});
    // Corner 2 (0-based 1) of this dart is the notch, so no triangle may have it as its tip: not 0,1,2.
    CHECK(read("v 0 0 0\nv 1 1 0\nv 0 3 0\nv -1 1 0\nf 1 2 3 4\n").faces.size() == 2);
    CHECK(read("v 0 2 0\nv 0 1 0\nv 2 0 0\nv 3 3 0\nf 4 1 2 3\n").faces == Faces{{3, 0, 1}, {3, 1, 2}});
}

TEST_CASE("Coordinates are the nearest doubles") {
    // These three come out one unit off in a parser that sums digits times powers of ten.
    const Mesh mesh =
        read("v 0.3 1e-5 179.7\nv 0.1 2.2250738585072011e-308 5e-324\nv 1e-400 1 1.7976931348623157e308\nf 1 2 3");
    CHECK(mesh.vertices[0] == Vec3<double>{0.3, 1e-5, 179.7});
    CHECK(mesh.vertices[1] == Vec3<double>{0.1, 2.2250738585072011e-308, 5e-324});
    CHECK(mesh.vertices[2] == Vec3<double>{0, 1, 1.7976931348623157e308});
}

TEST_CASE("Weights and colours after x y z, comments, tabs, CRLF, a byte order mark, and lines joined by a backslash") {
    const Faces one{{0, 1, 2}};
    CHECK(read("v 0 0 0 1.0\nv 1 0 0 0.5 0.5 0.5\nv 0 1 0 # third\nf 1 2 3 # all of them\n").faces == one);
    CHECK(read("\xEF\xBB\xBFv 0 0 0\r\nv\t1 0\t0\r\n  v 0 1 0\r\nf 1 2 3\r\n").faces == one);
    CHECK(read("v 0 0 0\nv 1 0 \\\n0\nv 0 1 0\nf 1 \\\r\n2 3").faces == one);
    // A comment's backslash joins nothing.
    CHECK(read("# C:\\models\\\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").faces == one);
}

TEST_CASE("Lines that end in carriage returns alone, and their numbers") {
    CHECK(read("v 0 0 0\rv 1 0 0 # second\rv 0 1 0\rf 1 2 \\\r3\r").faces == Faces{{0, 1, 2}});
    CHECK(complaint_about("v 0 0 0\r\rv 1 x 0\r") == "a.obj:3:5: error: 'x' is not a number");
}

TEST_CASE("Faces in the old spelling, fo") {
    CHECK(read(square + "fo 1 2 3\nf 2 3 4\nfo 1//1 2//1 3//1 4//1\n").faces ==
          Faces{{0, 1, 2}, {1, 2, 3}, {0, 1, 2}, {0, 2, 3}});
    CHECK(complaint_about(square + "fo 1 2\n") ==
          "a.obj:5:1: error: a face must have at least three corners; this one has 2");
}

TEST_CASE("Surfaces that would be missing are refused; points, lines and what only describes are passed over") {
    CHECK(complaint_about(square + "f 1 2 3\nsurf 0 1 0 1 1 2 3 4\n") ==
          "a.obj:6:1: error: 'surf' is a free-form surface; a mesh must be made of flat faces, f: let the program that "
          "wrote the file cut it into polygons");
    CHECK(complaint_about("call other.obj\n") ==
          "a.obj:1:1: error: 'call' takes surfaces from elsewhere; all of a mesh must be in its file");
    CHECK(complaint_about(square + "F 1 2 3\n") ==
          "a.obj:5:1: error: 'F' must be written in small letters: v for a vertex, f for a face");
    CHECK(read(square + "vt 0 0\nvn 0 0 1\nvp 1\np 1 2\nl 1 2 3\ncurv 0 1 1 2\nbevel on\nlod 1\nmg 1 2\nf 1 2 3\n")
              .faces == Faces{{0, 1, 2}});
}

TEST_CASE("A polygon without area brings no triangle; the file is no worse for it") {
    CHECK(read(square + "f 1 2 1 2\nf 1 2 3\n").faces == Faces{{0, 1, 2}});
    CHECK(complaint_about(square + "f 1 2 1 2\n") ==
          "a.obj: error: no face has an area; there must be one whose corners do not all lie on a line");
    CHECK(read("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n").faces == Faces{{0, 1, 2}});  // a triangle stays as it is
}

TEST_CASE("Vertices that do not exist") {
    CHECK(complaint_about(square + "f 1 2 5\n") == "a.obj:5:7: error: there is no vertex 5: the file has 4 vertices");
    CHECK(complaint_about(square + "f 1 2 3\nf 1 0 3\n") ==
          "a.obj:6:5: error: there is no vertex 0; vertices are numbered from 1");
    CHECK(complaint_about(square + "f 1 2 -5\n") ==
          "a.obj:5:7: error: there is no vertex -5: only 4 vertices come before this face");
    CHECK(complaint_about("v 0 0 0\nf -1 -2 -3\nv 0 0 1\nv 0 1 0\n") ==
          "a.obj:2:6: error: there is no vertex -2: only 1 vertex comes before this face");
    CHECK(complaint_about("f 1 2 3\n") == "a.obj:1:3: error: there is no vertex 1: the file has 0 vertices");
    CHECK(complaint_about(square + "f 1 2 99999999999999999999\n") ==
          "a.obj:5:7: error: there is no vertex 99999999999999999999: the file has 4 vertices");
    CHECK(complaint_about(square + "f 1 2 -99999999999999999999\n") ==
          "a.obj:5:7: error: there is no vertex -99999999999999999999: only 4 vertices come before this face");
    CHECK(complaint_about(square + "f 1 2 -9223372036854775808\n") ==
          "a.obj:5:7: error: there is no vertex -9223372036854775808: only 4 vertices come before this face");
    CHECK(complaint_about(square + "f 1 2 4294967297\n") ==
          "a.obj:5:7: error: there is no vertex 4294967297: the file has 4 vertices");
}

TEST_CASE("Corners that are no numbers") {
    const std::string remedy = " is not a face's corner; it must be a vertex's number, like 7, 7/1, 7//3 or 7/1/3";
    CHECK(complaint_about(square + "f 1 two 3\n") == "a.obj:5:5: error: 'two'" + remedy);
    CHECK(complaint_about(square + "f 1 2.5 3\n") == "a.obj:5:5: error: '2.5'" + remedy);
    CHECK(complaint_about(square + "f 1 /2 3\n") == "a.obj:5:5: error: '/2'" + remedy);
    CHECK(complaint_about(square + "f 1 - 3\n") == "a.obj:5:5: error: '-'" + remedy);
}

TEST_CASE("Faces with too few corners") {
    CHECK(complaint_about(square + "f 1 2\n") ==
          "a.obj:5:1: error: a face must have at least three corners; this one has 2");
    CHECK(complaint_about(square + " f\n") ==
          "a.obj:5:2: error: a face must have at least three corners; this one has 0");
}

TEST_CASE("Vertices that are no points") {
    CHECK(complaint_about("v 0 zero 0\n") == "a.obj:1:5: error: 'zero' is not a number");
    CHECK(complaint_about("v 0 0 0\nv 0 1.5x 0\n") == "a.obj:2:5: error: '1.5x' is not a number");
    CHECK(complaint_about("v 0,5 0 0\n") == "a.obj:1:3: error: '0,5' is not a number");
    CHECK(complaint_about("v +-1 0 0\n") == "a.obj:1:3: error: '+-1' is not a number");
    CHECK(complaint_about("v 0 0 nan\n") == "a.obj:1:7: error: 'nan' is not a finite number");
    CHECK(complaint_about("v -inf 0 0\n") == "a.obj:1:3: error: '-inf' is not a finite number");
    CHECK(complaint_about("v 0 1e999 0\n") == "a.obj:1:5: error: '1e999' is not a finite number");
    CHECK(complaint_about("v 1 2\nv 0 0 0\n") ==
          "a.obj:1:6: error: a vertex must have three numbers, v x y z; this one has 2");
    CHECK(complaint_about("v\n") == "a.obj:1:2: error: a vertex must have three numbers, v x y z; this one has 0");
}

TEST_CASE("Files that are no OBJ") {
    const std::string none = "a.obj: error: there are no faces; an OBJ file must have lines like f 1 2 3";
    CHECK(complaint_about("") == none);
    CHECK(complaint_about(square) == none);
    CHECK(complaint_about("Dear diary,\n") == none);
    CHECK(complaint_about(std::string_view("v 0\0", 4)) ==
          "a.obj: error: this is a binary file; it must be a text file");
    const Folder folder;
    CHECK(complaint(folder, [&] { read_obj(folder.path() / "none.obj", {}); }) ==
          "none.obj: error: there is no such file");
}
