#pragma once

#include <array>
#include <atomic>
#include <iostream>
#include <stdexcept>
#include <string>
#include <tuple>

#include <sas_core/sas_robot_driver.hpp>

namespace sas
{

struct RobotDriverMyrobotConfiguration
{
  std::string ip;
  std::tuple<VectorXd, VectorXd> joint_limits;
};

class RobotDriverMyrobot final : public RobotDriver
{
public:
  RobotDriverMyrobot(const RobotDriverMyrobotConfiguration & configuration, std::atomic_bool * break_loops)
  : RobotDriver(break_loops), ip_(configuration.ip)
  {
    set_joint_limits(configuration.joint_limits);
  }

  VectorXd get_joint_positions() override;
  void set_target_joint_positions(const VectorXd & target) override;

  void connect() override
  {
    connected_ = true;
    positions_.fill(0.0);
    std::cout << "Connected to " << ip_ << "." << std::endl;
  }

  void disconnect() noexcept override
  {
    connected_ = false;
    std::cout << "Disconnected." << std::endl;
  }

  void initialize() override
  {
    std::cout << "Motor on." << std::endl;
  }

  void deinitialize() noexcept override
  {
    std::cout << "Motor off." << std::endl;
  }

private:
  std::string ip_;
  bool connected_ = false;
  std::array<double, 6> positions_{};
};

}  // namespace sas
