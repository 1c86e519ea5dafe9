#pragma once

#include <atomic>

namespace rclcpp_lifecycle
{

/// What is switched on and off with its node.
class ManagedEntityInterface
{
public:
  virtual ~ManagedEntityInterface() = default;
  virtual void on_activate() = 0;
  virtual void on_deactivate() = 0;
};

/// Knows whether it is on.
class SimpleManagedEntity : public ManagedEntityInterface
{
public:
  void on_activate() override {activated_ = true;}
  void on_deactivate() override {activated_ = false;}
  bool is_activated() const {return activated_;}

private:
  std::atomic<bool> activated_{false};
};

}  // namespace rclcpp_lifecycle
