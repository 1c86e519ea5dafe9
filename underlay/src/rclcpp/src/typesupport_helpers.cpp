#include "rclcpp/typesupport_helpers.hpp"

#include <array>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace rclcpp
{

namespace
{

/// The package, the kind and the name of a type: {std_msgs, msg, String}, also for std_msgs/String.
std::array<std::string, 3> parts_of(const std::string & type, const std::string & usual_kind)
{
  const auto first = type.find('/'), last = type.rfind('/');
  if (first == std::string::npos || first == 0 || last + 1 == type.size()) {
    throw std::runtime_error("Message type is not of the form package/type and cannot be processed");
  }
  return {
    type.substr(0, first), first == last ? usual_kind : type.substr(first + 1, last - first - 1),
    type.substr(last + 1)};
}

/// Where the library of a package may be; the name alone leaves it to the loader.
std::vector<std::string> places_of(const std::string & library)
{
  std::vector<std::string> places;
  const char * prefixes = std::getenv("AMENT_PREFIX_PATH");
  std::istringstream rest(prefixes ? prefixes : "");
  for (std::string prefix; std::getline(rest, prefix, ':'); ) {
    places.push_back(prefix + "/lib/" + library);
  }
  places.push_back(library);
  return places;
}

template<typename HandleT>
const HandleT * handle_of(
  const std::string & type, const std::string & usual_kind, const std::string & function,
  rcpputils::SharedLibrary & library)
{
  const auto [package, kind, name] = parts_of(type, usual_kind);
  const std::string symbol = function + package + "__" + kind + "__" + name;
  if (!library.has_symbol(symbol)) {
    throw std::runtime_error(
            "Something went wrong loading the typesupport library for message type " + type +
            ". Is the package '" + package + "' installed and sourced, and does it have this type?");
  }
  return reinterpret_cast<const HandleT * (*)()>(library.get_symbol(symbol))();
}

}  // namespace

std::shared_ptr<rcpputils::SharedLibrary> get_typesupport_library(
  const std::string & type, const std::string & typesupport_identifier)
{
  const auto package = parts_of(type, "")[0];
  for (const auto & place : places_of("lib" + package + "__" + typesupport_identifier + ".so")) {
    try {
      return std::make_shared<rcpputils::SharedLibrary>(place);
    } catch (const std::runtime_error &) {
      continue;  // it is elsewhere, or nowhere
    }
  }
  throw std::runtime_error(
          "Something went wrong loading the typesupport library for message type " + type +
          ". Is the package '" + package + "' installed and sourced?");
}

const rosidl_message_type_support_t * get_message_typesupport_handle(
  const std::string & type, const std::string & typesupport_identifier, rcpputils::SharedLibrary & library)
{
  return handle_of<rosidl_message_type_support_t>(
    type, "msg", typesupport_identifier + "__get_message_type_support_handle__", library);
}

const rosidl_service_type_support_t * get_service_typesupport_handle(
  const std::string & type, const std::string & typesupport_identifier, rcpputils::SharedLibrary & library)
{
  return handle_of<rosidl_service_type_support_t>(
    type, "srv", typesupport_identifier + "__get_service_type_support_handle__", library);
}

}  // namespace rclcpp
