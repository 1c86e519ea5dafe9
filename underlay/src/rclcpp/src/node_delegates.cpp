// What a node passes on to its parts.

#include "rclcpp/node.hpp"

namespace rclcpp
{

using rcl_interfaces::msg::ParameterDescriptor;
using rcl_interfaces::msg::SetParametersResult;

const ParameterValue & Node::declare_parameter(
  const std::string & name, const ParameterValue & default_value,
  const ParameterDescriptor & parameter_descriptor, bool ignore_override)
{
  return parameters_->declare_parameter(name, default_value, parameter_descriptor, ignore_override);
}

const ParameterValue & Node::declare_parameter(
  const std::string & name, ParameterType type, const ParameterDescriptor & parameter_descriptor,
  bool ignore_override)
{
  return parameters_->declare_parameter(name, type, parameter_descriptor, ignore_override);
}

void Node::undeclare_parameter(const std::string & name)
{
  parameters_->undeclare_parameter(name);
}

bool Node::has_parameter(const std::string & name) const
{
  return parameters_->has_parameter(name);
}

SetParametersResult Node::set_parameter(const Parameter & parameter)
{
  return parameters_->set_parameters_atomically({parameter});
}

std::vector<SetParametersResult> Node::set_parameters(const std::vector<Parameter> & parameters)
{
  return parameters_->set_parameters(parameters);
}

SetParametersResult Node::set_parameters_atomically(const std::vector<Parameter> & parameters)
{
  return parameters_->set_parameters_atomically(parameters);
}

Parameter Node::get_parameter(const std::string & name) const
{
  return parameters_->get_parameter(name);
}

bool Node::get_parameter(const std::string & name, Parameter & parameter) const
{
  return parameters_->get_parameter(name, parameter);
}

std::vector<Parameter> Node::get_parameters(const std::vector<std::string> & names) const
{
  return parameters_->get_parameters(names);
}

ParameterDescriptor Node::describe_parameter(const std::string & name) const
{
  return parameters_->describe_parameters({name}).front();
}

std::vector<ParameterDescriptor> Node::describe_parameters(const std::vector<std::string> & names) const
{
  return parameters_->describe_parameters(names);
}

std::vector<std::uint8_t> Node::get_parameter_types(const std::vector<std::string> & names) const
{
  return parameters_->get_parameter_types(names);
}

rcl_interfaces::msg::ListParametersResult Node::list_parameters(
  const std::vector<std::string> & prefixes, std::uint64_t depth) const
{
  return parameters_->list_parameters(prefixes, depth);
}

node_interfaces::PreSetParametersCallbackHandle::SharedPtr Node::add_pre_set_parameters_callback(
  PreSetParametersCallbackType callback)
{
  return parameters_->add_pre_set_parameters_callback(std::move(callback));
}

node_interfaces::OnSetParametersCallbackHandle::SharedPtr Node::add_on_set_parameters_callback(
  OnSetParametersCallbackType callback)
{
  return parameters_->add_on_set_parameters_callback(std::move(callback));
}

node_interfaces::PostSetParametersCallbackHandle::SharedPtr Node::add_post_set_parameters_callback(
  PostSetParametersCallbackType callback)
{
  return parameters_->add_post_set_parameters_callback(std::move(callback));
}

void Node::remove_pre_set_parameters_callback(const PreSetParametersCallbackHandle * handler)
{
  parameters_->remove_pre_set_parameters_callback(handler);
}

void Node::remove_on_set_parameters_callback(const OnSetParametersCallbackHandle * handler)
{
  parameters_->remove_on_set_parameters_callback(handler);
}

void Node::remove_post_set_parameters_callback(const PostSetParametersCallbackHandle * handler)
{
  parameters_->remove_post_set_parameters_callback(handler);
}

std::vector<std::string> Node::get_node_names() const
{
  return graph_->get_node_names();
}

Node::NamesAndTypes Node::get_topic_names_and_types() const
{
  return graph_->get_topic_names_and_types();
}

Node::NamesAndTypes Node::get_service_names_and_types() const
{
  return graph_->get_service_names_and_types();
}

Node::NamesAndTypes Node::get_service_names_and_types_by_node(
  const std::string & node_name, const std::string & namespace_) const
{
  return graph_->get_service_names_and_types_by_node(node_name, namespace_);
}

std::size_t Node::count_publishers(const std::string & topic_name) const
{
  return graph_->count_publishers(topic_name);
}

std::size_t Node::count_subscribers(const std::string & topic_name) const
{
  return graph_->count_subscribers(topic_name);
}

std::size_t Node::count_clients(const std::string & service_name) const
{
  return graph_->count_clients(service_name);
}

std::size_t Node::count_services(const std::string & service_name) const
{
  return graph_->count_services(service_name);
}

std::vector<TopicEndpointInfo> Node::get_publishers_info_by_topic(
  const std::string & topic_name, bool no_mangle) const
{
  return graph_->get_publishers_info_by_topic(topic_name, no_mangle);
}

std::vector<TopicEndpointInfo> Node::get_subscriptions_info_by_topic(
  const std::string & topic_name, bool no_mangle) const
{
  return graph_->get_subscriptions_info_by_topic(topic_name, no_mangle);
}

}  // namespace rclcpp
