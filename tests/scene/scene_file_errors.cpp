// Each bad input that we know of, and the exact line that its author reads.
#include "scene/files.hpp"
#include "scene/scene_file.hpp"

using namespace glassbox;
using glassbox::test::complaint;
using glassbox::test::Folder;

namespace {

std::string complaint_about(std::string_view toml) {
    const Folder folder;
    const auto file = folder.write("a.toml", toml);
    return complaint(folder, [&] { read_scene(file); });
}

/// Returns the complaint about a value of one key, without the value's place: that must be line 2, after "key = ".
std::string about(const std::string& section, const std::string& key, const std::string& value) {
    std::string message = complaint_about(section + "\n" + key + " = " + value + "\n");
    const std::string where = "a.toml:2:" + std::to_string(key.size() + 4) + ": error: ";
    return message.starts_with(where) ? message.substr(where.size()) : message;
}

std::string about_sphere(const std::string& key, const std::string& value) {
    std::string others;
    if (key != "center") others += "center = [0, 0, 0]\n";
    if (key != "radius") others += "radius = 1\n";
    return complaint_about("[[sphere]]\n" + key + " = " + value + "\n" + others);
}

}  // namespace

TEST_CASE("Files that cannot be read") {
    const Folder folder;
    const auto read = [&](const std::string& name) {
        return complaint(folder, [&] { read_scene(folder.path() / name); });
    };
    CHECK(read("nowhere.toml") == "nowhere.toml: error: there is no such file");
    std::filesystem::create_directory(folder.path() / "folder.toml");
    CHECK(read("folder.toml") == "folder.toml: error: it is a directory, not a file");
    folder.write("picture.toml", std::string_view("\x89PNG\r\n\x1a\n\0\0", 10));
    CHECK(read("picture.toml") == "picture.toml: error: this is a binary file; it must be a text file");
    // The byte 0xFC, ü in Latin-1, is the 11th of line 2.
    folder.write("latin.toml", "# a\ntitle = \"a\xFC\"\n");
    CHECK(read("latin.toml") == "latin.toml:2:11: error: this is not UTF-8; a scene must be a text file in UTF-8");
    folder.write("secret.toml", "");
    std::filesystem::permissions(folder.path() / "secret.toml", std::filesystem::perms::none);
    if (!std::ifstream(folder.path() / "secret.toml"))  // root reads everything
        CHECK(read("secret.toml") == "secret.toml: error: it cannot be read: Permission denied");
}

TEST_CASE("A file is called what the user called it") {
    CHECK_THROWS_WITH_AS(read_scene("./no/../such.toml"), "./no/../such.toml: error: there is no such file", Error);
}

TEST_CASE("What is not TOML") {
    // The words after these are toml++'s own.
    const std::string not_toml = " error: this is not TOML: while parsing ";
    CHECK(complaint_about("[image]\nwidth = \n").starts_with("a.toml:2:9:" + not_toml));
    CHECK(complaint_about("title = \"open\n").starts_with("a.toml:1:14:" + not_toml));
    CHECK(complaint_about("[image]\nwidth = 1\nwidth = 2\n").starts_with("a.toml:3:9:" + not_toml));
    CHECK(complaint_about("[image]\nwidth = 1\n[image]\nheight = 1\n").starts_with("a.toml:3:1:" + not_toml));
    CHECK(complaint_about("light.intensity = 1e999\n").starts_with("a.toml:1:"));
    // Deeper than any parser should follow: the column is that of the 101st level, after "a = " or in "a.a.a…".
    const std::string too_deep =
        " error: tables and arrays are nested more than 100 levels deep here; a scene has a few, and dotted keys and "
        "brackets must make 100 at most";
    CHECK(complaint_about("a = " + std::string(100000, '[')) == "a.toml:1:104:" + too_deep);
    std::string dotted = "a";
    for (int k = 0; k < 40000; ++k) dotted += ".b";
    CHECK(complaint_about(dotted + " = 1\n").ends_with(too_deep));
    CHECK(complaint_about("[" + dotted + "]\n").ends_with(too_deep));
    CHECK(complaint_about("x = {" + dotted + " = 1}\n").ends_with(too_deep));
}

