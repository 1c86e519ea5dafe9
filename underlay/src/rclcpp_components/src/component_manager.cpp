#include "rclcpp_components/component_manager.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <sstream>
#include <thread>

#include "ament_index_cpp/get_resource.hpp"

namespace rclcpp_components
{

namespace
{

using std::placeholders::_1;
using std::placeholders::_2;
using std::placeholders::_3;

void describe_threads(rclcpp::Node & node)
{
  const std::int64_t most = std::max(1U, std::thread::hardware_concurrency());
  rcl_interfaces::msg::ParameterDescriptor descriptor;
  descriptor.description = "Number of thread";
  descriptor.read_only = true;
  descriptor.integer_range.resize(1);
  descriptor.integer_range[0].from_value = 1;
  descriptor.integer_range[0].to_value = most;
  node.declare_parameter("thread_num", most, descriptor);
}

/// A line of the index: a class, a semicolon, and a library relative to the prefix of the package.
ComponentManager::ComponentResource read_line(const std::string & line, const std::string & prefix)
{
  const auto end = line.find(';');
  if (end == std::string::npos || line.find(';', end + 1) != std::string::npos) {
    throw ComponentManagerException("Invalid resource entry");
  }
  const std::string library = line.substr(end + 1);
  const bool is_absolute = !library.empty() && library.front() == '/';
  return {line.substr(0, end), is_absolute ? library : prefix + "/" + library};
}

std::vector<std::string> remapped(const ComponentManager::LoadNode::Request & request)
{
  std::vector<std::string> words{"--ros-args"};
  const auto add = [&](const std::string & rule) {words.insert(words.end(), {"-r", rule});};
  std::for_each(request.remap_rules.begin(), request.remap_rules.end(), add);
  if (!request.node_name.empty()) {
    add("__node:=" + request.node_name);
  }
  if (!request.node_namespace.empty()) {
    add("__ns:=" + request.node_namespace);
  }
  return words;
}

bool to_bool(const rclcpp::Parameter & argument)
{
  if (argument.get_type() != rclcpp::ParameterType::PARAMETER_BOOL) {
    throw ComponentManagerException(
            "Extra component argument '" + argument.get_name() + "' must be a boolean");
  }
  return argument.as_bool();
}

NodeInstanceWrapper made(NodeFactory & factory, const rclcpp::NodeOptions & options)
{
  try {
    return factory.create_node_instance(options);
  } catch (const std::exception & error) {
    throw ComponentManagerException(
            "Component constructor threw an exception: " + std::string(error.what()));
  } catch (...) {
    throw ComponentManagerException("Component constructor threw an exception");
  }
}

}  // namespace

ComponentManager::ComponentManager(
  std::weak_ptr<rclcpp::Executor> executor, std::string node_name, const rclcpp::NodeOptions & node_options)
: Node(std::move(node_name), node_options), executor_(std::move(executor))
{
  const auto qos = rclcpp::ServicesQoS().keep_last(200);
  loadNode_srv_ = create_service<LoadNode>(
    "~/_container/load_node", std::bind(&ComponentManager::on_load_node, this, _1, _2, _3), qos);
  unloadNode_srv_ = create_service<UnloadNode>(
    "~/_container/unload_node", std::bind(&ComponentManager::on_unload_node, this, _1, _2, _3), qos);
  listNodes_srv_ = create_service<ListNodes>(
    "~/_container/list_nodes", std::bind(&ComponentManager::on_list_nodes, this, _1, _2, _3));
  describe_threads(*this);
}

ComponentManager::~ComponentManager()
{
  const auto executor = executor_.lock();
  for (auto & [id, wrapper] : node_wrappers_) {
    if (executor) {
      executor->remove_node(wrapper.get_node_base_interface());
    }
  }
}

std::vector<ComponentManager::ComponentResource> ComponentManager::get_component_resources(
  const std::string & package_name, const std::string & resource_index) const
{
  std::string content;
  std::string prefix;
  if (package_name.empty() ||
    !ament_index_cpp::get_resource(resource_index, package_name, content, &prefix))
  {
    throw ComponentManagerException("Could not find requested resource in ament index");
  }
  std::vector<ComponentResource> resources;
  std::istringstream lines(content);
  for (std::string line; std::getline(lines, line); ) {
    if (!line.empty()) {
      resources.push_back(read_line(line, prefix));
    }
  }
  return resources;
}

std::shared_ptr<NodeFactory> ComponentManager::create_component_factory(const ComponentResource & resource)
{
  const auto & [name, library] = resource;
  if (!dlopen(library.c_str(), RTLD_NOW | RTLD_NOLOAD)) {
    RCLCPP_INFO(get_logger(), "Load Library: %s", library.c_str());
    // It stays: of a class that was loaded once there may be objects anywhere.
    if (!dlopen(library.c_str(), RTLD_NOW | RTLD_GLOBAL)) {
      throw ComponentManagerException("Failed to load library: " + std::string(dlerror()));
    }
  }
  return detail::factory_of(name);
}

void ComponentManager::set_executor(const std::weak_ptr<rclcpp::Executor> executor)
{
  executor_ = executor;
}

rclcpp::NodeOptions ComponentManager::create_node_options(const std::shared_ptr<LoadNode::Request> request)
{
  std::vector<rclcpp::Parameter> parameters;
  for (const auto & parameter : request->parameters) {
    parameters.push_back(rclcpp::Parameter::from_parameter_msg(parameter));
  }
  auto options = rclcpp::NodeOptions()
    .use_global_arguments(false)
    .parameter_overrides(parameters)
    .arguments(remapped(*request));
  for (const auto & message : request->extra_arguments) {
    const auto argument = rclcpp::Parameter::from_parameter_msg(message);
    if (argument.get_name() == "use_intra_process_comms") {
      options.use_intra_process_comms(to_bool(argument));
    } else if (argument.get_name() == "forward_global_arguments") {
      options.use_global_arguments(to_bool(argument));
    }
  }
  if (options.use_global_arguments()) {
    RCLCPP_WARN(
      get_logger(), "forward_global_arguments is true: the arguments of this container, such as its name, "
      "apply to the component as well");
  }
  return options;
}

void ComponentManager::add_node_to_executor(std::uint64_t node_id)
{
  if (const auto executor = executor_.lock()) {
    executor->add_node(node_wrappers_[node_id].get_node_base_interface(), true);
  }
}

void ComponentManager::remove_node_from_executor(std::uint64_t node_id)
{
  if (const auto executor = executor_.lock()) {
    executor->remove_node(node_wrappers_[node_id].get_node_base_interface());
  }
}

std::shared_ptr<NodeFactory> ComponentManager::factory_of(const LoadNode::Request & request)
{
  for (const auto & resource : get_component_resources(request.package_name)) {
    if (resource.first == request.plugin_name) {
      if (auto factory = create_component_factory(resource)) {
        return factory;
      }
    }
  }
  throw ComponentManagerException("Failed to find class with the requested plugin name.");
}

void ComponentManager::load(
  const std::shared_ptr<LoadNode::Request> & request, LoadNode::Response & response)
{
  const auto factory = factory_of(*request);
  auto wrapper = made(*factory, create_node_options(request));
  const auto id = unique_id_++;
  response.full_node_name = wrapper.get_node_base_interface()->get_fully_qualified_name();
  node_wrappers_[id] = std::move(wrapper);
  add_node_to_executor(id);
  response.unique_id = id;
  response.success = true;
}

void ComponentManager::on_load_node(
  const std::shared_ptr<rmw_request_id_t>, const std::shared_ptr<LoadNode::Request> request,
  std::shared_ptr<LoadNode::Response> response)
{
  try {
    load(request, *response);
  } catch (const ComponentManagerException & error) {
    RCLCPP_ERROR(get_logger(), "%s", error.what());
    response->error_message = error.what();
    response->success = false;
  }
}

void ComponentManager::on_unload_node(
  const std::shared_ptr<rmw_request_id_t>, const std::shared_ptr<UnloadNode::Request> request,
  std::shared_ptr<UnloadNode::Response> response)
{
  const auto found = node_wrappers_.find(request->unique_id);
  response->success = found != node_wrappers_.end();
  if (!response->success) {
    response->error_message = "No node found with unique_id: " + std::to_string(request->unique_id);
    RCLCPP_WARN(get_logger(), "%s", response->error_message.c_str());
    return;
  }
  remove_node_from_executor(request->unique_id);
  node_wrappers_.erase(found);
}

void ComponentManager::on_list_nodes(
  const std::shared_ptr<rmw_request_id_t>, const std::shared_ptr<ListNodes::Request>,
  std::shared_ptr<ListNodes::Response> response)
{
  for (auto & [id, wrapper] : node_wrappers_) {
    response->unique_ids.push_back(id);
    response->full_node_names.push_back(wrapper.get_node_base_interface()->get_fully_qualified_name());
  }
}

}  // namespace rclcpp_components
