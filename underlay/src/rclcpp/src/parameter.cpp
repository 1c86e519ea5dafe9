#include "rclcpp/parameter.hpp"

#include <iomanip>
#include <ios>

namespace rclcpp
{

namespace
{

using Type = rcl_interfaces::msg::ParameterType;

template<typename T, typename Format>
std::string listed(const std::vector<T> & values, Format format)
{
  std::string text = "[";
  for (const auto & value : values) {
    text += (text.size() == 1 ? "" : ", ") + format(value);
  }
  return text + "]";
}

std::string byte(std::uint8_t value)
{
  std::ostringstream text;
  text << "0x" << std::hex << std::setw(2) << std::setfill('0') << static_cast<int>(value);
  return text.str();
}

// In an array, a number has up to six digits; alone, it has six digits after the point.
std::string element(double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

std::string type_and_value(const Parameter & parameter)
{
  return "\"type\": \"" + parameter.get_type_name() + "\", \"value\": \"" + parameter.value_to_string() +
         "\"}";
}

}  // namespace

std::string to_string(ParameterType type)
{
  switch (type) {
    case PARAMETER_NOT_SET:
      return "not set";
    case PARAMETER_BOOL:
      return "bool";
    case PARAMETER_INTEGER:
      return "integer";
    case PARAMETER_DOUBLE:
      return "double";
    case PARAMETER_STRING:
      return "string";
    case PARAMETER_BYTE_ARRAY:
      return "byte_array";
    case PARAMETER_BOOL_ARRAY:
      return "bool_array";
    case PARAMETER_INTEGER_ARRAY:
      return "integer_array";
    case PARAMETER_DOUBLE_ARRAY:
      return "double_array";
    case PARAMETER_STRING_ARRAY:
      return "string_array";
    default:
      return "unknown type";
  }
}

std::ostream & operator<<(std::ostream & os, ParameterType type)
{
  return os << to_string(type);
}

std::string to_string(const ParameterValue & value)
{
  const auto & message = value.to_value_msg();
  switch (message.type) {
    case PARAMETER_NOT_SET:
      return "not set";
    case PARAMETER_BOOL:
      return message.bool_value ? "true" : "false";
    case PARAMETER_INTEGER:
      return std::to_string(message.integer_value);
    case PARAMETER_DOUBLE:
      return std::to_string(message.double_value);
    case PARAMETER_STRING:
      return message.string_value;
    case PARAMETER_BYTE_ARRAY:
      return listed(message.byte_array_value, byte);
    case PARAMETER_BOOL_ARRAY:
      return listed(
        message.bool_array_value, [](bool one) {return std::string(one ? "true" : "false");});
    case PARAMETER_INTEGER_ARRAY:
      return listed(message.integer_array_value, [](std::int64_t one) {return std::to_string(one);});
    case PARAMETER_DOUBLE_ARRAY:
      return listed(message.double_array_value, element);
    case PARAMETER_STRING_ARRAY:
      return listed(message.string_array_value, [](const std::string & one) {return one;});
    default:
      return "unknown type";
  }
}

ParameterValue::ParameterValue()
{
  value_.type = Type::PARAMETER_NOT_SET;
}

ParameterValue::ParameterValue(const rcl_interfaces::msg::ParameterValue & value)
: value_(value)
{
  if (value.type > Type::PARAMETER_STRING_ARRAY) {
    throw std::runtime_error("Unknown type: " + std::to_string(value.type));
  }
}

ParameterValue::ParameterValue(bool bool_value)
{
  value_.bool_value = bool_value;
  value_.type = Type::PARAMETER_BOOL;
}

ParameterValue::ParameterValue(int int_value)
: ParameterValue(static_cast<std::int64_t>(int_value))
{
}

ParameterValue::ParameterValue(std::int64_t int_value)
{
  value_.integer_value = int_value;
  value_.type = Type::PARAMETER_INTEGER;
}

ParameterValue::ParameterValue(float double_value)
: ParameterValue(static_cast<double>(double_value))
{
}

ParameterValue::ParameterValue(double double_value)
{
  value_.double_value = double_value;
  value_.type = Type::PARAMETER_DOUBLE;
}

ParameterValue::ParameterValue(const std::string & string_value)
{
  value_.string_value = string_value;
  value_.type = Type::PARAMETER_STRING;
}

ParameterValue::ParameterValue(const char * string_value)
: ParameterValue(std::string(string_value))
{
}

ParameterValue::ParameterValue(const std::vector<std::uint8_t> & byte_array_value)
{
  value_.byte_array_value = byte_array_value;
  value_.type = Type::PARAMETER_BYTE_ARRAY;
}

ParameterValue::ParameterValue(const std::vector<bool> & bool_array_value)
{
  value_.bool_array_value = bool_array_value;
  value_.type = Type::PARAMETER_BOOL_ARRAY;
}

ParameterValue::ParameterValue(const std::vector<int> & int_array_value)
{
  value_.integer_array_value.assign(int_array_value.begin(), int_array_value.end());
  value_.type = Type::PARAMETER_INTEGER_ARRAY;
}

ParameterValue::ParameterValue(const std::vector<std::int64_t> & int_array_value)
{
  value_.integer_array_value = int_array_value;
  value_.type = Type::PARAMETER_INTEGER_ARRAY;
}

ParameterValue::ParameterValue(const std::vector<float> & double_array_value)
{
  value_.double_array_value.assign(double_array_value.begin(), double_array_value.end());
  value_.type = Type::PARAMETER_DOUBLE_ARRAY;
}

ParameterValue::ParameterValue(const std::vector<double> & double_array_value)
{
  value_.double_array_value = double_array_value;
  value_.type = Type::PARAMETER_DOUBLE_ARRAY;
}

ParameterValue::ParameterValue(const std::vector<std::string> & string_array_value)
{
  value_.string_array_value = string_array_value;
  value_.type = Type::PARAMETER_STRING_ARRAY;
}

Parameter Parameter::from_parameter_msg(const rcl_interfaces::msg::Parameter & parameter)
{
  return Parameter(parameter.name, ParameterValue(parameter.value));
}

rcl_interfaces::msg::Parameter Parameter::to_parameter_msg() const
{
  rcl_interfaces::msg::Parameter message;
  message.name = name_;
  message.value = value_.to_value_msg();
  return message;
}

std::string to_string(const Parameter & parameter)
{
  return "{\"name\": \"" + parameter.get_name() + "\", " + type_and_value(parameter);
}

std::string to_string(const std::vector<Parameter> & parameters)
{
  std::string text = "{";
  for (const auto & parameter : parameters) {
    text += (text.size() == 1 ? "\"" : ", \"") + parameter.get_name() + "\": {" +
      type_and_value(parameter);
  }
  return text + "}";
}

std::ostream & operator<<(std::ostream & os, const Parameter & parameter)
{
  return os << to_string(parameter);
}

std::ostream & operator<<(std::ostream & os, const std::vector<Parameter> & parameters)
{
  return os << to_string(parameters);
}

}  // namespace rclcpp
