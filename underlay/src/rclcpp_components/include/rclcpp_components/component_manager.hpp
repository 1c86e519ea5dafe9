#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "composition_interfaces/srv/list_nodes.hpp"
#include "composition_interfaces/srv/load_node.hpp"
#include "composition_interfaces/srv/unload_node.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/node_factory.hpp"
#include "rclcpp_components/visibility_control.hpp"

namespace rclcpp_components
{

/// Why a component cannot be loaded; its text goes to the client that asked for it.
class ComponentManagerException : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// A node whose services load other nodes into its process, list them, and end them.
class ComponentManager : public rclcpp::Node
{
public:
  using LoadNode = composition_interfaces::srv::LoadNode;
  using UnloadNode = composition_interfaces::srv::UnloadNode;
  using ListNodes = composition_interfaces::srv::ListNodes;

  /// The name of a class, and the path of the library that registers it.
  using ComponentResource = std::pair<std::string, std::string>;

  /// Nodes are added to `executor`. It has to outlive them, and is not kept alive.
  explicit ComponentManager(
    std::weak_ptr<rclcpp::Executor> executor = std::weak_ptr<rclcpp::executors::MultiThreadedExecutor>(),
    std::string node_name = "ComponentManager",
    const rclcpp::NodeOptions & node_options = rclcpp::NodeOptions()
    .start_parameter_services(false)
    .start_parameter_event_publisher(false));
  ~ComponentManager() override;

  /// What the package registers. Throws ComponentManagerException for one that registers nothing.
  virtual std::vector<ComponentResource> get_component_resources(
    const std::string & package_name, const std::string & resource_index = "rclcpp_components") const;

  /// Loads the library. None if it does not register the class; throws ComponentManagerException if it
  /// cannot be loaded.
  virtual std::shared_ptr<NodeFactory> create_component_factory(const ComponentResource & resource);

  virtual void set_executor(const std::weak_ptr<rclcpp::Executor> executor);

protected:
  virtual rclcpp::NodeOptions create_node_options(const std::shared_ptr<LoadNode::Request> request);
  virtual void add_node_to_executor(std::uint64_t node_id);
  virtual void remove_node_from_executor(std::uint64_t node_id);

  virtual void on_load_node(
    const std::shared_ptr<rmw_request_id_t> request_header,
    const std::shared_ptr<LoadNode::Request> request, std::shared_ptr<LoadNode::Response> response);
  virtual void on_unload_node(
    const std::shared_ptr<rmw_request_id_t> request_header,
    const std::shared_ptr<UnloadNode::Request> request, std::shared_ptr<UnloadNode::Response> response);
  virtual void on_list_nodes(
    const std::shared_ptr<rmw_request_id_t> request_header,
    const std::shared_ptr<ListNodes::Request> request, std::shared_ptr<ListNodes::Response> response);

  std::weak_ptr<rclcpp::Executor> executor_;
  std::uint64_t unique_id_ = 1;
  std::map<std::uint64_t, NodeInstanceWrapper> node_wrappers_;
  rclcpp::Service<LoadNode>::SharedPtr loadNode_srv_;
  rclcpp::Service<UnloadNode>::SharedPtr unloadNode_srv_;
  rclcpp::Service<ListNodes>::SharedPtr listNodes_srv_;

private:
  std::shared_ptr<NodeFactory> factory_of(const LoadNode::Request & request);
  void load(const std::shared_ptr<LoadNode::Request> & request, LoadNode::Response & response);
};

}  // namespace rclcpp_components
