#pragma once

#include <type_traits>

#include "rosidl_runtime_cpp/traits.hpp"

namespace rclcpp
{

/// How a type of the program's own becomes a message and back. A program specializes it with is_specialized,
/// custom_type, ros_message_type, convert_to_ros_message and convert_to_custom.
template<typename CustomType, typename ROSMessageType = void, class Enable = void>
struct TypeAdapter
{
  using is_specialized = std::false_type;
  using custom_type = CustomType;
  using ros_message_type = CustomType;
};

/// Which adapter a type has where it stands alone. See RCLCPP_USING_CUSTOM_TYPE_AS_ROS_MESSAGE_TYPE.
template<typename CustomType>
struct ImplicitTypeAdapter
{
  using is_specialized = std::false_type;
};

/// Whether the type is a TypeAdapter.
template<typename T>
struct is_type_adapter : std::false_type {};
template<typename ... Ts>
struct is_type_adapter<TypeAdapter<Ts...>>: std::true_type {};

/// An adapter where a type of a message is asked for.
template<typename T>
struct TypeAdapter<T, void, std::enable_if_t<is_type_adapter<T>::value>>: T
{
  static_assert(T::is_specialized::value, "rclcpp::TypeAdapter is not specialized for these two types");
};

/// A type that has an adapter where it stands alone.
template<typename T>
struct TypeAdapter<T, void, std::enable_if_t<ImplicitTypeAdapter<T>::is_specialized::value>>
  : ImplicitTypeAdapter<T>
{
};

template<typename CustomType, typename ROSMessageType>
struct assert_type_pair_is_specialized_type_adapter
{
  using type_adapter = TypeAdapter<CustomType, ROSMessageType>;
  static_assert(
    type_adapter::is_specialized::value, "rclcpp::TypeAdapter is not specialized for these two types");
};

/// rclcpp::adapt_type<CustomType>::as<ROSMessageType> is their adapter.
template<typename CustomType>
struct adapt_type
{
  template<typename ROSMessageType>
  using as = typename assert_type_pair_is_specialized_type_adapter<CustomType, ROSMessageType>::type_adapter;
};

/// Lets the type stand for the message: create_publisher<CustomType>. To be used outside of any namespace.
#define RCLCPP_USING_CUSTOM_TYPE_AS_ROS_MESSAGE_TYPE(CustomType, ROSMessageType) \
  template<> \
  struct rclcpp::ImplicitTypeAdapter<CustomType> \
    : public rclcpp::TypeAdapter<CustomType, ROSMessageType> \
  { \
    static_assert( \
      is_specialized::value, "rclcpp::TypeAdapter is not specialized for " #CustomType " and " #ROSMessageType); \
  }

}  // namespace rclcpp
