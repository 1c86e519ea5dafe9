#pragma once

#include <type_traits>

#include "rclcpp/detail/template_contains.hpp"

namespace rclcpp::detail
{

/// Whether no two types are the same.
template<typename ... Ts>
struct template_unique : std::true_type {};
template<typename T, typename ... Ts>
struct template_unique<T, Ts ...>
  : std::bool_constant<!template_contains_v<T, Ts ...> && template_unique<Ts ...>::value> {};
template<typename ... Ts>
inline constexpr bool template_unique_v = template_unique<Ts ...>::value;

}  // namespace rclcpp::detail
