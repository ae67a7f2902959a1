// The inspector's numbers are those of `glassbox explain --json`, digit for digit; and the positions of its error bars.
#include "viewer/model/story/inspector.hpp"

#include <doctest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "explain/explain.hpp"
#include "explain/json.hpp"
#include "scene/scene_file.hpp"
#include "viewer/model/story/error_bar.hpp"

using namespace glassbox;

namespace {

using Json = nlohmann::json;
using Texts = std::map<std::string, std::string>;

/// Reads JSON and keeps the digits of each number as they are written, by its JSON pointer.
class NumbersAsWritten : public nlohmann::json_sax<Json> {
public:
    Texts numbers;

    bool null() override { return found(nullptr); }
    bool boolean(bool) override { return found(nullptr); }
    bool number_integer(number_integer_t value) override { return found_text(std::to_string(value)); }
    bool number_unsigned(number_unsigned_t value) override { return found_text(std::to_string(value)); }
    bool number_float(number_float_t, const string_t& written) override {
        // 500.0 is a 500 that JSON marks as a float
        return found_text(written.ends_with(".0") ? written.substr(0, written.size() - 2) : written);
    }
    bool string(string_t& value) override {
        return value.starts_with("0x") || value.starts_with("-0x") ? found(&value) : found(nullptr);
    }
    bool binary(binary_t&) override { return false; }
    bool start_object(std::size_t) override { return begin(false); }
    bool start_array(std::size_t) override { return begin(true); }
    bool key(string_t& name) override {
        levels_.back().key = name;
        return true;
    }
    bool end_object() override { return end(); }
    bool end_array() override { return end(); }
    bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override { return false; }

private:
    struct Level {
        bool is_array = false;
        std::size_t index = 0;
        std::string key;
    };

    bool found_text(const std::string& text) { return found(&text); }
    bool found(const std::string* text) {
        std::string path;
        for (const Level& level : levels_) path += '/' + (level.is_array ? std::to_string(level.index) : level.key);
        if (text) numbers[path] = *text;
        return next();
    }
    bool next() {
        if (!levels_.empty()) ++levels_.back().index;
        return true;
    }
    bool begin(bool is_array) {
        levels_.push_back({is_array, 0, ""});
        return true;
    }
    bool end() {
        levels_.pop_back();
        return next();
    }
    std::vector<Level> levels_;
};

Texts numbers_of_json(const Story& story) {
    NumbersAsWritten reader;
    REQUIRE(Json::sax_parse(to_json(story), &reader));
    return reader.numbers;
}

/// As JSON writes it.
std::string with_hyphen(std::string number) {
    const std::string minus = "−";
    return number.starts_with(minus) && number != "−∞" ? '-' + number.substr(minus.size()) : number;
}

/// Collects all numbers of the parts, with all that is shown of each, by their JSON pointers; one may be shown twice.
void gather(const std::vector<InspectorPart>& parts, Texts& into) {
    const auto add = [&](const InspectedNumber& number) {
        for (const NumberFact& fact : facts(number)) {
            if (fact.path.empty() || fact.path.ends_with("/known")) continue;  // words
            const auto [at, is_new] = into.emplace(fact.path, with_hyphen(fact.text));
            if (!is_new) CHECK(at->second == with_hyphen(fact.text));
        }
        // The row shows what its facts say.
        CHECK(written(number, NumberForm::full) == facts(number).front().text);
    };
    for (const InspectorPart& part : parts) {
        if (part.number) add(*part.number);
        for (const InspectorRow& row : part.rows)
            for (const InspectedNumber& number : row.numbers) add(number);
        gather(part.parts, into);
    }
}

/// What the inspector does not claim to show: the steps, which have a page of their own, and what it shows elsewhere.
bool is_claimed(const std::string& path, const std::string& worst) {
    if (path.starts_with("/hit/steps/"))
        return !worst.empty() && path.starts_with(worst + "/") && path != worst + "/step" && path != worst + "/line" &&
               path != worst + "/own_bits_lost" &&  // that of /hit/most_bits_lost
               !path.starts_with(worst + "/operands");
    if (path == "/surface") return false;                                                // that of /hit/surface
    if (path.starts_with("/ray/P_hex") || path.starts_with("/ray/D_hex")) return false;  // checked below
    return path != "/version";
}

const InspectorPart& titled(const std::vector<InspectorPart>& parts, const std::string& title) {
    for (const InspectorPart& part : parts)
        if (part.title == title) return part;
    FAIL("no part " << title);
    return parts.front();
}

void check_same(const Scene& scene, int x, int y, const Options& options = {}) {
    CAPTURE(x);
    CAPTURE(y);
    const Story story = explain(scene, options, x, y);
    const Texts json = numbers_of_json(story);
    Texts shown;
    const std::vector<InspectorPart> parts = inspector(story);
    gather(parts, shown);
    const std::string worst = story.hit && story.hit->worst ? "/hit/steps/" + std::to_string(*story.hit->worst) : "";
    int found = 0;
    // Stage 1 knows no surfaces, and has no part for them.
    if (story.in_all == 0)
        for (const char* count : {"/in_all", "/tested", "/met", "/not_listed"}) shown[count] = "0";
    for (const auto& entry : json) {
        const auto& path = entry.first;
        const auto& text = entry.second;
        if (!is_claimed(path, worst)) continue;
        CAPTURE(path);
        REQUIRE(shown.contains(path));
        CHECK(shown[path] == text);
        ++found;
    }
    for (const auto& entry : shown) {
        const auto& path = entry.first;
        const auto& text = entry.second;
        CAPTURE(path);
        // JSON has no numbers that are not finite.
        if (text == "∞" || text == "−∞" || text == "not a number") {
            CHECK(Json::parse(to_json(story)).at(Json::json_pointer(path)).is_null());
            continue;
        }
        REQUIRE(json.contains(path));
        CHECK(json.at(path) == text);
    }
    // A pixel alone has 12 numbers: its place 2 + 2, the picture's size 2, two colours 3 + 3; the ray has 6.
    CHECK(found >= 18);
    const auto& ray = titled(parts, "The ray");
    for (int i = 0; i < 3; ++i) {
        const auto axis = static_cast<std::size_t>(i);
        CHECK(written(ray.rows.at(0).numbers.at(axis), NumberForm::hex) == json.at("/ray/P_hex/" + std::to_string(i)));
        CHECK(written(ray.rows.at(1).numbers.at(axis), NumberForm::hex) == json.at("/ray/D_hex/" + std::to_string(i)));
    }
}

story::Number number(double value, double error, double truth) {
    story::Number n = unchecked(value);
    n.error = error;
    n.truth = truth;
    n.distance = truth > value ? truth - value : value - truth;
    n.sign = truth > 0 ? 1 : truth < 0 ? -1 : 0;
    return n;
}

}  // namespace

