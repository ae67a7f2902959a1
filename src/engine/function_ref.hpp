#pragma once
#include <memory>
#include <type_traits>

namespace glassbox::engine {

template <class Signature>
class FunctionRef;

/// Refers to something that can be called, for as long as a call lasts to which it is handed: what is called so need
/// not be a template. (C++26 has it as std::function_ref.)
template <class Result, class... Arguments>
class FunctionRef<Result(Arguments...)> {
public:
    template <class Function>
    requires(!std::is_same_v<std::remove_cvref_t<Function>, FunctionRef>) FunctionRef(Function&& function)
        : function_(const_cast<void*>(static_cast<const void*>(std::addressof(function)))),
          call_([](void* one, Arguments... arguments) -> Result {
              return (*static_cast<std::remove_reference_t<Function>*>(one))(arguments...);
          }) {}

    Result operator()(Arguments... arguments) const { return call_(function_, arguments...); }

private:
    void* function_;
    Result (*call_)(void*, Arguments...);
};

}  // namespace glassbox::engine
