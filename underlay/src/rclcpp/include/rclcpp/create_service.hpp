#pragma once

#include <memory>
#include <string>
#include <utility>

#include "rclcpp/detail/node_of.hpp"

namespace rclcpp
{

template<typename ServiceT, typename CallbackT, typename NodeT>
std::shared_ptr<Service<ServiceT>> create_service(
  NodeT && node, const std::string & service_name, CallbackT && callback,
  const QoS & qos = ServicesQoS(), CallbackGroup::SharedPtr group = nullptr)
{
  return detail::node_of(node).template create_service<ServiceT>(
    service_name, std::forward<CallbackT>(callback), qos, std::move(group));
}

/// The same, of parts of a node.
template<typename ServiceT, typename CallbackT>
std::shared_ptr<Service<ServiceT>> create_service(
  std::shared_ptr<node_interfaces::NodeBaseInterface> node_base,
  std::shared_ptr<node_interfaces::NodeServicesInterface> node_services, const std::string & service_name,
  CallbackT && callback, const QoS & qos, CallbackGroup::SharedPtr group)
{
  auto service = std::make_shared<Service<ServiceT>>(
    node_base, service_name, detail::service_handler<ServiceT>(std::forward<CallbackT>(callback)), qos);
  node_services->add_service(service, std::move(group));
  return service;
}

}  // namespace rclcpp
