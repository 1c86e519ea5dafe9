#include "logger_services.hpp"

#include <memory>
#include <string>

#include "logging_lock.hpp"
#include "rcl_interfaces/srv/get_logger_levels.hpp"
#include "rcl_interfaces/srv/set_logger_levels.hpp"
#include "rcutils/error_handling.h"
#include "rcutils/logging.h"

namespace rclcpp::detail
{

namespace
{

using rcl_interfaces::srv::GetLoggerLevels;
using rcl_interfaces::srv::SetLoggerLevels;

void get_levels(
  const std::shared_ptr<GetLoggerLevels::Request> & request,
  const std::shared_ptr<GetLoggerLevels::Response> & response)
{
  const auto mutex = logging_mutex();
  const std::lock_guard lock(*mutex);
  for (const auto & name : request->names) {
    const int level = rcutils_logging_get_logger_level(name.c_str());
    auto & found = response->levels.emplace_back();
    found.name = name;
    found.level = static_cast<std::uint32_t>(level < 0 ? RCUTILS_LOG_SEVERITY_UNSET : level);
  }
}

void set_levels(
  const std::shared_ptr<SetLoggerLevels::Request> & request,
  const std::shared_ptr<SetLoggerLevels::Response> & response)
{
  const auto mutex = logging_mutex();
  const std::lock_guard lock(*mutex);
  for (const auto & given : request->levels) {
    auto & result = response->results.emplace_back();
    result.successful =
      rcutils_logging_set_logger_level(given.name.c_str(), static_cast<int>(given.level)) == RCUTILS_RET_OK;
    if (!result.successful) {
      result.reason = rcutils_get_error_string().str;
      rcutils_reset_error();
    }
  }
}

template<typename ServiceT, typename Answer>
ServiceBase::SharedPtr offer(
  const node_interfaces::NodeBaseInterface::SharedPtr & node, const char * name, Answer answer)
{
  auto service = std::make_shared<Service<ServiceT>>(
    node, std::string(node->get_name()) + "/" + name, service_handler<ServiceT>(answer), ServicesQoS());
  node->add(service, nullptr);
  return service;
}

}  // namespace

std::vector<ServiceBase::SharedPtr> logger_services(
  const node_interfaces::NodeBaseInterface::SharedPtr & node)
{
  return {
    offer<GetLoggerLevels>(node, "get_logger_levels", get_levels),
    offer<SetLoggerLevels>(node, "set_logger_levels", set_levels),
  };
}

}  // namespace rclcpp::detail