TEST_CASE("Numbers that do not fit are told so, at the number") {
    const std::string large =
        " is too large; a number must lie between -1.7976931348623157e308 and 1.7976931348623157e308";
    const std::string whole =
        " is too large for a whole number, which must lie between -9223372036854775808 and 9223372036854775807; others "
        "have a point or an exponent, like 1e20";
    CHECK(about("[light]", "intensity", "1e400") == "'1e400'" + large);
    CHECK(about("[light]", "intensity", "-1_0.5e+999 # bright") == "'-1_0.5e+999'" + large);
    CHECK(about("[image]", "width", "12345678901234567890") == "'12345678901234567890'" + whole);
    CHECK(about("[image]", "width", "-9223372036854775809") == "'-9223372036854775809'" + whole);
    CHECK(about("[image]", "width", "0xfffffffffffffffff") == "'0xfffffffffffffffff'" + whole);
    // "background = [" has 14 characters, and "0, " 3.
    CHECK(complaint_about("[image]\nbackground = [0, 99999999999999999999]\n") ==
          "a.toml:2:18: error: '99999999999999999999'" + whole);
    // The column counts characters, not bytes.
    CHECK(complaint_about("\"ü\" = 1e400\n") == "a.toml:1:7: error: '1e400'" + large);
    CHECK(about("[image]", "width", std::string(200, '1')) ==
          "this number has too many digits; a double has 17: write it shorter, like 1.25e-30");
}

TEST_CASE("A scene whose lines end in carriage returns alone, with a byte order mark") {
    CHECK(complaint_about("\xEF\xBB\xBF[image]\rwidth = 0\r") ==
          "a.toml:2:9: error: width is 0; it must be a whole number from 1 to 32768");
}

TEST_CASE("Every message is one line") {
    for (const auto* bad : {"a = ", "[", "[[", "]", "=", "\"\n", "'''", "a.b.c", "a = [1,\n2", "a = 1 b = 2", "\x01"}) {
        const std::string message = complaint_about(bad);
        CHECK(message.starts_with("a.toml:"));
        CHECK(message.find('\n') == std::string::npos);
    }
}

TEST_CASE("Unknown keys and sections, with the nearest known name") {
    CHECK(complaint_about("[[sphere]]\nradus = 3\n") ==
          "a.toml:2:1: error: unknown key 'radus' in [[sphere]]; did you mean 'radius'?");
    CHECK(complaint_about("[[sphere]]\n  centre = [1, 2, 3]\n") ==
          "a.toml:2:3: error: unknown key 'centre' in [[sphere]]; did you mean 'center'?");
    CHECK(complaint_about("[[sphere]]\nzzz = 3\n") ==
          "a.toml:2:1: error: unknown key 'zzz' in [[sphere]]; it must be one of 'center', 'radius', 'color'");
    CHECK(complaint_about("titel = 'a'\n") ==
          "a.toml:1:1: error: unknown key 'titel' in the scene; did you mean 'title'?");
    CHECK(complaint_about("[ligth]\n") ==
          "a.toml:1:2: error: unknown section 'ligth' in the scene; did you mean 'light'?");
    CHECK(complaint_about("[[spheres]]\n") ==
          "a.toml:1:3: error: unknown section 'spheres' in the scene; did you mean 'sphere'?");
    CHECK(complaint_about("[image]\nhieght = 1\n") ==
          "a.toml:2:1: error: unknown key 'hieght' in [image]; did you mean 'height'?");
    CHECK(complaint_about("[view]\nlookat = 1\n") ==
          "a.toml:2:1: error: unknown key 'lookat' in [view]; did you mean 'look_at'?");
    CHECK(complaint_about("[light]\nintesity = 1\n") ==
          "a.toml:2:1: error: unknown key 'intesity' in [light]; did you mean 'intensity'?");
    CHECK(complaint_about("[shading]\nambient_colour = 1\n") ==
          "a.toml:2:1: error: unknown key 'ambient_colour' in [shading]; did you mean 'ambient_color'?");
    CHECK(complaint_about("[[triangle]]\nvertexes = 1\n") ==
          "a.toml:2:1: error: unknown key 'vertexes' in [[triangle]]; did you mean 'vertices'?");
    CHECK(complaint_about("[failing]\nscaler = 'float'\n") ==
          "a.toml:2:1: error: unknown key 'scaler' in [failing]; did you mean 'scalar'?");
    CHECK(complaint_about("[failing]\nlight = '1,2,3'\n") ==
          "a.toml:2:1: error: unknown key 'light' in [failing]; it must be one of 'scalar', 'triangle', 'sphere', "
          "'turn', "
          "'accumulated'");
    CHECK(complaint_about("[[mesh]]\nfiel = 1\n") ==
          "a.toml:2:1: error: unknown key 'fiel' in [[mesh]]; did you mean 'file'?");
}

