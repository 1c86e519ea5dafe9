#pragma once

#include <memory>
#include <string>
#include <utility>

#include "rclcpp/node_interfaces/node_clock_interface.hpp"
#include "rclcpp/node_interfaces/node_logging_interface.hpp"
#include "rclcpp_action/detail/server_work.hpp"

namespace rclcpp_action
{

/// What action servers of all types have in common.
class ServerBase
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(ServerBase)
  virtual ~ServerBase() = default;
};

/// Accepts goals, or not, as long as somebody holds it.
template<typename ActionT>
class Server : public ServerBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS_NOT_COPYABLE(Server<ActionT>)

  using GoalCallback = typename detail::ServerWork<ActionT>::GoalCallback;
  using CancelCallback = typename detail::ServerWork<ActionT>::CancelCallback;
  using AcceptedCallback = typename detail::ServerWork<ActionT>::AcceptedCallback;

  Server(
    const rclcpp::node_interfaces::NodeBaseInterface::SharedPtr & node,
    const rclcpp::node_interfaces::NodeClockInterface::SharedPtr & clock,
    const rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr & /*logging*/, const std::string & name,
    const rcl_action_server_options_t & options, GoalCallback handle_goal, CancelCallback handle_cancel,
    AcceptedCallback handle_accepted, const rclcpp::CallbackGroup::SharedPtr & group = nullptr)
  : work_(
      std::make_shared<detail::ServerWork<ActionT>>(
        node, clock->get_clock(), name, options, std::move(handle_goal), std::move(handle_cancel),
        std::move(handle_accepted)))
  {
    work_->serve(node, name, options, group);
  }

private:
  const std::shared_ptr<detail::ServerWork<ActionT>> work_;
};

}  // namespace rclcpp_action
