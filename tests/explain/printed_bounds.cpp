// Compares every ± that `explain` prints, in the text and in the JSON, for all shipped scenes in all scalars, with the
// truth. The truth is computed here, independently of the program: in binary floats of 2048 bits, side products, Δ and
// t from the formulas, the rest by repeating the JSON's steps. Products of three doubles of a scene's size need no more
// bits than that, so that a true 0 comes out as 0; quotients and roots are off by some 2^-2048 of themselves.
#include <doctest.h>

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <regex>
#include <sstream>

#include "explain/explain.hpp"
#include "explain/json.hpp"
#include "explain/text.hpp"
#include "render/option_names.hpp"
#include "scene/scene_file.hpp"

using namespace glassbox;

namespace {

using Json = nlohmann::json;
using Real = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<2048, boost::multiprecision::digit_base_2, void, std::int64_t>,
    boost::multiprecision::et_off>;
using Vector = std::array<Real, 3>;

/// What rounding may leave of a true 0 in 2048 bits, after steps that cancel and numbers of up to 1e100. Every bound of
/// doubles is far above it, or 0.
const Real dust = ldexp(Real(1), -1100);

Vector vector(const Json& v) { return {Real(v[0].get<double>()), Real(v[1].get<double>()), Real(v[2].get<double>())}; }
Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Real dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

using Truths = std::map<std::string, Real>;  // by their names in the text

/// Δ = (v·D)² − D²(v² − r²), t = (−v·D ± √Δ) / D².
Truths truths_of_sphere(const Vector& P, const Vector& D, const Json& sphere) {
    const Vector v = P - vector(sphere["center"]);
    const Real r(sphere["radius"].get<double>()), a = dot(D, D), b = dot(v, D);
    const Real discriminant = b * b - a * (dot(v, v) - r * r);
    Truths truths{{"Δ", discriminant}};
    if (discriminant < 0) return truths;
    truths["t₀"] = (-b - sqrt(discriminant)) / a;
    truths["t₁"] = (-b + sqrt(discriminant)) / a;
    return truths;
}

/// As seen from P: the edge BC's side product is D·(C × B), and so on; t = N·A / N·D with N = (B − A) × (C − A).
Truths truths_of_triangle(const Vector& P, const Vector& D, const Json& triangle) {
    const Json& vertices = triangle["vertices"];
    const Vector A = vector(vertices[0]) - P, B = vector(vertices[1]) - P, C = vector(vertices[2]) - P;
    const Vector N = cross(B - A, C - A);
    Truths truths{{"a", dot(D, cross(C, B))}, {"b", dot(D, cross(A, C))}, {"c", dot(D, cross(B, A))}};
    truths["a+b+c"] = truths["a"] + truths["b"] + truths["c"];
    if (dot(N, D) != 0) truths["t"] = dot(N, A) / dot(N, D);
    return truths;
}

Truths truths_of(const Json& story, const Json& surface) {
    const Vector P = vector(story["ray"]["P"]), D = vector(story["ray"]["D"]);
    return surface["kind"] == "sphere" ? truths_of_sphere(P, D, surface) : truths_of_triangle(P, D, surface);
}

/// The t where the ray meets the sphere first: t₀, or t₁ from inside.
Real true_t(const Truths& truths) {
    const auto t = truths.find("t");
    if (t != truths.end()) return t->second;
    return truths.at("t₀") > 0 ? truths.at("t₀") : truths.at("t₁");
}

std::optional<Real> done_again(const std::string& operation, const Real& a, const Real& b) {
    if (operation == "round") return a;
    if (operation == "+") return a + b;
    if (operation == "−") return a - b;
    if (operation == "×") return a * b;
    if (operation == "÷") return b == 0 ? std::nullopt : std::optional(Real(a / b));
    if (operation == "negate") return -a;
    if (operation == "abs") return abs(a);
    if (operation == "√") return a < 0 ? std::nullopt : std::optional(Real(sqrt(a)));
    if (operation == "pow") return a < 0 ? std::nullopt : std::optional(a == 0 && b > 0 ? Real(0) : Real(pow(a, b)));
    const Real gap = abs(a - b) <= dust ? Real(0) : a - b;
    if (operation == "<") return Real(gap < 0);
    if (operation == ">") return Real(gap > 0);
    if (operation == "≤") return Real(gap <= 0);
    if (operation == "≥") return Real(gap >= 0);
    if (operation == "=") return Real(gap == 0);
    if (operation == "≠") return Real(gap != 0);
    FAIL("no such operation: " << operation);
    return {};
}

Real from_hex(const Json& number) { return Real(std::strtold(number["hex"].get<std::string>().c_str(), nullptr)); }

struct Tally {
    int bounds = 0, lies = 0;
    int finite = 0, without_bits = 0;

