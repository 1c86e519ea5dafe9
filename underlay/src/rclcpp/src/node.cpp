#include "rclcpp/node.hpp"

#include <stdexcept>
#include <vector>

#include "graph_wait.hpp"
#include "logger_services.hpp"
#include "names.hpp"
#include "parameter_overrides.hpp"
#include "parameter_services.hpp"
#include "rclcpp/detail/qos_parameters.hpp"
#include "rcl_interfaces/msg/parameter_event.hpp"

namespace rclcpp
{

namespace
{

using node_interfaces::NodeBaseInterface;
using rcl_interfaces::msg::ParameterEvent;

std::map<std::string, ParameterValue> overrides_for(NodeBaseInterface & node, const NodeOptions & options)
{
  // What is given to the node alone wins.
  std::vector<const rcl_arguments_t *> sources;
  if (options.use_global_arguments()) {
    sources.push_back(&node.get_context()->get_rcl_context()->global_arguments);
  }
  sources.push_back(&options.get_rcl_node_options()->arguments);
  auto overrides = detail::parameter_overrides(node.get_fully_qualified_name(), sources);
  for (const auto & parameter : options.parameter_overrides()) {
    overrides[parameter.get_name()] = parameter.get_parameter_value();
  }
  return overrides;
}

void declare_all_overrides(node_interfaces::NodeParametersInterface & parameters)
{
  rcl_interfaces::msg::ParameterDescriptor descriptor;
  descriptor.dynamic_typing = true;
  for (const auto & [name, value] : parameters.get_parameter_overrides()) {
    if (!parameters.has_parameter(name)) {
      parameters.declare_parameter(name, value, descriptor, true);
    }
  }
}

QosOverridingOptions all_usual_policies()
{
  return {QosPolicyKind::Depth, QosPolicyKind::Durability, QosPolicyKind::History,
    QosPolicyKind::Reliability};
}

}  // namespace

struct Node::Services
{
  Publisher<ParameterEvent>::SharedPtr events;
  std::vector<ServiceBase::SharedPtr> parameters, loggers;
};

Node::Node(const std::string & node_name, const NodeOptions & options)
: Node(node_name, "", options)
{
}

Node::Node(
  const std::string & node_name, const std::string & namespace_, const NodeOptions & options)
: options_(options),
  base_(std::make_shared<NodeBaseInterface>(node_name, namespace_, options)),
  graph_(std::make_shared<node_interfaces::NodeGraphInterface>(base_)),
  clock_(std::make_shared<Clock>(options.clock_type())),
  clock_interface_(std::make_shared<node_interfaces::NodeClockInterface>(clock_)),
  logging_(std::make_shared<node_interfaces::NodeLoggingInterface>(base_)),
  services_interface_(std::make_shared<node_interfaces::NodeServicesInterface>(base_)),
  timers_(std::make_shared<node_interfaces::NodeTimersInterface>(base_)),
  topics_(std::make_shared<node_interfaces::NodeTopicsInterface>(base_, timers_)),
  waitables_(std::make_shared<node_interfaces::NodeWaitablesInterface>(base_)),
  services_(std::make_shared<Services>()),
  effective_namespace_(base_->get_namespace())
{
  const auto publish = [known = std::weak_ptr<Services>(services_), clock = clock_,
      name = std::string(base_->get_fully_qualified_name())](ParameterEvent & event) {
      const auto services = known.lock();
      if (services && services->events) {
        event.stamp = clock->now();
        event.node = name;
        services->events->publish(event);
      }
    };
  parameters_ = std::make_shared<node_interfaces::NodeParametersInterface>(
    overrides_for(*base_, options), options.allow_undeclared_parameters(), publish);
  if (options.start_parameter_event_publisher()) {
    const PublisherOptions publisher_options(options.parameter_event_publisher_options());
    const QoS qos = detail::overridden_qos(
      *parameters_, "/parameter_events", "publisher", options.parameter_event_qos(),
      all_usual_policies());
    services_->events = std::make_shared<Publisher<ParameterEvent>>(
      base_, "/parameter_events", qos, publisher_options);
  }
  if (options.automatically_declare_parameters_from_overrides()) {
    declare_all_overrides(*parameters_);
  }
  type_descriptions_ =
    std::make_shared<node_interfaces::NodeTypeDescriptionsInterface>(base_, *parameters_);
  time_source_ = std::make_shared<node_interfaces::NodeTimeSourceInterface>(
    base_, parameters_, clock_, options.clock_qos(), options.use_clock_thread());
  if (options.enable_logger_service()) {
    services_->loggers = detail::logger_services(base_);
  }
  if (options.start_parameter_services()) {
    services_->parameters = detail::parameter_services(base_, parameters_);
  }
}

Node::Node(const Node & other, const std::string & sub_namespace)
: options_(other.options_), base_(other.base_), graph_(other.graph_), clock_(other.clock_),
  clock_interface_(other.clock_interface_), logging_(other.logging_),
  services_interface_(other.services_interface_), timers_(other.timers_), topics_(other.topics_),
  waitables_(other.waitables_),
  parameters_(other.parameters_), type_descriptions_(other.type_descriptions_),
  time_source_(other.time_source_), services_(other.services_),
  sub_namespace_(
    other.sub_namespace_.empty() ? sub_namespace : other.sub_namespace_ + "/" + sub_namespace)
{
  if (sub_namespace.empty() || sub_namespace.front() == '/') {
    throw exceptions::NameValidationError(
            "sub_namespace", sub_namespace.c_str(), sub_namespace.empty() ?
            "sub-nodes should not extend nodes by an empty sub-namespace" :
            "a sub-namespace should not have a leading /", 0);
  }
  const std::string own = base_->get_namespace();
  effective_namespace_ = own.back() == '/' ? own + sub_namespace_ : own + "/" + sub_namespace_;
  detail::check_namespace(effective_namespace_);
}

Node::~Node() = default;

Node::SharedPtr Node::create_sub_node(const std::string & sub_namespace)
{
  struct Below : Node
  {
    Below(const Node & other, const std::string & sub_namespace) : Node(other, sub_namespace) {}
  };
  return std::make_shared<Below>(*this, sub_namespace);
}

const char * Node::get_name() const
{
  return base_->get_name();
}

const char * Node::get_namespace() const
{
  return base_->get_namespace();
}

const char * Node::get_fully_qualified_name() const
{
  return base_->get_fully_qualified_name();
}

Logger Node::get_logger() const
{
  return rclcpp::get_logger(rcl_node_get_logger_name(base_->get_rcl_node_handle()));
}

CallbackGroup::SharedPtr Node::create_callback_group(
  CallbackGroupType group_type, bool automatically_add_to_executor_with_node)
{
  return base_->create_callback_group(group_type, automatically_add_to_executor_with_node);
}

void Node::for_each_callback_group(const std::function<void(CallbackGroup::SharedPtr)> & function)
{
  base_->for_each_callback_group(function);
}

std::string Node::extended(const std::string & name) const
{
  const bool is_relative = !name.empty() && name.front() != '/' && name.front() != '~';
  return sub_namespace_.empty() || !is_relative ? name : sub_namespace_ + "/" + name;
}

QoS Node::overridden(const std::string & topic, const QoS & qos, const PublisherOptionsBase & options)
{
  const auto & overriding = options.qos_overriding_options;
  return overriding.get_policy_kinds().empty() ? qos : detail::overridden_qos(
    *parameters_, base_->resolve_topic_or_service_name(topic, false), "publisher", qos, overriding);
}

QoS Node::overridden(const std::string & topic, const QoS & qos, const SubscriptionOptionsBase & options)
{
  const auto & overriding = options.qos_overriding_options;
  return overriding.get_policy_kinds().empty() ? qos : detail::overridden_qos(
    *parameters_, base_->resolve_topic_or_service_name(topic, false), "subscription", qos, overriding);
}

Event::SharedPtr Node::get_graph_event()
{
  return std::make_shared<Event>();
}

void Node::wait_for_graph_change(Event::SharedPtr event, std::chrono::nanoseconds timeout)
{
  const auto look = [this]() {
      return std::make_tuple(
        graph_->get_node_names_and_namespaces(), graph_->get_topic_names_and_types(),
        graph_->get_service_names_and_types());
    };
  const auto changed = [look, before = look()]() {return look() != before;};
  if (detail::wait_for_graph(
      base_->get_shared_rcl_node_handle(), base_->get_context(), changed, timeout))
  {
    event->set();
  }
}

}  // namespace rclcpp