TEST_CASE("What fails is told as an option's value is typed, in quotes") {
    CHECK(about("[failing]", "scalar", "1") == "scalar must be a string, in quotes, not a number");
    CHECK(about("[failing]", "triangle", "['tolerance', 10]") == "triangle must be a string, in quotes, not an array");
    CHECK(about("[failing]", "turn", "10.5") == "turn must be a string, in quotes, not a number");
    CHECK(about("[failing]", "accumulated", "true") == "accumulated must be \"on\" or \"off\", in quotes");
    CHECK(complaint_about("failing = 'float'\n").starts_with("a.toml:1:11: error: failing "));
}

TEST_CASE("Of several unknown keys, the first in the file is told") {
    CHECK(complaint_about("[image]\nzebra = 1\nant = 1\n").starts_with("a.toml:2:1: error: unknown key 'zebra'"));
}

TEST_CASE("Sections of the wrong shape") {
    CHECK(complaint_about("[sphere]\nradius = 1\n") ==
          "a.toml:1:1: error: sphere must be written [[sphere]], once for each sphere; it is written [sphere] here");
    CHECK(complaint_about("\n[[image]]\n") ==
          "a.toml:2:1: error: image must be one section, [image]; it is written [[image]] here");
    CHECK(complaint_about("light = 3\n") == "a.toml:1:9: error: light must be a section, [light], not a number");
    CHECK(complaint_about("triangle = 'ABC'\n") ==
          "a.toml:1:12: error: triangle must be sections, [[triangle]], one for each triangle, not a string");
    CHECK(complaint_about("mesh = [1]\n") ==
          "a.toml:1:9: error: mesh must be sections, [[mesh]], one for each mesh, not a number");
}

TEST_CASE("Values of the wrong type") {
    CHECK(about("", "title", "3") == "title must be a string, in quotes, not a number");
    CHECK(about("[image]", "width", "'wide'") == "width must be a whole number from 1 to 32768, not a string");
    CHECK(about("[light]", "intensity", "true") == "intensity must be a number, not true or false");
    CHECK(about("[light]", "intensity", "[1]") == "intensity must be a number, not an array");
    CHECK(about("[light]", "intensity", "{ a = 1 }") == "intensity must be a number, not a table");
    CHECK(about("[light]", "intensity", "1979-05-27") == "intensity must be a number, not a date or time");
    CHECK(about("[light]", "position", "7") == "position must be three numbers, [x, y, z], not a number");
    CHECK(about("[view]", "kind", "2") == "kind must be a string, in quotes, not a number");
    CHECK(about("[image]", "border", "false") ==
          "border must be three whole numbers from 0 to 255, [red, green, blue], not true or false");
    CHECK(about_sphere("radius", "\"3\"") == "a.toml:2:10: error: radius must be a number, not a string");
    // [1, '2', 3]: the string is the second member.
    CHECK(about_sphere("center", "[1, '2', 3]") == "a.toml:2:14: error: center's y must be a number, not a string");
    CHECK(complaint_about("[[mesh]]\nfile = 1\n") ==
          "a.toml:2:8: error: file must be a string, in quotes, not a number");
}