    void found(bool holds, const std::string& what) {
        ++bounds;
        lies += !holds;
        CHECK_MESSAGE(holds, what);
    }
};

bool is_value(const Json& number) { return number["value"].is_number() && number["error"].is_number(); }

/// Checks a number of the JSON: value ± error, and what is said about its truth.
void check(const Json& number, const std::optional<Real>& truth, Tally& tally) {
    if (!truth || !is_value(number)) return;
    const Real value(number["value"].get<double>()), error(number["error"].get<double>());
    tally.found(abs(value - *truth) <= error + dust, number.dump());
    const bool is_open = number["known"] == "320 bits" && number["sign"] == 0;
    if (number["known"] == "unknown") return;
    ++tally.finite;
    if (is_open) {
        ++tally.without_bits;
        CHECK_MESSAGE(abs(*truth) < ldexp(Real(1), -200), number.dump());
        CHECK_MESSAGE(number["bits_lost"].is_null(), number.dump());
        CHECK_MESSAGE(number["true"] == 0, number.dump());
        return;
    }
    const int sign = abs(*truth) <= dust ? 0 : truth->sign();
    CHECK_MESSAGE(number["sign"] == sign, number.dump());
    CHECK_MESSAGE(abs(Real(number["true"].get<double>()) - *truth) <= abs(*truth) * 0x1p-52 + 0x1p-1074, number.dump());
}

/// Checks all steps of the hit; returns their truths by name.
Truths check_steps(const Json& hit, Tally& tally) {
    std::vector<std::optional<Real>> truths;
    Truths named;
    for (const Json& step : hit["steps"]) {
        const std::string operation = step["operation"].get<std::string>();
        const Json& operands = step["operands"];
        std::optional<Real> truth;
        if (operands.empty()) truth = from_hex(step);
        else {
            const auto& a = truths.at(operands.front().get<std::size_t>());
            const auto& b = truths.at(operands.back().get<std::size_t>());
            if (a && b) truth = done_again(operation, *a, *b);
        }
        truths.push_back(truth);
        if (truth) named.try_emplace(step["name"].get<std::string>(), *truth);
        const bool compares = step["known"] != "unknown" && operation.find_first_of("<>=") != std::string::npos;
        if (!compares) check(step, truth, tally);
        else if (truth) tally.found(step["error"] == 1 || Real(step["value"].get<double>()) == *truth, step.dump());
    }
    return named;
}

void check_surface(const Json& surface, const Truths& truths, Tally& tally) {
    const auto known = [&](const char* name) -> std::optional<Real> {
        const auto found = truths.find(name);
        return found == truths.end() ? std::nullopt : std::optional(found->second);
    };
    if (surface["t"].is_object() && (known("t") || known("t₀"))) check(surface["t"], true_t(truths), tally);
    if (surface["kind"] == "sphere") {
        for (const char* rule : {"textbook", "stable"}) {
            const Json& roots = surface[rule];
            check(roots["discriminant"], known("Δ"), tally);
            if (roots["t0"].is_object()) check(roots["t0"], known("t₀"), tally);
            if (roots["t1"].is_object()) check(roots["t1"], known("t₁"), tally);
        }
        return;
    }
    for (const char* side : {"a", "b", "c"}) check(surface["sides"][side], known(side), tally);
    check(surface["sum"], known("a+b+c"), tally);
    if (surface["weights"].is_object() && truths.at("a+b+c") != 0)
        for (const auto& [weight, side] : {std::pair{"A", "a"}, {"B", "b"}, {"C", "c"}})
            check(surface["weights"][weight], Real(truths.at(side) / truths.at("a+b+c")), tally);
}

/// A number of a text as programs read it.
std::string with_hyphen(const std::string& number) {
    const std::string minus = "−";
    return number.starts_with(minus) ? '-' + number.substr(minus.size()) : number;
}

/// Checks the text line by line: each number with its bound against the truth of that name.
void check_text(const std::string& text, std::map<std::size_t, Truths>& surfaces, const Truths& hit, Tally& tally) {
    const std::regex surface_row("^ +([0-9]+)  (sphere about|A =).*");
    const std::regex bounded("(\\S+) += (\\S+) (± (\\S+)|exact as a double|exact)");
    const std::regex any_bound("±|\\bexact\\b(?! arithmetic)");
    std::istringstream lines(text);
    const Truths* truths = nullptr;
    for (std::string line; std::getline(lines, line);) {
        CAPTURE(line);
        std::smatch match;
        if (line.starts_with("The "))
            truths = line.starts_with("The hit") || line.starts_with("The light") ? &hit : nullptr;
        else if (std::regex_match(line, match, surface_row)) truths = &surfaces.at(std::stoul(match[1]));
        if (line.starts_with("  computed")) continue;  // names of scalars
        auto left = std::distance(std::sregex_iterator(line.begin(), line.end(), any_bound), std::sregex_iterator());
        for (std::sregex_iterator found(line.begin(), line.end(), bounded); found != std::sregex_iterator(); ++found) {
            --left;
            const std::string name = (*found)[1], printed = with_hyphen((*found)[2]), its_bound = (*found)[3],
                              bound = (*found)[4];
            if (its_bound == "± unknown") continue;
            REQUIRE(truths != nullptr);
            REQUIRE(truths->contains(name));
            const Real& truth = truths->at(name);
            if (its_bound == "exact as a double")
                tally.found(abs(Real(std::strtod(printed.c_str(), nullptr)) - truth) <= dust, line);
            else tally.found(abs(Real(printed) - truth) <= (bound.empty() ? Real(0) : Real(bound)) + dust, line);
        }
        CHECK_MESSAGE(left == 0, line);
    }
}

void check_pixel(const Scene& scene, const Options& options, int x, int y, Tally& tally) {
    CAPTURE(x);
    CAPTURE(y);
    const Story story = explain(scene, options, x, y);
    const Json json = Json::parse(to_json(story));
    std::map<std::size_t, Truths> surfaces;
    for (const Json& surface : json["surfaces"]) {
        const Truths& truths = surfaces[surface["surface"].get<std::size_t>()] = truths_of(json, surface);
        check_surface(surface, truths, tally);
    }
    Truths hit;
    if (json["hit"].is_object()) {
        hit = check_steps(json["hit"], tally);
        hit["t"] = true_t(surfaces.at(json["hit"]["surface"].get<std::size_t>()));
        check(json["hit"]["t"], hit["t"], tally);
    }
    check_text(to_text(story), surfaces, hit, tally);
}

// The middle, half way to the corners, and odd offsets from these, in parts of the picture.
#ifdef GLASSBOX_SANITIZED
constexpr std::array<std::pair<double, double>, 2> places{{{.5, .5}, {.37, .66}}};  // checked code is slow
#else
constexpr std::array<std::pair<double, double>, 7> places{
    {{.5, .5}, {.25, .25}, {.75, .25}, {.25, .75}, {.75, .75}, {.52, .41}, {.37, .66}}};
#endif

}  // namespace

