#include "names.hpp"

#include <string>

#include "deallocate.hpp"
#include "rcl/validate_topic_name.h"
#include "rclcpp/exceptions.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rmw/error_handling.h"
#include "rmw/validate_full_topic_name.h"

namespace rclcpp
{

namespace
{

std::string resolve(const rcl_node_t & node, const char * name, bool is_service, bool only_expand)
{
  char * found = nullptr;
  const rcl_ret_t ret = rcl_node_resolve_name(
    &node, name, rcl_get_default_allocator(), is_service, only_expand, &found);
  if (ret != RCL_RET_OK) {
    exceptions::throw_from_rcl_error(ret, "failed to resolve name");
  }
  const std::unique_ptr<char, detail::Deallocate> resolved(found);
  return resolved.get();
}

[[noreturn]] void throw_invalid(
  const char * name, const char * reason, std::size_t index, bool is_service)
{
  if (is_service) {
    throw exceptions::InvalidServiceNameError(name, reason, index);
  }
  throw exceptions::InvalidTopicNameError(name, reason, index);
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
  if (rcl_validate_topic_name(name, &result, &index) == RCL_RET_OK && result != RCL_TOPIC_NAME_VALID) {
    throw_invalid(name, rcl_topic_name_validation_result_string(result), index, is_service);
  }
  rcl_reset_error();
  const std::string full = resolve(node, name, is_service, false);
  if (rmw_validate_full_topic_name(full.c_str(), &result, &index) == RMW_RET_OK &&
    result != RMW_TOPIC_VALID)
  {
    throw_invalid(full.c_str(), rmw_full_topic_name_validation_result_string(result), index, is_service);
  }
  rmw_reset_error();
  throw exceptions::RCLError(original, std::string(doing) + ": ");
}

std::string node_interfaces::NodeBaseInterface::resolve_topic_or_service_name(
  const std::string & name, bool is_service, bool only_expand) const
{
  return resolve(*handle_, name.c_str(), is_service, only_expand);
}

}  // namespace rclcpp