TEST_CASE("The wrong number of members") {
    CHECK(about_sphere("center", "[1, 2]") ==
          "a.toml:2:10: error: center has 2 members; it must be three numbers, [x, y, z]");
    CHECK(about("[view]", "up", "[1]") == "up has 1 member; it must be three numbers, [x, y, z]");
    CHECK(about("[image]", "background", "[1, 2, 3, 4]") ==
          "background has 4 members; it must be three whole numbers from 0 to 255, [red, green, blue]");
    CHECK(about("[[triangle]]", "vertices", "[[1, 2, 3], [4, 5, 6]]") ==
          "vertices has 2 members; it must be three points, [[x, y, z], [x, y, z], [x, y, z]]");
    CHECK(complaint_about("[[triangle]]\nvertices = [[1, 2, 3], [4, 5], [7, 8, 9]]\n") ==
          "a.toml:2:24: error: vertex 2 has 2 members; it must be three numbers, [x, y, z]");
    CHECK(complaint_about("[[triangle]]\nvertices = [[1, 2, 3], [4, 5, 6], [7, 8, 'x']]\n") ==
          "a.toml:2:42: error: vertex 3's z must be a number, not a string");
}

TEST_CASE("Keys that must not be left out") {
    CHECK(complaint_about("\n[[sphere]]\nradius = 1\n") ==
          "a.toml:2:1: error: [[sphere]] has no center; it needs one, like center = [0, 0, 0]");
    CHECK(complaint_about("[[sphere]]\ncenter = [1, 2, 3]\n") ==
          "a.toml:1:1: error: [[sphere]] has no radius; it needs one, like radius = 50");
    CHECK(complaint_about("[[triangle]]\n") ==
          "a.toml:1:1: error: [[triangle]] has no vertices; it needs one, like vertices = [[0, 0, 0], [1, 0, 0], [0, "
          "1, 0]]");
    CHECK(complaint_about("[[mesh]]\n") ==
          "a.toml:1:1: error: [[mesh]] has no file; it needs one, like file = \"bunny.obj\"");
    CHECK(complaint_about("[view]\nkind = 'pinhole'\nlook_at = [1, 0, 0]\n") ==
          "a.toml:1:1: error: [view] has no eye; it needs one, like eye = [10, 0, 0]");
    CHECK(complaint_about("[view]\nkind = 'pinhole'\neye = [1, 0, 0]\n") ==
          "a.toml:1:1: error: [view] has no look_at; it needs one, like look_at = [0, 0, 0]");
}

TEST_CASE("Numbers out of range") {
    CHECK(about_sphere("radius", "-3") == "a.toml:2:10: error: radius is -3; it must be greater than 0");
    CHECK(about_sphere("radius", "0") == "a.toml:2:10: error: radius is 0; it must be greater than 0");
    CHECK(about_sphere("radius", "0.0") == "a.toml:2:10: error: radius is 0; it must be greater than 0");
    CHECK(about_sphere("radius", "nan") == "a.toml:2:10: error: radius is nan; it must be a finite number");
    CHECK(about_sphere("radius", "inf") == "a.toml:2:10: error: radius is inf; it must be a finite number");
    CHECK(about_sphere("radius", "-inf") == "a.toml:2:10: error: radius is -inf; it must be a finite number");
    CHECK(about_sphere("center", "[0, 0, nan]") == "a.toml:2:17: error: center's z is nan; it must be a finite number");
    CHECK(complaint_about("[[triangle]]\nvertices = [[inf, 2, 3], [4, 5, 6], [7, 8, 9]]\n") ==
          "a.toml:2:14: error: vertex 1's x is inf; it must be a finite number");
    CHECK(about("[light]", "intensity", "-1") == "intensity is -1; it must be 0 or more");
    for (const std::string key : {"ambient", "diffuse", "specular", "exponent"}) {
        CHECK(about("[shading]", key, "-0.5") == key + " is -0.5; it must be 0 or more");
        CHECK(about("[shading]", key, "nan") == key + " is nan; it must be a finite number");
    }
    CHECK(complaint_about("[view]\npivot = [0, inf, 0]\n") ==
          "a.toml:2:13: error: pivot's y is inf; it must be a finite number");
    CHECK(complaint_about("[view]\ncorner = [nan, 0, 0]\n") ==
          "a.toml:2:11: error: corner's x is nan; it must be a finite number");
}

