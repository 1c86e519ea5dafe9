#pragma once

#include <string>
#include <utility>

#include "rclcpp/client.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/service.hpp"

namespace rclcpp::node_interfaces
{

/// Services and clients of a node, and what their names become.
class NodeServicesInterface
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(NodeServicesInterface)

  explicit NodeServicesInterface(NodeBaseInterface::SharedPtr node) : node_(std::move(node)) {}

  void add_client(ClientBase::SharedPtr client, CallbackGroup::SharedPtr group) {node_->add(client, group);}
  void add_service(ServiceBase::SharedPtr service, CallbackGroup::SharedPtr group)
  {
    node_->add(service, group);
  }
  std::string resolve_service_name(const std::string & name, bool only_expand = false) const
  {
    return node_->resolve_topic_or_service_name(name, true, only_expand);
  }
  NodeBaseInterface::SharedPtr get_node_base_interface() const {return node_;}

private:
  NodeBaseInterface::SharedPtr node_;
};

}  // namespace rclcpp::node_interfaces
