#pragma once

#include <type_traits>

namespace rclcpp::detail
{

/// Whether the first type is one of the others.
template<typename T, typename ... Ts>
using template_contains = std::disjunction<std::is_same<T, Ts>...>;
template<typename T, typename ... Ts>
inline constexpr bool template_contains_v = template_contains<T, Ts ...>::value;

}  // namespace rclcpp::detail
