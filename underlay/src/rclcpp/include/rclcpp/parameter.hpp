#pragma once

#include <iostream>
#include <ostream>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "rcl_interfaces/msg/detail/parameter__struct.hpp"
#include "rcl_interfaces/msg/detail/parameter_descriptor__struct.hpp"
#include "rclcpp/exceptions.hpp"
#include "rclcpp/parameter_value.hpp"

namespace rclcpp
{

/// A parameter's name and value.
class Parameter
{
public:
  Parameter() = default;
  explicit Parameter(std::string name) : name_(std::move(name)) {}
  Parameter(std::string name, const ParameterValue & value) : name_(std::move(name)), value_(value) {}
  template<typename ValueTypeT>
  Parameter(std::string name, ValueTypeT value) : name_(std::move(name)), value_(std::move(value)) {}

  bool operator==(const Parameter & rhs) const {return name_ == rhs.name_ && value_ == rhs.value_;}
  bool operator!=(const Parameter & rhs) const {return !(*this == rhs);}

  ParameterType get_type() const {return value_.get_type();}
  std::string get_type_name() const {return to_string(get_type());}
  const std::string & get_name() const {return name_;}
  rcl_interfaces::msg::ParameterValue get_value_message() const {return value_.to_value_msg();}
  const ParameterValue & get_parameter_value() const {return value_;}

  /// The value as a T; a T that is Parameter gives all of it. Throws InvalidParameterTypeException.
  template<typename T>
  decltype(auto) get_value() const
  {
    try {
      if constexpr (std::is_same_v<T, Parameter>) {
        return static_cast<const Parameter &>(*this);
      } else {
        return value_.get<T>();
      }
    } catch (const ParameterTypeException & error) {
      throw exceptions::InvalidParameterTypeException(name_, error.what());
    }
  }
  /// The value of a type, by its number. Throws ParameterTypeException.
  template<ParameterType T>
  decltype(auto) get_value() const {return value_.get<T>();}

  // These throw ParameterTypeException.
  bool as_bool() const {return get_value<PARAMETER_BOOL>();}
  std::int64_t as_int() const {return get_value<PARAMETER_INTEGER>();}
  double as_double() const {return get_value<PARAMETER_DOUBLE>();}
  const std::string & as_string() const {return get_value<PARAMETER_STRING>();}
  const std::vector<std::uint8_t> & as_byte_array() const {return get_value<PARAMETER_BYTE_ARRAY>();}
  const std::vector<bool> & as_bool_array() const {return get_value<PARAMETER_BOOL_ARRAY>();}
  const std::vector<std::int64_t> & as_integer_array() const {return get_value<PARAMETER_INTEGER_ARRAY>();}
  const std::vector<double> & as_double_array() const {return get_value<PARAMETER_DOUBLE_ARRAY>();}
  const std::vector<std::string> & as_string_array() const {return get_value<PARAMETER_STRING_ARRAY>();}

  static Parameter from_parameter_msg(const rcl_interfaces::msg::Parameter & parameter);
  rcl_interfaces::msg::Parameter to_parameter_msg() const;
  std::string value_to_string() const {return to_string(value_);}

private:
  std::string name_;
  ParameterValue value_;
};

std::ostream & operator<<(std::ostream & os, const Parameter & parameter);
std::ostream & operator<<(std::ostream & os, const std::vector<Parameter> & parameters);
std::string to_string(const Parameter & parameter);
std::string to_string(const std::vector<Parameter> & parameters);

}  // namespace rclcpp
