#pragma once

#include <memory>
#include <string>
#include <vector>

#include "rcl/node_options.h"
#include "rclcpp/context.hpp"
#include "rclcpp/contexts/default_context.hpp"
#include "rclcpp/parameter.hpp"
#include "rclcpp/publisher_options.hpp"
#include "rclcpp/qos.hpp"

namespace rclcpp
{

/// How a node begins. Each setter gives the options back, so that calls can be chained.
class NodeOptions
{
public:
  explicit NodeOptions(rcl_allocator_t allocator = rcl_get_default_allocator()) : allocator_(allocator) {}

  /// Throws UnknownROSArgsError for arguments of this node that ROS does not know.
  const rcl_node_options_t * get_rcl_node_options() const;

  Context::SharedPtr context() const {return context_;}
  NodeOptions & context(Context::SharedPtr context);

  /// Words as on the command line, for this node alone: {"--ros-args", "-r", "chatter:=news"}.
  const std::vector<std::string> & arguments() const {return arguments_;}
  NodeOptions & arguments(const std::vector<std::string> & arguments);

  std::vector<Parameter> & parameter_overrides() {return parameter_overrides_;}
  const std::vector<Parameter> & parameter_overrides() const {return parameter_overrides_;}
  NodeOptions & parameter_overrides(const std::vector<Parameter> & parameter_overrides);
  template<typename ParameterT>
  NodeOptions & append_parameter_override(const std::string & name, const ParameterT & value)
  {
    parameter_overrides_.emplace_back(name, value);
    return *this;
  }

  bool use_global_arguments() const {return use_global_arguments_;}
  NodeOptions & use_global_arguments(bool use_global_arguments);
  bool enable_rosout() const {return enable_rosout_;}
  NodeOptions & enable_rosout(bool enable_rosout);

  /// Whether others may read and set levels of loggers, by the services get_ and set_logger_levels.
  bool enable_logger_service() const {return enable_logger_service_;}
  NodeOptions & enable_logger_service(bool enable_logger_service);

  /// Whether messages to nodes of this process are handed over without the middleware.
  bool use_intra_process_comms() const {return use_intra_process_comms_;}
  NodeOptions & use_intra_process_comms(bool use_intra_process_comms);

  /// Statistics are not taken.
  bool enable_topic_statistics() const {return enable_topic_statistics_;}
  NodeOptions & enable_topic_statistics(bool enable_topic_statistics);

  bool start_parameter_services() const {return start_parameter_services_;}
  NodeOptions & start_parameter_services(bool start_parameter_services);
  bool start_parameter_event_publisher() const {return start_parameter_event_publisher_;}
  NodeOptions & start_parameter_event_publisher(bool start_parameter_event_publisher);

  rcl_clock_type_t clock_type() const {return clock_type_;}
  NodeOptions & clock_type(rcl_clock_type_t clock_type);
  const QoS & clock_qos() const {return clock_qos_;}
  NodeOptions & clock_qos(const QoS & clock_qos);
  /// Whether /clock is heard in a thread of its own, so that simulated time goes on while callbacks run.
  bool use_clock_thread() const {return use_clock_thread_;}
  NodeOptions & use_clock_thread(bool use_clock_thread);

  const QoS & parameter_event_qos() const {return parameter_event_qos_;}
  NodeOptions & parameter_event_qos(const QoS & parameter_event_qos);
  const QoS & rosout_qos() const {return rosout_qos_;}
  NodeOptions & rosout_qos(const QoS & rosout_qos);
  const PublisherOptionsBase & parameter_event_publisher_options() const
  {
    return parameter_event_publisher_options_;
  }
  NodeOptions & parameter_event_publisher_options(const PublisherOptionsBase & options);

  bool allow_undeclared_parameters() const {return allow_undeclared_parameters_;}
  NodeOptions & allow_undeclared_parameters(bool allow_undeclared_parameters);
  bool automatically_declare_parameters_from_overrides() const {return automatically_declare_;}
  NodeOptions & automatically_declare_parameters_from_overrides(bool automatically_declare);

  const rcl_allocator_t & allocator() const {return allocator_;}
  NodeOptions & allocator(rcl_allocator_t allocator);

private:
  Context::SharedPtr context_ = contexts::get_global_default_context();
  std::vector<std::string> arguments_;
  std::vector<Parameter> parameter_overrides_;
  bool use_global_arguments_ = true;
  bool enable_rosout_ = true;
  bool enable_logger_service_ = false;
  bool use_intra_process_comms_ = false;
  bool enable_topic_statistics_ = false;
  bool start_parameter_services_ = true;
  bool start_parameter_event_publisher_ = true;
  rcl_clock_type_t clock_type_ = RCL_ROS_TIME;
  QoS clock_qos_ = ClockQoS();
  bool use_clock_thread_ = true;
  QoS parameter_event_qos_ = ParameterEventsQoS();
  QoS rosout_qos_ = RosoutQoS();
  PublisherOptionsBase parameter_event_publisher_options_;
  bool allow_undeclared_parameters_ = false;
  bool automatically_declare_ = false;
  rcl_allocator_t allocator_;

  // Made when it is asked for, and shared by copies; a setter throws it away.
  mutable std::shared_ptr<rcl_node_options_t> rcl_options_;
};

}  // namespace rclcpp
