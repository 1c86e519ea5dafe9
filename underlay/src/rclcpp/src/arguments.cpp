#include "arguments.hpp"

#include <memory>

#include "deallocate.hpp"
#include "rclcpp/detail/check.hpp"
#include "rclcpp/utilities.hpp"

namespace rclcpp
{

namespace
{

/// Arguments that were parsed only to be looked at.
class Parsed
{
public:
  Parsed(int argc, char const * const * argv)
  {
    detail::check(
      rcl_parse_arguments(argc, argv, rcl_get_default_allocator(), &arguments_),
      "failed to parse arguments");
  }
  Parsed(const Parsed &) = delete;
  Parsed & operator=(const Parsed &) = delete;
  ~Parsed()
  {
    if (rcl_arguments_fini(&arguments_) != RCL_RET_OK) {
      rcl_reset_error();
    }
  }
  const rcl_arguments_t & get() const {return arguments_;}

private:
  rcl_arguments_t arguments_ = rcl_get_zero_initialized_arguments();
};

}  // namespace

std::vector<std::string> detail::unknown_ros_arguments(
  const rcl_arguments_t & parsed, const std::vector<const char *> & words)
{
  const int count = rcl_arguments_get_count_unparsed_ros(&parsed);
  if (count <= 0) {
    return {};
  }
  int * found = nullptr;
  check(
    rcl_arguments_get_unparsed_ros(&parsed, rcl_get_default_allocator(), &found),
    "failed to get unparsed ROS arguments");
  const std::unique_ptr<int, Deallocate> indices(found);
  std::vector<std::string> unknown;
  for (int i = 0; i < count; ++i) {
    unknown.emplace_back(words[static_cast<std::size_t>(indices.get()[i])]);
  }
  return unknown;
}

std::vector<std::string> remove_ros_arguments(int argc, char const * const * argv)
{
  const Parsed parsed(argc, argv);
  int count = 0;
  const char ** found = nullptr;
  detail::check(
    rcl_remove_ros_arguments(argv, &parsed.get(), rcl_get_default_allocator(), &count, &found),
    "failed to remove ROS arguments");
  const std::unique_ptr<const char *, detail::Deallocate> words(found);
  return {words.get(), words.get() + count};
}

std::vector<std::string> init_and_remove_ros_arguments(
  int argc, char const * const * argv, const InitOptions & init_options)
{
  init(argc, argv, init_options);
  return remove_ros_arguments(argc, argv);
}

}  // namespace rclcpp
