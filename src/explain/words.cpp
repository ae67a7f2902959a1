#include "explain/words.hpp"

#include "numerics/dyadic.hpp"
#include "scene/named.hpp"

namespace glassbox {

namespace {

constexpr NameTable<Operation, 17> operations{{
    {"input", Operation::input, ""},
    {"constant", Operation::constant, ""},
    {"round", Operation::round, ""},
    {"+", Operation::add, ""},
    {"−", Operation::subtract, ""},
    {"×", Operation::multiply, ""},
    {"÷", Operation::divide, ""},
    {"negate", Operation::negate, ""},
    {"√", Operation::square_root, ""},
    {"pow", Operation::power, ""},
    {"abs", Operation::absolute, ""},
    {"<", Operation::less, ""},
    {">", Operation::greater, ""},
    {"≤", Operation::less_equal, ""},
    {"≥", Operation::greater_equal, ""},
    {"=", Operation::equal, ""},
    {"≠", Operation::not_equal, ""},
}};

constexpr NameTable<story::Fate, 12> fates{{
    {"nearest", story::Fate::nearest, ""},
    {"as near", story::Fate::as_near, ""},
    {"farther", story::Fate::farther, ""},
    {"apart", story::Fate::apart, ""},
    {"touched", story::Fate::touched, ""},
    {"from inside", story::Fate::from_inside, ""},
    {"outside", story::Fate::outside, ""},
    {"edge-on", story::Fate::edge_on, ""},
    {"behind", story::Fate::behind, ""},
    {"overflow", story::Fate::overflow, ""},
    {"beyond tolerance", story::Fate::beyond_tolerance, ""},
    {"refused", story::Fate::refused, ""},
}};

}  // namespace

std::string_view word(Operation operation) {
    return name_where(operations, [&](Operation one) { return one == operation; });
}

std::string_view word(Known known) {
    switch (known) {
        case Known::exactly:
            return "exact";
        case Known::to_long_float:
            static_assert(Dyadic::long_bits == 320);
            return "320 bits";
        case Known::not_at_all:
            return "unknown";
    }
    return "";
}

std::string_view word(story::Kind kind) {
    switch (kind) {
        case story::Kind::sphere:
            return "sphere";
        case story::Kind::triangle:
            return "triangle";
        case story::Kind::mesh_face:
            return "mesh face";
    }
    return "";
}

std::string_view word(story::Fate fate) {
    return name_where(fates, [&](story::Fate one) { return one == fate; });
}

std::string_view source(std::string_view file) {
    const std::size_t src = file.rfind("src/");
    return src == std::string_view::npos ? file : file.substr(src + 4);
}

}  // namespace glassbox
