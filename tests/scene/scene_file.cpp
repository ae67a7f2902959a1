#include "scene/scene_file.hpp"

#include "scene/files.hpp"

using namespace glassbox;
using glassbox::test::Folder;

namespace {

Scene read(std::string_view toml) {
    const Folder folder;
    return read_scene(folder.write("scene.toml", toml));
}

const std::filesystem::path scenes = GLASSBOX_SCENES;

}  // namespace

TEST_CASE("An empty file is the paper's view of nothing") {
    const Scene scene = read("");
    CHECK(scene.title.empty());
    CHECK(scene.width == 500);
    CHECK(scene.height == 500);
    CHECK(scene.background == Rgb{0, 0, 0});
    CHECK_FALSE(scene.border);
    const auto& view = std::get<ParallelView>(scene.view);
    CHECK(view.corner == Vec3<double>{500, 0, 0});
    CHECK(view.right == Vec3<double>{0, 1, 0});
    CHECK(view.up == Vec3<double>{0, 0, 1});
    CHECK(view.direction == Vec3<double>{-1, 0, 0});
    CHECK(scene.pivot == Vec3<double>{0, 0, 0});
    CHECK(scene.light_vector == Vec3<double>{1000, 250, 250});
    CHECK(scene.light_intensity == 1);
    CHECK(scene.shading.model == ShadingModel::blinn_phong);
    CHECK(scene.shading.k_a == 0.2);
    CHECK(scene.shading.k_d == 1);
    CHECK(scene.shading.k_s == 0.2);
    CHECK(scene.shading.exponent == 15);
    CHECK(scene.shading.ambient_color == Vec3<double>{255, 102, 102});
    CHECK(scene.shading.specular_color == Vec3<double>{255, 255, 255});
    CHECK(scene.spheres.empty());
    CHECK(scene.triangles.empty());
    CHECK(scene.meshes.empty());
}

