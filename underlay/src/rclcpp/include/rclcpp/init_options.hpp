#pragma once

#include <cstddef>
#include <memory>

#include "rcl/allocator.h"
#include "rcl/init_options.h"

namespace rclcpp
{

/// How a context begins: the domain, who configures logging, whether SIGINT and SIGTERM end it.
class InitOptions
{
public:
  explicit InitOptions(rcl_allocator_t allocator = rcl_get_default_allocator());
  explicit InitOptions(const rcl_init_options_t & init_options);

  /// Whether a signal that rclcpp handles shuts this context down.
  bool shutdown_on_signal = true;

  bool auto_initialize_logging() const {return initialize_logging_;}
  InitOptions & auto_initialize_logging(bool initialize_logging);

  /// Sets the domain to the one that ROS_DOMAIN_ID has now.
  void use_default_domain_id();
  void set_domain_id(std::size_t domain_id);
  std::size_t get_domain_id() const;

  const rcl_init_options_t * get_rcl_init_options() const;

private:
  // Shared while it is only read, copied before it is changed.
  rcl_init_options_t & own();

  std::shared_ptr<rcl_init_options_t> options_;
  bool initialize_logging_ = true;
};

}  // namespace rclcpp