TEST_CASE("the numbers in the inspector equal explain --json, digit for digit: the paper's scene") {
    const Scene scene = read_scene(SCENES "/levental-2014.toml");
    // a sphere, both spheres, the tetrahedron, the background, the border, an edge of the tetrahedron
    for (const auto& [x, y] : {std::pair{350, 149}, {310, 190}, {375, 385}, {10, 10}, {0, 250}, {375, 398}})
        check_same(scene, x, y);
}

TEST_CASE("… in every scalar, at every stage, by every rule, and turned") {
    const Scene scene = read_scene(SCENES "/levental-2014.toml");
    for (int stage = 1; stage <= 5; ++stage) {
        Options options;
        options.stage = stage;
        check_same(scene, 350, 149, options);
        check_same(scene, 375, 385, options);
    }
    for (const Scalar scalar : {Scalar::float_, Scalar::double_, Scalar::long_double, Scalar::exact}) {
        Options options;
        options.scalar = scalar;
        options.turns = {{Axis::z, 10}, {Axis::y, -20}};
        options.triangle_rule = Tolerance{};
        options.sphere_rule = Textbook{};
        for (const auto& [x, y] : {std::pair{250, 200}, {375, 385}, {350, 149}}) check_same(scene, x, y, options);
    }
}

TEST_CASE("… in the room, with a mesh, and with Phong's own shading") {
    Scene room = read_scene(SCENES "/room.toml");
    for (const auto& [x, y] : {std::pair{100, 200}, {200, 120}, {320, 240}}) check_same(room, x, y);
    room.shading.model = ShadingModel::phong;
    check_same(room, 100, 200);
}

