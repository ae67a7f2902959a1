#include "explain/words.hpp"

namespace glassbox {

std::string_view word(Operation operation) {
    switch (operation) {
        case Operation::input:
            return "input";
        case Operation::constant:
            return "constant";
        case Operation::round:
            return "round";
        case Operation::add:
            return "+";
        case Operation::subtract:
            return "−";
        case Operation::multiply:
            return "×";
        case Operation::divide:
            return "÷";
        case Operation::negate:
            return "negate";
        case Operation::square_root:
            return "√";
        case Operation::power:
            return "pow";
        case Operation::absolute:
            return "abs";
        case Operation::less:
            return "<";
        case Operation::greater:
            return ">";
        case Operation::less_equal:
            return "≤";
        case Operation::greater_equal:
            return "≥";
        case Operation::equal:
            return "=";
        case Operation::not_equal:
            return "≠";
    }
    return "";
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
    using story::Fate;
    switch (fate) {
        case Fate::nearest:
            return "nearest";
        case Fate::as_near:
            return "as near";
        case Fate::farther:
            return "farther";
        case Fate::apart:
            return "apart";
        case Fate::touched:
            return "touched";
        case Fate::from_inside:
            return "from inside";
        case Fate::outside:
            return "outside";
        case Fate::edge_on:
            return "edge-on";
        case Fate::behind:
            return "behind";
        case Fate::overflow:
            return "overflow";
        case Fate::beyond_tolerance:
            return "beyond tolerance";
        case Fate::refused:
            return "refused";
    }
    return "";
}

std::string_view source(std::string_view file) {
    const std::size_t src = file.rfind("src/");
    return src == std::string_view::npos ? file : file.substr(src + 4);
}

}  // namespace glassbox
