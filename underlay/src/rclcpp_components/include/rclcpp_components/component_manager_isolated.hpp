#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <thread>
#include <utility>

#include "rclcpp_components/component_manager.hpp"

namespace rclcpp_components
{

/// Gives each component an executor and a thread of its own, so that none waits for another.
template<typename ExecutorT = rclcpp::executors::SingleThreadedExecutor>
class ComponentManagerIsolated : public ComponentManager
{
public:
  using ComponentManager::ComponentManager;
  ~ComponentManagerIsolated() override
  {
    running_.clear();
    node_wrappers_.clear();
  }

protected:
  void add_node_to_executor(std::uint64_t node_id) override
  {
    auto executor = std::make_shared<ExecutorT>();
    executor->add_node(node_wrappers_[node_id].get_node_base_interface());
    running_.emplace(node_id, std::make_unique<Running>(std::move(executor)));
  }

  void remove_node_from_executor(std::uint64_t node_id) override {running_.erase(node_id);}

private:
  /// An executor that spins until this goes.
  class Running
  {
public:
    explicit Running(std::shared_ptr<ExecutorT> executor)
    : executor_(std::move(executor)), thread_([this]() {executor_->spin(); is_over_ = true;})
    {
    }
    Running(const Running &) = delete;
    Running & operator=(const Running &) = delete;
    ~Running()
    {
      // What is canceled before it spins would spin nevertheless.
      while (!executor_->is_spinning() && !is_over_) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
      executor_->cancel();
      thread_.join();
    }

private:
    std::shared_ptr<ExecutorT> executor_;
    std::atomic<bool> is_over_{false};
    std::thread thread_;
  };

  std::map<std::uint64_t, std::unique_ptr<Running>> running_;
};

}  // namespace rclcpp_components
