#include "graph_wait.hpp"

#include <algorithm>
#include <vector>

#include "rcl/graph.h"
#include "rclcpp/exceptions.hpp"
#include "wait_set.hpp"

namespace rclcpp::detail
{

namespace
{

using std::chrono::nanoseconds;

// One who waits for a change takes the news from others who wait at the same time: look again after this.
constexpr std::chrono::milliseconds slice{50};

class GraphChange : public Entity
{
public:
  explicit GraphChange(const rcl_node_t & node) : condition_(rcl_node_get_graph_guard_condition(&node)) {}
  EntityKind kind() const noexcept override {return EntityKind::guard_condition;}
  const void * rcl_entity() const noexcept override {return condition_;}
  void execute() override {}

private:
  const rcl_guard_condition_t * condition_;
};

/// As `wait_for_graph`, of a context that goes on as long as this takes.
bool wait_in_slices(
  const std::shared_ptr<rcl_node_t> & node, const Context::SharedPtr & context,
  const std::function<bool()> & holds, nanoseconds timeout)
{
  const auto began = std::chrono::steady_clock::now();
  const std::vector<std::shared_ptr<Entity>> change{std::make_shared<GraphChange>(*node)};
  const GuardCondition never(context);
  WaitSet set(context);
  while (context->is_valid() && !holds()) {
    nanoseconds left = slice;
    if (timeout > nanoseconds(0)) {
      left = std::min<nanoseconds>(timeout - (std::chrono::steady_clock::now() - began), slice);
    }
    if (left <= nanoseconds(0)) {
      return false;
    }
    set.wait(change, never, left);
  }
  return holds();
}

}  // namespace

bool wait_for_graph(
  const std::shared_ptr<rcl_node_t> & node, const Context::SharedPtr & context,
  const std::function<bool()> & holds, nanoseconds timeout)
{
  if (holds() || timeout == nanoseconds(0) || !context->is_valid()) {
    return holds();
  }
  try {
    return wait_in_slices(node, context, holds, timeout);
  } catch (const exceptions::RCLError &) {
    if (context->is_valid()) {
      throw;
    }
    return false;
  }
}

}  // namespace rclcpp::detail