TEST_CASE("every bound printed for the shipped scenes holds, in every scalar") {
    Tally tally;
    int scenes = 0;
    for (const auto& entry : std::filesystem::directory_iterator(SCENES)) {
        if (entry.path().extension() != ".toml") continue;
        ++scenes;
        const std::string name = entry.path().filename().string();
        CAPTURE(name);
        const Scene scene = read_scene(entry.path());
        for (const Named<Scalar>& scalar : scalars) {
            CAPTURE(scalar.name);
            Options options;
            options.scalar = scalar.value;
            for (const auto& [x, y] : places)
                check_pixel(scene, options, static_cast<int>(x * scene.width), static_cast<int>(y * scene.height),
                            tally);
        }
    }
    MESSAGE(tally.bounds << " bounds, " << tally.lies << " lies, " << scenes << " scenes");
    CHECK(scenes >= 12);
    CHECK(tally.lies == 0);
    CHECK(tally.bounds > 1'500 * static_cast<int>(places.size()));
}

TEST_CASE("… turned, by other rules, and in Phong's own shading") {
    Tally tally;
    Scene scene = read_scene(SCENES "/levental-2014.toml");
    for (const Named<Scalar>& scalar : scalars) {
        CAPTURE(scalar.name);
        Options options;
        options.scalar = scalar.value;
        options.sphere_rule = Textbook{};
        options.turns = {{Axis::z, 10}, {Axis::y, -20}};
        for (const ShadingModel model : {ShadingModel::phong, ShadingModel::blinn_phong}) {
            scene.shading.model = model;
            for (const auto& [x, y] : {std::pair{250, 200}, {375, 385}, {350, 149}, {360, 379}, {310, 190}})
                check_pixel(scene, options, x, y, tally);
        }
    }
    CHECK(tally.lies == 0);
    CHECK(tally.bounds > 1'000);
}

// The ray of column 3 and row 6 starts at (9, −1, 2) and runs along (−1, 0, 0). The triangle's (B − A) × (C − A) is
// (2, 3, 1) × (4, 5, 3) = (4, −2, −2), so n = (2, −1, −1)/√6, and r = (1, 0, 0). The light is at (1000, 250, 250), so
// l = (4, 1, 1)/√18, and n·l = 6/√108 = 1/√3. m = 2(n·l)n − l = (4, −2, −2)/√18 − (4, 1, 1)/√18 = (0, −3, −3)/√18:
// r·m is 0, but its first component is a difference of roots of roots.
TEST_CASE("an irrational cancellation to 0 is not said to be another number, nor to have lost bits") {
    Scene scene;
    scene.width = scene.height = 9;
    scene.view = ParallelView{{9, -4, -4}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}};
    scene.light_vector = {1000, 250, 250};
    scene.shading.model = ShadingModel::phong;
    scene.triangles = {{{Vec3<double>{0, -4, 1}, {2, -1, 2}, {4, 1, 4}}, {200, 180, 160}}};
    for (const Named<Scalar>& scalar : scalars) {
        CAPTURE(scalar.name);
        Options options;
        options.scalar = scalar.value;
        Tally tally;
        check_pixel(scene, options, 3, 2, tally);
        CHECK(tally.lies == 0);
        CHECK(tally.without_bits > 0);
        const Story story = explain(scene, options, 3, 2);
        REQUIRE(story.hit);
        const story::Number& highlight = story.hit->shade->highlight;
        CHECK(highlight.known == Known::to_long_float);
        CHECK(highlight.sign == 0);
        CHECK(highlight.truth == 0);
        CHECK(std::isnan(highlight.bits_lost));
        CHECK(highlight.error < 1e-5);
        const std::string text = to_text(story);
        const std::size_t row = text.find("r·m = ");
        REQUIRE(row != std::string::npos);
        const std::string line = text.substr(row, text.find('\n', row) - row);
        CHECK_MESSAGE(line.find("truly 0, as far as 320 bits tell") != std::string::npos, line);
        CHECK_MESSAGE(line.find("lost") == std::string::npos, line);
    }
}
