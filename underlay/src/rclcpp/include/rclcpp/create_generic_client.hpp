#pragma once

#include <string>
#include <utility>

#include "rclcpp/detail/node_of.hpp"

namespace rclcpp
{

template<typename NodeT>
GenericClient::SharedPtr create_generic_client(
  NodeT && node, const std::string & service_name, const std::string & service_type,
  const QoS & qos = ServicesQoS(), CallbackGroup::SharedPtr group = nullptr)
{
  return detail::node_of(node).create_generic_client(service_name, service_type, qos, std::move(group));
}

/// The same, of parts of a node.
inline GenericClient::SharedPtr create_generic_client(
  std::shared_ptr<node_interfaces::NodeBaseInterface> node_base,
  std::shared_ptr<node_interfaces::NodeGraphInterface>,
  std::shared_ptr<node_interfaces::NodeServicesInterface> node_services, const std::string & service_name,
  const std::string & service_type, const QoS & qos = ServicesQoS(),
  CallbackGroup::SharedPtr group = nullptr)
{
  auto client = std::make_shared<GenericClient>(node_base, service_name, service_type, qos);
  node_services->add_client(client, std::move(group));
  return client;
}

}  // namespace rclcpp
