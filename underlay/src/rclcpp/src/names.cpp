#include "names.hpp"

#include <string>

#include "deallocate.hpp"
#include "rcl/expand_topic_name.h"
#include "rcl/validate_topic_name.h"
#include "rclcpp/detail/check.hpp"
#include "rclcpp/exceptions.hpp"
#include "rclcpp/expand_topic_or_service_name.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rcutils/types/string_map.h"
#include "rmw/error_handling.h"
#include "rmw/validate_full_topic_name.h"
#include "rmw/validate_namespace.h"
#include "rmw/validate_node_name.h"

namespace rclcpp
{

namespace
{

[[noreturn]] void throw_invalid(
  const char * name, const char * reason, std::size_t index, bool is_service)
{
  if (is_service) {
    throw exceptions::InvalidServiceNameError(name, reason, index);
  }
  throw exceptions::InvalidTopicNameError(name, reason, index);
}

void check_topic_or_service(const char * name, bool is_service)
{
  int result = 0;
  std::size_t index = 0;
  detail::check(rcl_validate_topic_name(name, &result, &index), "failed to validate a name");
  if (result != RCL_TOPIC_NAME_VALID) {
    throw_invalid(name, rcl_topic_name_validation_result_string(result), index, is_service);
  }
}

/// The full name, which may still be one that is not allowed.
std::string expand(const char * node, const char * name_space, const char * name, bool is_service)
{
  check_topic_or_service(name, is_service);
  const auto allocator = rcl_get_default_allocator();
  rcutils_string_map_t none = rcutils_get_zero_initialized_string_map();
  detail::check(rcutils_string_map_init(&none, 0, allocator), "failed to initialize string map");
  char * found = nullptr;
  const rcl_ret_t ret = rcl_expand_topic_name(
    name, node, name_space, &none, allocator, &found);
  const std::unique_ptr<char, detail::Deallocate> expanded(found);
  detail::check(rcutils_string_map_fini(&none), "failed to clean up a string map");
  detail::check(ret, "could not expand name");
  return expanded.get();
}

std::string resolve(const rcl_node_t & node, const char * name, bool is_service, bool only_expand)
{
  check_topic_or_service(name, is_service);
  char * found = nullptr;
  const rcl_ret_t ret = rcl_node_resolve_name(
    &node, name, rcl_get_default_allocator(), is_service, only_expand, &found);
  if (ret != RCL_RET_OK) {
    exceptions::throw_from_rcl_error(ret, "failed to resolve name");
  }
  const std::unique_ptr<char, detail::Deallocate> resolved(found);
  return resolved.get();
}

}  // namespace

void detail::throw_for_name(
  rcl_ret_t ret, const rcl_node_t & node, const char * name, bool is_service, const char * doing)
{
  if (ret != RCL_RET_TOPIC_NAME_INVALID && ret != RCL_RET_SERVICE_NAME_INVALID) {
    exceptions::throw_from_rcl_error(ret, doing);
  }
  const exceptions::RCLErrorBase original(ret, rcl_get_error_state());
  rcl_reset_error();
  int result = 0;
  std::size_t index = 0;
  const std::string full = expand(
    rcl_node_get_name(&node), rcl_node_get_namespace(&node), name, is_service);
  if (rmw_validate_full_topic_name(full.c_str(), &result, &index) == RMW_RET_OK &&
    result != RMW_TOPIC_VALID)
  {
    throw_invalid(full.c_str(), rmw_full_topic_name_validation_result_string(result), index, is_service);
  }
  rmw_reset_error();
  throw exceptions::RCLError(original, std::string(doing) + ": ");
}

void detail::check_namespace(const std::string & name_space)
{
  int result = 0;
  std::size_t index = 0;
  detail::check(
    rmw_validate_namespace(name_space.c_str(), &result, &index), "failed to validate subnode namespace");
  if (result != RMW_NAMESPACE_VALID) {
    throw exceptions::InvalidNamespaceError(
            name_space.c_str(), rmw_namespace_validation_result_string(result), index);
  }
}

std::string expand_topic_or_service_name(
  const std::string & name, const std::string & node_name, const std::string & namespace_, bool is_service)
{
  int result = 0;
  std::size_t index = 0;
  if (rmw_validate_node_name(node_name.c_str(), &result, &index) == RMW_RET_OK &&
    result != RMW_NODE_NAME_VALID)
  {
    throw exceptions::InvalidNodeNameError(
            node_name.c_str(), rmw_node_name_validation_result_string(result), index);
  }
  detail::check_namespace(namespace_);
  const std::string full = expand(node_name.c_str(), namespace_.c_str(), name.c_str(), is_service);
  detail::check(
    rmw_validate_full_topic_name(full.c_str(), &result, &index), "failed to validate full topic name");
  if (result != RMW_TOPIC_VALID) {
    throw_invalid(full.c_str(), rmw_full_topic_name_validation_result_string(result), index, is_service);
  }
  return full;
}

std::string node_interfaces::NodeBaseInterface::resolve_topic_or_service_name(
  const std::string & name, bool is_service, bool only_expand) const
{
  return resolve(*handle_, name.c_str(), is_service, only_expand);
}

}  // namespace rclcpp