TEST_CASE("the parts stand in the order of explain, and what decides is marked") {
    const Scene scene = read_scene(SCENES "/levental-2014.toml");
    const auto titles = [&](int x, int y) {
        std::vector<std::string> all;
        for (const InspectorPart& part : inspector(explain(scene, {}, x, y))) all.push_back(part.title);
        return all;
    };
    CHECK(titles(350, 149) == std::vector<std::string>{"The pixel", "The truth", "The ray", "The surfaces", "The hit",
                                                       "The light", "The rounding"});
    CHECK(titles(10, 10) == std::vector<std::string>{"The pixel", "The truth", "The ray", "The surfaces"});

    // Sphere 0 is green, about (100, 350, 350): its middle is in column 350 and row 350, which is y = 499 − 350.
    const std::vector<InspectorPart> parts = inspector(explain(scene, {}, 350, 149));
    const std::vector<InspectorPart>& surfaces = titled(parts, "The surfaces").parts;
    REQUIRE(surfaces.size() == 6);
    for (const InspectorPart& surface : surfaces) {
        CHECK(surface.mark == story::Mark::right);
        CHECK(surface.open == (surface.title == "sphere 0"));
    }
    CHECK(surfaces[0].color == Rgb{0, 255, 0});
}

// Pixel (399, 0) looks far beside the triangle, which the tolerance takes for hit.
TEST_CASE("a wrong hit has no mark that says right") {
    Options options;
    options.triangle_rule = Tolerance{};
    const Scene scene = read_scene(SCENES "/tolerance-tiny.toml");
    const std::vector<InspectorPart> parts = inspector(explain(scene, options, 399, 0));
    CHECK(titled(parts, "The truth").mark == story::Mark::wrong);
    CHECK(titled(parts, "The truth").note == "wrong hit");
    const InspectorPart& triangle = titled(parts, "The surfaces").parts.at(0);
    CHECK(triangle.mark == story::Mark::wrong);
    CHECK(triangle.note.ends_with("; wrong: truly missed"));
    for (const InspectorRow& row : triangle.rows)
        if (row.label == "it says") CHECK(row.mark == story::Mark::wrong);
}

TEST_CASE("numbers are written short, in full and in hex") {
    // 0.1 is the double 0x1.999999999999ap-4; six digits are enough for it, not for 1/3.
    InspectedNumber third{"", 1 / 3.0, {}, false};
    CHECK(written(third, NumberForm::brief) == "0.333333");
    CHECK(written(third, NumberForm::full) == "0.3333333333333333");
    CHECK(written({"", .1, {}, false}, NumberForm::hex) == "0x1.999999999999ap-4");
    CHECK(written({"", 500, {}, false}, NumberForm::full) == "500");
    CHECK(written({"", -HUGE_VAL, {}, false}, NumberForm::full) == "−∞");
    CHECK(written({"", 500, {}, true}, NumberForm::hex) == "500");
    CHECK(written_with_bound(third, NumberForm::full).value == "0.3333333333333333");
    CHECK(written_with_bound(third, NumberForm::full).bound == "");
    const auto both = [](double value, double error, NumberForm form) {
        const auto [its_value, its_bound] = written_with_bound({"", value, number(value, error, value), false}, form);
        return its_value + ' ' + its_bound;
    };
    // 2^-53 = 1.1102230246251565404…e-16: bounds are rounded up.
    CHECK(both(1, 0x1p-53, NumberForm::brief) == "1 ± 1.2e-16");
    CHECK(both(1, 0x1p-53, NumberForm::full) == "1 ± 1.1102230246251566e-16");
    CHECK(both(1, 0x1p-53, NumberForm::hex) == "0x1p+0 ± 0x1p-53");
    // As many digits as the bound deserves. 1/3's seventh digit is cut, by 3.4e-8 at most: 2e-6 becomes 2.1e-6.
    CHECK(both(1 / 3.0, 2e-6, NumberForm::brief) == "0.3333333 ± 2.1e-06");
    // Not more than 17: the double 1/3 is 0.333333333333333314829…, so that 2^-56 = 1.387…e-17 becomes 1.870…e-17.
    CHECK(both(1 / 3.0, 0x1p-56, NumberForm::brief) == "0.33333333333333331 ± 1.9e-17");
    CHECK(both(1, 0, NumberForm::full) == "1 exact");
    CHECK(both(.1, 0, NumberForm::hex) == "0x1.999999999999ap-4 exact");
    // The double is exact, but no 0.1.
    CHECK(both(.1, 0, NumberForm::full) == "0.1 exact as a double");
    CHECK(both(.1, 0, NumberForm::brief) == "0.1 exact as a double");
    CHECK(both(1, HUGE_VAL, NumberForm::brief) == "1 ± unknown");
    CHECK(both(HUGE_VAL, HUGE_VAL, NumberForm::brief) == "∞ ± unknown");
}