TEST_CASE("Pictures of no size, of too large a size, of no whole size") {
    for (const std::string key : {"width", "height"}) {
        for (const std::string value : {"0", "-5", "32769", "500.5", "500.0", "9223372036854775807", "nan"})
            CHECK(about("[image]", key, value) == key + " is " + value + "; it must be a whole number from 1 to 32768");
    }
    // 2^14 × (2^14 + 1) = 2^28 + 2^14 pixels.
    CHECK(complaint_about("[image]\nwidth = 16384\nheight = 16385\n") ==
          "a.toml:2:9: error: width times height is 16384 times 16385, 268451840 pixels; it must be at most 268435456");
}

TEST_CASE("Colours") {
    CHECK(complaint_about("[image]\nbackground = [0, 300, 0]\n") ==
          "a.toml:2:18: error: background's green is 300; it must be a whole number from 0 to 255");
    CHECK(complaint_about("[image]\nborder = [0, 0, -1]\n") ==
          "a.toml:2:17: error: border's blue is -1; it must be a whole number from 0 to 255");
    // 0.5 of 255 is 127.5, rounded 128.
    CHECK(about_sphere("color", "[0.5, 0, 1.0]") ==
          "a.toml:2:10: error: color's red is 0.5; colours are whole numbers from 0 to 255: write 128");
    CHECK(about_sphere("color", "[1.0, 0, 0]") ==
          "a.toml:2:10: error: color's red is 1.0; colours are whole numbers from 0 to 255: write 255");
    CHECK(about_sphere("color", "[127.5, 0, 0]") ==
          "a.toml:2:10: error: color's red is 127.5; it must be a whole number from 0 to 255");
    CHECK(about_sphere("color", "[0, 0, nan]") ==
          "a.toml:2:16: error: color's blue is nan; it must be a whole number from 0 to 255");
    CHECK(about_sphere("color", "'red'") ==
          "a.toml:2:9: error: color must be three whole numbers from 0 to 255, [red, green, blue], not a string");
    CHECK(complaint_about("[shading]\nspecular_color = [256, 0, 0]\n") ==
          "a.toml:2:19: error: specular_color's red is 256; it must be a whole number from 0 to 255");
    CHECK(complaint_about("[shading]\nambient_color = [1, 0.25, 0]\n") ==
          "a.toml:2:21: error: ambient_color's green is 0.25; colours are whole numbers from 0 to 255: write 64");
}

TEST_CASE("Directions that are none") {
    CHECK(about("[light]", "position", "[0, 0, 0]") == "position is 0 in x, y and z; it must have a direction");
    for (const std::string key : {"right", "up", "direction"})
        CHECK(about("[view]", key, "[0, -0.0, 0]") == key + " is 0 in x, y and z; it must have a direction");
    CHECK(about("[light]", "position", "[1e200, 0, 0]") ==
          "position has the size 1e+200; its squares fit a double only from 1e-150 to 1e150");
    CHECK(about("[light]", "position", "[0, 1e-200, 0]") ==
          "position has the size 1e-200; its squares fit a double only from 1e-150 to 1e150");
}

TEST_CASE("A viewing plane must have two directions") {
    const std::string same =
        "right and up are parallel; they must span the viewing plane, like [0, 1, 0] and [0, 0, 1]";
    CHECK(about("[view]", "up", "[0, 3, 0]") == same);
    CHECK(about("[view]", "right", "[0, 0, -2]") == same);
    CHECK(complaint_about("[view]\nright = [0.1, 0.2, 0.3]\nup = [0.3, 0.6, 0.9]\n") == "a.toml:3:6: error: " + same);
    CHECK(about("[view]", "up", "[0, 1, 0.001]") == "no error");
}

