#pragma once

#include <cstdint>
#include <ostream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "rcl_interfaces/msg/detail/parameter_type__struct.hpp"
#include "rcl_interfaces/msg/detail/parameter_value__struct.hpp"

namespace rclcpp
{

enum ParameterType : std::uint8_t
{
  PARAMETER_NOT_SET = rcl_interfaces::msg::ParameterType::PARAMETER_NOT_SET,
  PARAMETER_BOOL = rcl_interfaces::msg::ParameterType::PARAMETER_BOOL,
  PARAMETER_INTEGER = rcl_interfaces::msg::ParameterType::PARAMETER_INTEGER,
  PARAMETER_DOUBLE = rcl_interfaces::msg::ParameterType::PARAMETER_DOUBLE,
  PARAMETER_STRING = rcl_interfaces::msg::ParameterType::PARAMETER_STRING,
  PARAMETER_BYTE_ARRAY = rcl_interfaces::msg::ParameterType::PARAMETER_BYTE_ARRAY,
  PARAMETER_BOOL_ARRAY = rcl_interfaces::msg::ParameterType::PARAMETER_BOOL_ARRAY,
  PARAMETER_INTEGER_ARRAY = rcl_interfaces::msg::ParameterType::PARAMETER_INTEGER_ARRAY,
  PARAMETER_DOUBLE_ARRAY = rcl_interfaces::msg::ParameterType::PARAMETER_DOUBLE_ARRAY,
  PARAMETER_STRING_ARRAY = rcl_interfaces::msg::ParameterType::PARAMETER_STRING_ARRAY,
};

std::string to_string(ParameterType type);
std::ostream & operator<<(std::ostream & os, ParameterType type);

/// A value was asked for as something that it is not.
class ParameterTypeException : public std::runtime_error
{
public:
  ParameterTypeException(ParameterType expected, ParameterType actual)
  : std::runtime_error("expected [" + to_string(expected) + "] got [" + to_string(actual) + "]") {}
};

/// The value of a parameter: nothing, or one of nine types.
class ParameterValue
{
public:
  ParameterValue();
  explicit ParameterValue(const rcl_interfaces::msg::ParameterValue & value);
  explicit ParameterValue(bool bool_value);
  explicit ParameterValue(int int_value);
  explicit ParameterValue(std::int64_t int_value);
  explicit ParameterValue(float double_value);
  explicit ParameterValue(double double_value);
  explicit ParameterValue(const std::string & string_value);
  explicit ParameterValue(const char * string_value);
  explicit ParameterValue(const std::vector<std::uint8_t> & byte_array_value);
  explicit ParameterValue(const std::vector<bool> & bool_array_value);
  explicit ParameterValue(const std::vector<int> & int_array_value);
  explicit ParameterValue(const std::vector<std::int64_t> & int_array_value);
  explicit ParameterValue(const std::vector<float> & double_array_value);
  explicit ParameterValue(const std::vector<double> & double_array_value);
  explicit ParameterValue(const std::vector<std::string> & string_array_value);

  ParameterType get_type() const {return static_cast<ParameterType>(value_.type);}
  const rcl_interfaces::msg::ParameterValue & to_value_msg() const {return value_;}
  bool operator==(const ParameterValue & rhs) const {return value_ == rhs.value_;}
  bool operator!=(const ParameterValue & rhs) const {return value_ != rhs.value_;}

  /// The value as a `type`. Throws ParameterTypeException.
  template<ParameterType type>
  decltype(auto) get() const
  {
    expect(type);
    if constexpr (type == PARAMETER_BOOL) {
      return static_cast<const bool &>(value_.bool_value);
    } else if constexpr (type == PARAMETER_INTEGER) {
      return static_cast<const std::int64_t &>(value_.integer_value);
    } else if constexpr (type == PARAMETER_DOUBLE) {
      return static_cast<const double &>(value_.double_value);
    } else if constexpr (type == PARAMETER_STRING) {
      return static_cast<const std::string &>(value_.string_value);
    } else if constexpr (type == PARAMETER_BYTE_ARRAY) {
      return static_cast<const std::vector<std::uint8_t> &>(value_.byte_array_value);
    } else if constexpr (type == PARAMETER_BOOL_ARRAY) {
      return static_cast<const std::vector<bool> &>(value_.bool_array_value);
    } else if constexpr (type == PARAMETER_INTEGER_ARRAY) {
      return static_cast<const std::vector<std::int64_t> &>(value_.integer_array_value);
    } else if constexpr (type == PARAMETER_DOUBLE_ARRAY) {
      return static_cast<const std::vector<double> &>(value_.double_array_value);
    } else {
      static_assert(type == PARAMETER_STRING_ARRAY, "a parameter that is not set has no value");
      return static_cast<const std::vector<std::string> &>(value_.string_array_value);
    }
  }

  /// The value as a T. Throws ParameterTypeException.
  template<typename T>
  decltype(auto) get() const
  {
    if constexpr (std::is_same_v<T, ParameterValue>) {
      return static_cast<const ParameterValue &>(*this);
    } else if constexpr (std::is_same_v<T, bool>) {
      return get<PARAMETER_BOOL>();
    } else if constexpr (std::is_same_v<T, std::int64_t>) {
      return get<PARAMETER_INTEGER>();
    } else if constexpr (std::is_integral_v<T>) {
      return static_cast<T>(get<PARAMETER_INTEGER>());
    } else if constexpr (std::is_same_v<T, double>) {
      return get<PARAMETER_DOUBLE>();
    } else if constexpr (std::is_floating_point_v<T>) {
      return static_cast<T>(get<PARAMETER_DOUBLE>());
    } else if constexpr (std::is_convertible_v<T, std::string>) {
      return get<PARAMETER_STRING>();
    } else if constexpr (std::is_same_v<T, std::vector<std::uint8_t>>) {
      return get<PARAMETER_BYTE_ARRAY>();
    } else if constexpr (std::is_same_v<T, std::vector<bool>>) {
      return get<PARAMETER_BOOL_ARRAY>();
    } else if constexpr (std::is_same_v<T, std::vector<std::int64_t>>) {
      return get<PARAMETER_INTEGER_ARRAY>();
    } else if constexpr (std::is_same_v<T, std::vector<double>>) {
      return get<PARAMETER_DOUBLE_ARRAY>();
    } else if constexpr (std::is_same_v<T, std::vector<int>>) {
      const auto & wide = get<PARAMETER_INTEGER_ARRAY>();
      return T(wide.begin(), wide.end());
    } else if constexpr (std::is_same_v<T, std::vector<float>>) {
      const auto & wide = get<PARAMETER_DOUBLE_ARRAY>();
      return T(wide.begin(), wide.end());
    } else {
      static_assert(
        std::is_same_v<T, std::vector<std::string>>,
        "a parameter is a bool, an integer, a double, a string, or a vector of one of these or of bytes");
      return get<PARAMETER_STRING_ARRAY>();
    }
  }

private:
  void expect(ParameterType type) const
  {
    if (get_type() != type) {
      throw ParameterTypeException(type, get_type());
    }
  }

  rcl_interfaces::msg::ParameterValue value_;
};

std::string to_string(const ParameterValue & type);

}  // namespace rclcpp