TEST_CASE("an error bar is to scale where it can be seen, and enlarged where it cannot") {
    // 3 ± 1: 3 and its bar end at 4 of 4, which is 0.45 from the middle
    const ErrorBar wide = error_bar(number(3, 1, 3.5));
    CHECK(wide.kind == ErrorBar::Kind::to_scale);
    CHECK(wide.high == doctest::Approx(.95));
    CHECK(wide.value == doctest::Approx(.5 + .45 * 3 / 4));
    CHECK(wide.low == doctest::Approx(.5 + .45 * 2 / 4));
    CHECK(*wide.truth == doctest::Approx(.5 + .45 * 3.5 / 4));
    CHECK(wide.sign_is_proven);
    CHECK(wide.words == "bound ≤ 34 % of the value");  // a third is more than 33 %

    // −1 ± 2 reaches over 0
    const ErrorBar over = error_bar(number(-1, 2, .5));
    CHECK(!over.sign_is_proven);
    CHECK(over.low == doctest::Approx(.05));
    CHECK(over.high > zero_on_error_bar);
    CHECK(*over.truth == doctest::Approx(.5 + .45 * .5 / 3));

    const ErrorBar small = error_bar(number(2500, 2.4e-9, 2500 + 1.2e-9));
    CHECK(small.kind == ErrorBar::Kind::magnified);
    CHECK(small.words == "bound < 10⁻¹² of the value");
    // 2.6e-9 is nearest to 10⁻¹² of 2500 as powers of ten go, but more than that
    CHECK(error_bar(number(2500, 2.6e-9, 2500)).words == "bound < 10⁻¹¹ of the value");
    CHECK(small.high == doctest::Approx(.95));
    CHECK(small.low > zero_on_error_bar);
    // half way from the value to the bar's end
    CHECK(*small.truth == doctest::Approx((small.value + small.high) / 2).epsilon(1e-3));
    const ErrorBar negative = error_bar(number(-2500, 2.4e-9, -2500));
    CHECK(negative.low == doctest::Approx(1 - small.high));

    CHECK(error_bar(number(7, 0, 7)).kind == ErrorBar::Kind::exact);
    CHECK(error_bar(number(0, 0, 0)).value == zero_on_error_bar);
    CHECK(error_bar(number(0, 0, 0)).sign_is_proven);
    CHECK(!error_bar(number(0, 1e-300, 0)).sign_is_proven);
    CHECK(error_bar(number(1, HUGE_VAL, 1)).kind == ErrorBar::Kind::unknown);
    CHECK(error_bar(number(NAN, HUGE_VAL, NAN)).kind == ErrorBar::Kind::unknown);
    // the sum of both is too large for a double; half of it is not
    const ErrorBar huge = error_bar(number(1.5e308, 1.2e308, 1.5e308));
    CHECK(huge.high == doctest::Approx(.95));
    CHECK(huge.value == doctest::Approx(.5 + .45 * 1.5 / 2.7));
}

TEST_CASE("powers of ten, and angles") {
    CHECK(power_of_ten(-12) == "10⁻¹²");
    CHECK(power_of_ten(305) == "10³⁰⁵");
    CHECK(angle(0) == doctest::Approx(90));
    CHECK(angle(.5) == doctest::Approx(60));
    CHECK(angle(1 + 1e-15) == 0);
    CHECK(angle(-1 - 1e-15) == doctest::Approx(180));
}

TEST_CASE("two pixels' numbers are subtracted; headings write theirs in the form that is chosen") {
    const Scene scene = read_scene(SCENES "/levental-2014.toml");
    const auto parts_of = [&](int x, int y) { return inspector(explain(scene, Options{}, x, y)); };
    const auto find = [](const std::vector<InspectorPart>& parts, const std::string& title) {
        for (const InspectorPart& part : parts)
            if (part.title == title) return part;
        FAIL("there is no part called " << title);
        return InspectorPart{};
    };
    // Rays start at (500, column, row): from column 350 to 353 and row 350 to 346 the start moves by (0, 3, −4).
    const InspectorPart one = find(parts_of(350, 149), "The ray"), other = find(parts_of(353, 153), "The ray");
    CHECK(differences(one.rows[0], other.rows[0]) == "0, +3, −4");
    CHECK(differences(one.rows[0], one.rows[0]) == "");
    CHECK(differences(one.rows[0], InspectorRow{}) == "");
    // Surface 0 is met at t = 350 there, which in hexadecimal is 0x1.5e · 2⁸.
    const InspectorPart sphere = find(parts_of(350, 149), "The surfaces").parts.front();
    CHECK(note(sphere, NumberForm::brief).find("t = 350") != std::string::npos);
    CHECK(note(sphere, NumberForm::hex).find("t = 0x1.5ep+8") != std::string::npos);
}
