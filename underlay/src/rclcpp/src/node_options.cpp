#include "rclcpp/node_options.hpp"

#include <utility>

#include "arguments.hpp"
#include "rclcpp/detail/check.hpp"

namespace rclcpp
{

namespace
{

void finish_node_options(rcl_node_options_t * options)
{
  if (rcl_node_options_fini(options) != RCL_RET_OK) {
    rcl_reset_error();
  }
  std::default_delete<rcl_node_options_t>()(options);
}

void parse(rcl_node_options_t & options, const std::vector<std::string> & arguments)
{
  std::vector<const char *> words;
  for (const auto & word : arguments) {
    words.push_back(word.c_str());
  }
  const rcl_ret_t ret = rcl_parse_arguments(
    static_cast<int>(words.size()), words.data(), options.allocator, &options.arguments);
  detail::check(ret, "failed to parse arguments");
  auto unknown = detail::unknown_ros_arguments(options.arguments, words);
  if (!unknown.empty()) {
    throw exceptions::UnknownROSArgsError(std::move(unknown));
  }
}

}  // namespace

const rcl_node_options_t * NodeOptions::get_rcl_node_options() const
{
  if (!rcl_options_) {
    rcl_options_ = {
      std::make_unique<rcl_node_options_t>(rcl_node_get_default_options()).release(), finish_node_options};
    rcl_options_->allocator = allocator_;
    rcl_options_->use_global_arguments = use_global_arguments_;
    rcl_options_->enable_rosout = enable_rosout_;
    rcl_options_->rosout_qos = rosout_qos_.get_rmw_qos_profile();
    parse(*rcl_options_, arguments_);
  }
  return rcl_options_.get();
}

NodeOptions & NodeOptions::context(Context::SharedPtr context)
{
  context_ = std::move(context);
  return *this;
}

NodeOptions & NodeOptions::arguments(const std::vector<std::string> & arguments)
{
  rcl_options_.reset();
  arguments_ = arguments;
  return *this;
}

NodeOptions & NodeOptions::parameter_overrides(const std::vector<Parameter> & parameter_overrides)
{
  parameter_overrides_ = parameter_overrides;
  return *this;
}

NodeOptions & NodeOptions::use_global_arguments(bool use_global_arguments)
{
  rcl_options_.reset();
  use_global_arguments_ = use_global_arguments;
  return *this;
}

NodeOptions & NodeOptions::enable_rosout(bool enable_rosout)
{
  rcl_options_.reset();
  enable_rosout_ = enable_rosout;
  return *this;
}

NodeOptions & NodeOptions::enable_logger_service(bool enable_logger_service)
{
  enable_logger_service_ = enable_logger_service;
  return *this;
}

NodeOptions & NodeOptions::use_intra_process_comms(bool use_intra_process_comms)
{
  use_intra_process_comms_ = use_intra_process_comms;
  return *this;
}

NodeOptions & NodeOptions::enable_topic_statistics(bool enable_topic_statistics)
{
  enable_topic_statistics_ = enable_topic_statistics;
  return *this;
}

NodeOptions & NodeOptions::start_parameter_services(bool start_parameter_services)
{
  start_parameter_services_ = start_parameter_services;
  return *this;
}

NodeOptions & NodeOptions::start_parameter_event_publisher(bool start_parameter_event_publisher)
{
  start_parameter_event_publisher_ = start_parameter_event_publisher;
  return *this;
}

NodeOptions & NodeOptions::clock_type(rcl_clock_type_t clock_type)
{
  clock_type_ = clock_type;
  return *this;
}

NodeOptions & NodeOptions::clock_qos(const QoS & clock_qos)
{
  clock_qos_ = clock_qos;
  return *this;
}

NodeOptions & NodeOptions::use_clock_thread(bool use_clock_thread)
{
  use_clock_thread_ = use_clock_thread;
  return *this;
}

NodeOptions & NodeOptions::parameter_event_qos(const QoS & parameter_event_qos)
{
  parameter_event_qos_ = parameter_event_qos;
  return *this;
}

NodeOptions & NodeOptions::rosout_qos(const QoS & rosout_qos)
{
  rcl_options_.reset();
  rosout_qos_ = rosout_qos;
  return *this;
}

NodeOptions & NodeOptions::parameter_event_publisher_options(const PublisherOptionsBase & options)
{
  parameter_event_publisher_options_ = options;
  return *this;
}

NodeOptions & NodeOptions::allow_undeclared_parameters(bool allow_undeclared_parameters)
{
  allow_undeclared_parameters_ = allow_undeclared_parameters;
  return *this;
}

NodeOptions & NodeOptions::automatically_declare_parameters_from_overrides(bool automatically_declare)
{
  automatically_declare_ = automatically_declare;
  return *this;
}

NodeOptions & NodeOptions::allocator(rcl_allocator_t allocator)
{
  rcl_options_.reset();
  allocator_ = allocator;
  return *this;
}

}  // namespace rclcpp
