#pragma once
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "render/option_names.hpp"
#include "render/setup.hpp"
#include "scene/coefficients.hpp"
#include "scene/shading_models.hpp"

namespace glassbox {

/// What a parameter is about.
enum class Subject { view, shading, computing };

/// Where a parameter stands in a Setup. Its type says how it is read and written.
using SetupMember =
    std::variant<int Options::*, bool Options::*, std::vector<Turn<double>> Options::*, Scalar Options::*,
                 EngineChoice Options::*, SphereRule Options::*, TriangleRule Options::*,
                 ShadingModel Shading<double>::*, double Shading<double>::*, double Setup::*, Vec3<double> Setup::*>;

/// One thing that can be chosen about how a scene is traced and shaded: a member of Setup, and what is to be known of
/// it by options, notes, scripts, the viewer's sliders and the command that shows a pixel again.
struct Parameter {
    std::string_view name;  ///< in scripts, and with -- before it as an option
    Subject subject;
    const char* unit;  ///< what stands for its value in help
    const char* help;  ///< the names of a choice are told after it
    int first_stage;   ///< that uses it
    bool only_for_pictures;
    SetupMember member;
    const char* label = "";  ///< in the viewer's controls; empty for what is not offered there
    Range range{};           ///< of a whole number: what it may be; of another: what it usually is
};

/// All of them, a row each.
std::span<const Parameter> parameters();

/// What the member is in that setup.
template <class AnySetup, class Value>
auto& part(AnySetup& setup, Value Options::*member) {
    return setup.options.*member;
}
template <class AnySetup, class Value>
auto& part(AnySetup& setup, Value Shading<double>::*member) {
    return setup.shading.*member;
}
template <class AnySetup, class Value>
auto& part(AnySetup& setup, Value Setup::*member) {
    return setup.*member;
}

/// Calls `use(value)` with what the parameter is in that setup.
template <class AnySetup, class Use>
decltype(auto) with_value(const Parameter& parameter, AnySetup& setup, const Use& use) {
    return std::visit([&](auto member) -> decltype(auto) { return use(part(setup, member)); }, parameter.member);
}

/// Whether the viewer lets it be changed beside the view.
inline bool is_offered(const Parameter& parameter) { return *parameter.label != '\0'; }

bool is_same(const Parameter& parameter, const Setup& a, const Setup& b);

/// The same setup, with the parameter as `from` has it.
Setup taken_over(Setup setup, const Parameter& parameter, const Setup& from);

/// As it is typed after its option; empty for one that is only on or off.
std::string written(const Parameter& parameter, const Setup& setup);

/// The names that a value is chosen by; null for what is no choice.
template <class Value>
inline constexpr std::nullptr_t choices = nullptr;
template <>
inline constexpr const auto& choices<ShadingModel> = shading_models;
template <>
inline constexpr const auto& choices<Scalar> = scalars;
template <>
inline constexpr const auto& choices<EngineChoice> = engines;
template <>
inline constexpr const auto& choices<SphereRule> = sphere_rules;
template <>
inline constexpr const auto& choices<TriangleRule> = triangle_rules;

template <class Value>
inline constexpr bool is_choice = !std::is_null_pointer_v<std::remove_cvref_t<decltype(choices<Value>)>>;

}  // namespace glassbox