TEST_CASE("Pinhole views that see nothing") {
    const std::string eye = "[view]\nkind = 'pinhole'\neye = [1, 2, 3]\n";
    CHECK(complaint_about(eye + "look_at = [1, 2, 3]\n") ==
          "a.toml:4:11: error: look_at is where the eye is; it must be another point");
    CHECK(complaint_about(eye + "look_at = [1, 2, -8]\n") ==
          "a.toml:4:11: error: look_at is right above or below the eye; then up, [0, 0, 1] by default, must be another "
          "direction");
    CHECK(
        complaint_about(eye + "look_at = [2, 3, 4]\nup = [0.1, 0.1, 0.1]\n") ==
        "a.toml:5:6: error: up is parallel to the way from eye to look_at; it must point to the picture's upper edge");
    CHECK(complaint_about(eye + "look_at = [1e300, 0, 0]\n") ==
          "a.toml:4:11: error: the way from eye to look_at has the size 1e+300; its squares fit a double only from "
          "1e-150 "
          "to 1e150");
    for (const std::string angle : {"0", "180", "-45", "360"})
        CHECK(complaint_about(eye + "look_at = [0, 0, 0]\nfield_of_view = " + angle + "\n") ==
              "a.toml:5:17: error: field_of_view is " + angle +
                  " degrees; it must be between 0 and 180, both excluded");
    // A step between 32768 rows is then tan(4.5e-9 degrees)/16384 = 4.8e-15 of the distance, some 20 units in the last
    // place.
    CHECK(
        complaint_about(eye + "look_at = [0, 0, 0]\nfield_of_view = 9e-9\n") ==
        "a.toml:5:17: error: field_of_view is 9e-09 degrees: the rays of neighbouring pixels cannot be told apart; it "
        "must be 1e-08 or more");
    CHECK(complaint_about(eye + "look_at = [0, 0, 0]\nfield_of_view = nan\n") ==
          "a.toml:5:17: error: field_of_view is nan; it must be a finite number");
}

TEST_CASE("Unknown kinds and models") {
    CHECK(about("[view]", "kind", "'paralel'") == "unknown kind of view 'paralel'; did you mean 'parallel'?");
    CHECK(about("[view]", "kind", "'fisheye'") ==
          "unknown kind of view 'fisheye'; it must be one of 'parallel', 'pinhole'");
    CHECK(about("[shading]", "model", "'blinn_phong'") ==
          "unknown shading model 'blinn_phong'; did you mean 'blinn-phong'?");
    CHECK(about("[shading]", "model", "'flat'") ==
          "unknown shading model 'flat'; it must be one of 'phong', 'blinn-phong', 'levental-2014'");
}

TEST_CASE("Keys of the other kind of view") {
    CHECK(complaint_about("[view]\nkind = 'parallel'\neye = [1, 2, 3]\n") ==
          "a.toml:3:1: error: eye belongs to a view of kind 'pinhole', and this one is of kind 'parallel'");
    CHECK(
        complaint_about("[view]\nfield_of_view = 50\n") ==
        "a.toml:2:1: error: field_of_view belongs to a view of kind 'pinhole', and this one is of kind 'parallel', the "
        "default");
    CHECK(complaint_about("[view]\nkind = 'pinhole'\ncorner = [1, 2, 3]\n") ==
          "a.toml:3:1: error: corner belongs to a view of kind 'parallel', and this one is of kind 'pinhole'");
}

TEST_CASE("Meshes that cannot be had") {
    const auto relative = " (file is relative to the scene file's folder)";
    CHECK(complaint_about("[[mesh]]\nfile = 'bunny.obj'\n") ==
          std::string("a.toml:2:8: error: cannot read the mesh 'bunny.obj': there is no such file") + relative);
    const Folder folder;
    std::filesystem::create_directory(folder.path() / "parts");
    const auto scene = folder.write("a.toml", "\n[[mesh]]\nfile = 'parts'\n");
    CHECK(complaint(folder, [&] { read_scene(scene); }) ==
          std::string("a.toml:3:8: error: cannot read the mesh 'parts': it is a directory, not a file") + relative);
    // An error inside the OBJ file is reported with a place there.
    folder.write("bad.obj", "v 0 0 0\nf 1 1 2\n");
    const auto other = folder.write("b.toml", "[[mesh]]\nfile = 'bad.obj'\n");
    CHECK(complaint(folder, [&] { read_scene(other); }) ==
          "bad.obj:2:7: error: there is no vertex 2: the file has 1 vertex");
}
