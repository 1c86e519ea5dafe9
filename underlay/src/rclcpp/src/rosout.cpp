#include "rosout.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "rcl/logging_rosout.h"
#include "rclcpp/detail/check.hpp"

namespace rclcpp::detail
{

namespace
{

// Nodes by the name of their logger, the oldest first.
using Nodes = std::map<std::string, std::vector<rcl_node_t *>>;

Nodes & nodes()
{
  // Never destroyed, as rcl's own map is not: it is for the whole program, too.
  static Nodes & instance = *std::make_unique<Nodes>().release();
  return instance;
}

}  // namespace

void begin_rosout(rcl_node_t & node)
{
  // Of another node of that name rcl only warns.
  check(rcl_logging_rosout_init_publisher_for_node(&node), "failed to make /rosout");
  nodes()[rcl_node_get_logger_name(&node)].push_back(&node);
}

void end_rosout(rcl_node_t & node) noexcept
{
  const auto named = nodes().find(rcl_node_get_logger_name(&node));
  if (named == nodes().end()) {
    return;
  }
  auto & same = named->second;
  const bool is_speaker = same.front() == &node;
  same.erase(std::remove(same.begin(), same.end(), &node), same.end());
  if (is_speaker && rcl_logging_rosout_fini_publisher_for_node(&node) != RCL_RET_OK) {
    rcl_reset_error();
  }
  if (same.empty()) {
    nodes().erase(named);
  } else if (is_speaker && rcl_logging_rosout_init_publisher_for_node(same.front()) != RCL_RET_OK) {
    rcl_reset_error();
  }
}

void forget_rosout()
{
  nodes().clear();
}

}  // namespace rclcpp::detail
