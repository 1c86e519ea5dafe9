#pragma once

#include <cstddef>
#include <functional>
#include <tuple>
#include <type_traits>

namespace rclcpp::function_traits
{

/// Result and arguments of something that can be called: a function, a pointer to one, an object with one
/// operator(), and what std::bind makes of a method.
template<typename FunctionT>
struct function_traits : function_traits<decltype(&FunctionT::operator())> {};

template<typename ReturnT, typename ... Args>
struct function_traits<ReturnT(Args ...)>
{
  using arguments = std::tuple<Args ...>;
  using return_type = ReturnT;
  static constexpr std::size_t arity = sizeof...(Args);
  template<std::size_t N>
  using argument_type = std::tuple_element_t<N, arguments>;
};

template<typename ReturnT, typename ... Args>
struct function_traits<ReturnT (*)(Args ...)>: function_traits<ReturnT(Args ...)> {};
template<typename ReturnT, typename ClassT, typename ... Args>
struct function_traits<ReturnT (ClassT::*)(Args ...)>: function_traits<ReturnT(Args ...)> {};
template<typename ReturnT, typename ClassT, typename ... Args>
struct function_traits<ReturnT (ClassT::*)(Args ...) const>: function_traits<ReturnT(Args ...)> {};
// The library of GCC: what is bound are the object and the places of all arguments.
template<typename ReturnT, typename ClassT, typename ... Args, typename ... Bound>
struct function_traits<std::_Bind<ReturnT (ClassT::*(Bound ...))(Args ...)>>
  : function_traits<ReturnT(Args ...)> {};
template<typename ReturnT, typename ClassT, typename ... Args, typename ... Bound>
struct function_traits<std::_Bind<ReturnT (ClassT::*(Bound ...))(Args ...) const>>
  : function_traits<ReturnT(Args ...)> {};
template<typename ReturnT, typename ... Args, typename ... Bound>
struct function_traits<std::_Bind<ReturnT(*(Bound ...))(Args ...)>>: function_traits<ReturnT(Args ...)> {};

template<typename FunctionT>
struct function_traits<FunctionT &>: function_traits<FunctionT> {};
template<typename FunctionT>
struct function_traits<FunctionT &&>: function_traits<FunctionT> {};

template<std::size_t Arity, typename FunctorT>
struct arity_comparator : std::bool_constant<Arity == function_traits<FunctorT>::arity> {};

template<typename FunctorT, typename ... Args>
struct check_arguments
  : std::is_same<typename function_traits<FunctorT>::arguments, std::tuple<Args ...>> {};

template<typename FunctorAT, typename FunctorBT>
struct same_arguments
  : std::is_same<
    typename function_traits<FunctorAT>::arguments, typename function_traits<FunctorBT>::arguments> {};

}  // namespace rclcpp::function_traits
