#pragma once

#include <memory>
#include <string>
#include <utility>

#include "rclcpp/detail/node_of.hpp"

namespace rclcpp
{

template<typename ServiceT, typename NodeT>
std::shared_ptr<Client<ServiceT>> create_client(
  NodeT && node, const std::string & service_name, const QoS & qos = ServicesQoS(),
  CallbackGroup::SharedPtr group = nullptr)
{
  return detail::node_of(node).template create_client<ServiceT>(service_name, qos, std::move(group));
}

/// The same, of parts of a node.
template<typename ServiceT>
std::shared_ptr<Client<ServiceT>> create_client(
  std::shared_ptr<node_interfaces::NodeBaseInterface> node_base,
  std::shared_ptr<node_interfaces::NodeGraphInterface>,
  std::shared_ptr<node_interfaces::NodeServicesInterface> node_services, const std::string & service_name,
  const QoS & qos = ServicesQoS(), CallbackGroup::SharedPtr group = nullptr)
{
  auto client = std::make_shared<Client<ServiceT>>(node_base, service_name, qos);
  node_services->add_client(client, std::move(group));
  return client;
}

}  // namespace rclcpp