TEST_CASE("Every key is read, each with a value that is not its default") {
    const Folder folder;
    folder.write("roof.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const Scene scene = read_scene(folder.write("scene.toml", R"(title = "Everything"
[image]
width = 64
height = 48
background = [1, 2, 3]
border = [4, 5, 6]
[view]
kind = "parallel"
corner = [10, 11.5, 12]
right = [0, 0.5, 0]
up = [0, 0, 0.25]
direction = [-2, 0, 0]
pivot = [7, 8, 9]
[light]
position = [0, 0, 3]
intensity = 0.5
[shading]
model = "phong"
ambient = 0.125
ambient_color = [21, 22, 23]
diffuse = 0.5
specular = 2
specular_color = [24, 25, 26]
exponent = 0
[[sphere]]
center = [1, 2, 3]
radius = 4
color = [5, 6, 7]
[[triangle]]
vertices = [[1, 2, 3], [4, 5, 6], [7, 8, -9e3]]
color = [8, 9, 10]
[[mesh]]
file = "roof.obj"
color = [0, 128, 255]
)"));
    CHECK(scene.title == "Everything");
    CHECK(scene.width == 64);
    CHECK(scene.height == 48);
    CHECK(scene.background == Rgb{1, 2, 3});
    CHECK(scene.border == Rgb{4, 5, 6});
    const auto& view = std::get<ParallelView>(scene.view);
    CHECK(view.corner == Vec3<double>{10, 11.5, 12});
    CHECK(view.right == Vec3<double>{0, 0.5, 0});
    CHECK(view.up == Vec3<double>{0, 0, 0.25});
    CHECK(view.direction == Vec3<double>{-2, 0, 0});
    CHECK(scene.pivot == Vec3<double>{7, 8, 9});
    CHECK(scene.light_vector == Vec3<double>{0, 0, 3});
    CHECK(scene.light_intensity == 0.5);
    CHECK(scene.shading.model == ShadingModel::phong);
    CHECK(scene.shading.k_a == 0.125);
    CHECK(scene.shading.k_d == 0.5);
    CHECK(scene.shading.k_s == 2);
    CHECK(scene.shading.exponent == 0);
    CHECK(scene.shading.ambient_color == Vec3<double>{21, 22, 23});
    CHECK(scene.shading.specular_color == Vec3<double>{24, 25, 26});
    REQUIRE(scene.spheres.size() == 1);
    CHECK(scene.spheres[0].center == Vec3<double>{1, 2, 3});
    CHECK(scene.spheres[0].radius == 4);
    CHECK(scene.spheres[0].color == Rgb{5, 6, 7});
    REQUIRE(scene.triangles.size() == 1);
    CHECK(scene.triangles[0].vertices[0] == Vec3<double>{1, 2, 3});
    CHECK(scene.triangles[0].vertices[2] == Vec3<double>{7, 8, -9000});
    CHECK(scene.triangles[0].color == Rgb{8, 9, 10});
    REQUIRE(scene.meshes.size() == 1);
    CHECK(scene.meshes[0]->vertices.size() == 3);
    CHECK(scene.meshes[0]->faces.size() == 1);
    CHECK(scene.meshes[0]->color == Rgb{0, 128, 255});
}

TEST_CASE("A pinhole view: all its keys, and what is left out") {
    const Scene all = read(R"([view]
kind = "pinhole"
eye = [1, 2, 3]
look_at = [4, 5, 6]
up = [0, 1, 0]
field_of_view = 60.5
pivot = [4, 5, 6]
)");
    const auto& view = std::get<PinholeView>(all.view);
    CHECK(view.eye == Vec3<double>{1, 2, 3});
    CHECK(view.look_at == Vec3<double>{4, 5, 6});
    CHECK(view.up == Vec3<double>{0, 1, 0});
    CHECK(view.field_of_view == 60.5);
    CHECK(all.pivot == Vec3<double>{4, 5, 6});

    const Scene least = read("view = { kind = 'pinhole', eye = [9, 0, 0], look_at = [0, 0, 0] }");
    CHECK(std::get<PinholeView>(least.view).up == Vec3<double>{0, 0, 1});
    CHECK(std::get<PinholeView>(least.view).field_of_view == 45);
}

TEST_CASE("Surfaces without a colour are light grey") {
    const Folder folder;
    folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const Scene scene = read_scene(folder.write("scene.toml",
                                                "[[sphere]]\ncenter = [0, 0, 0]\nradius = 1\n"
                                                "[[triangle]]\nvertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]\n"
                                                "[[mesh]]\nfile = 'a.obj'\n"));
    CHECK(scene.spheres.at(0).color == Rgb{200, 200, 200});
    CHECK(scene.triangles.at(0).color == Rgb{200, 200, 200});
    CHECK(scene.meshes.at(0)->color == Rgb{200, 200, 200});
}

TEST_CASE("Surfaces keep their order in the file, whatever stands between them") {
    const Scene scene = read(R"([[sphere]]
center = [1, 0, 0]
radius = 1
[[triangle]]
vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
[[sphere]]
center = [2, 0, 0]
radius = 1
[[sphere]]
center = [3, 0, 0]
radius = 1
)");
    REQUIRE(scene.spheres.size() == 3);
    for (std::size_t k = 0; k < 3; ++k) CHECK(scene.spheres[k].center.x == static_cast<double>(k + 1));
}

TEST_CASE("A mesh's file is looked for beside the scene file, wherever that is; an absolute path stays") {
    const Folder folder;
    std::filesystem::create_directory(folder.path() / "meshes");
    const auto obj = folder.write("meshes/a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    CHECK(read_scene(folder.write("near.toml", "[[mesh]]\nfile = 'meshes/a.obj'")).meshes.size() == 1);
    CHECK(read_scene(folder.write("far.toml", "[[mesh]]\nfile = '" + obj.string() + "'")).meshes.size() == 1);
}

TEST_CASE("All models and kinds have a name") {
    CHECK(read("shading.model = 'blinn-phong'").shading.model == ShadingModel::blinn_phong);
    CHECK(read("shading.model = 'levental-2014'").shading.model == ShadingModel::levental_2014);
    CHECK(std::holds_alternative<ParallelView>(read("view.kind = 'parallel'").view));
}

TEST_CASE("A byte order mark, CRLF, comments and other languages are no trouble") {
    const Scene scene =
        read("\xEF\xBB\xBF# Ein Kommentar\r\ntitle = \"Grün und 日本\"\r\n[image] # so\r\nwidth = 1_000\r\n");
    CHECK(scene.title == "Grün und 日本");
    CHECK(scene.width == 1000);
}

TEST_CASE("The largest pictures that are allowed") {
    CHECK(read("image.width = 32768\nimage.height = 8192").width == 32768);  // 2^15 × 2^13 = 2^28 pixels
    CHECK(read("image.width = 1\nimage.height = 1").height == 1);
}

TEST_CASE("Every scene that comes with Glassbox can be read, and opens with a line on what it shows") {
    int read = 0;
    for (const auto& entry : std::filesystem::directory_iterator(scenes)) {
        if (entry.path().extension() != ".toml") continue;
        CAPTURE(entry.path().string());
        const Scene scene = read_scene(entry.path());
        CHECK_FALSE(scene.title.empty());
        CHECK(scene.spheres.size() + scene.triangles.size() + scene.meshes.size() > 0);
        std::string first;
        std::getline(std::ifstream(entry.path()) >> std::ws, first);
        CHECK(first.starts_with("# "));
        ++read;
    }
    CHECK(read >= 6);
}

TEST_CASE("The paper's scene is the paper's") {
    const Scene scene = read_scene(scenes / "levental-2014.toml");
    const Vec3<double> P{200, 350, 100}, Q{200, 400, 100}, R{200, 375, 150}, S{250, 375, 100};
    using Corners = std::array<Vec3<double>, 3>;
    REQUIRE(scene.spheres.size() == 2);
    CHECK(scene.spheres[0].center == Vec3<double>{100, 350, 350});
    CHECK(scene.spheres[0].radius == 50);
    CHECK(scene.spheres[0].color == Rgb{0, 255, 0});
    CHECK(scene.spheres[1].center == Vec3<double>{50, 300, 300});
    CHECK(scene.spheres[1].radius == 20);
    CHECK(scene.spheres[1].color == Rgb{255, 0, 0});
    REQUIRE(scene.triangles.size() == 4);
    CHECK(scene.triangles[0].vertices == Corners{P, Q, R});
    CHECK(scene.triangles[1].vertices == Corners{P, Q, S});
    CHECK(scene.triangles[2].vertices == Corners{P, S, R});
    CHECK(scene.triangles[3].vertices == Corners{Q, R, S});
    for (const auto& triangle : scene.triangles) CHECK(triangle.color == Rgb{128, 128, 128});
    CHECK(scene.shading.model == ShadingModel::levental_2014);
    CHECK(scene.border == Rgb{255, 0, 0});
}

TEST_CASE("In the fan, all triangles share one corner, and each shares an edge with the next") {
    const Scene scene = read_scene(scenes / "fan.toml");
    REQUIRE(scene.triangles.size() == 24);
    for (std::size_t k = 0; k < 24; ++k) {
        CHECK(scene.triangles[k].vertices[0] == Vec3<double>{0, 250, 250});
        CHECK(scene.triangles[k].vertices[2] == scene.triangles[(k + 1) % 24].vertices[1]);
    }
}
