#include "rclcpp/init_options.hpp"

#include "rcl/domain_id.h"
#include "rclcpp/detail/check.hpp"

namespace rclcpp
{

namespace
{

void finish_init_options(rcl_init_options_t * options)
{
  if (rcl_init_options_fini(options) != RCL_RET_OK) {
    rcl_reset_error();
  }
  std::default_delete<rcl_init_options_t>()(options);
}

std::shared_ptr<rcl_init_options_t> copy_of(const rcl_init_options_t & source)
{
  auto options = std::make_unique<rcl_init_options_t>(rcl_get_zero_initialized_init_options());
  detail::check(rcl_init_options_copy(&source, options.get()), "failed to copy rcl init options");
  return {options.release(), finish_init_options};
}

}  // namespace

InitOptions::InitOptions(rcl_allocator_t allocator)
{
  auto options = std::make_unique<rcl_init_options_t>(rcl_get_zero_initialized_init_options());
  detail::check(rcl_init_options_init(options.get(), allocator), "failed to initialize rcl init options");
  options_ = {options.release(), finish_init_options};
}

InitOptions::InitOptions(const rcl_init_options_t & init_options)
: options_(copy_of(init_options))
{
}

rcl_init_options_t & InitOptions::own()
{
  options_ = copy_of(*options_);
  return *options_;
}

InitOptions & InitOptions::auto_initialize_logging(bool initialize_logging)
{
  initialize_logging_ = initialize_logging;
  return *this;
}

void InitOptions::set_domain_id(std::size_t domain_id)
{
  detail::check(
    rcl_init_options_set_domain_id(&own(), domain_id), "failed to set domain id to rcl init options");
}

void InitOptions::use_default_domain_id()
{
  std::size_t domain_id = RCL_DEFAULT_DOMAIN_ID;
  detail::check(rcl_get_default_domain_id(&domain_id), "failed to get default domain id");
  set_domain_id(domain_id);
}

std::size_t InitOptions::get_domain_id() const
{
  std::size_t domain_id = 0;
  detail::check(
    rcl_init_options_get_domain_id(options_.get(), &domain_id),
    "failed to get domain id from rcl init options");
  return domain_id;
}

const rcl_init_options_t * InitOptions::get_rcl_init_options() const
{
  return options_.get();
}

}  // namespace rclcpp
