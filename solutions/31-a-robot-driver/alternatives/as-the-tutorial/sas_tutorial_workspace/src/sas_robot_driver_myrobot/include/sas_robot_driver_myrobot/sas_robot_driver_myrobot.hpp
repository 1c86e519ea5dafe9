#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <tuple>

#include <sas_core/sas_robot_driver.hpp>

using namespace Eigen;

namespace sas
{

/// The robot's address, and the lowest and the highest position of each joint in radians.
struct RobotDriverMyrobotConfiguration
{
  std::string ip;
  std::tuple<VectorXd, VectorXd> joint_limits;
};

/// A silent robot: its six joints move to each target at once, and no function prints anything.
class RobotDriverMyrobot : public RobotDriver
{
public:
  RobotDriverMyrobot() = delete;
  RobotDriverMyrobot(const RobotDriverMyrobot &) = delete;
  RobotDriverMyrobot(const RobotDriverMyrobotConfiguration & settings, std::atomic_bool * stop);
  ~RobotDriverMyrobot();

  void connect() override;
  void initialize() override;
  VectorXd get_joint_positions() override;
  void set_target_joint_positions(const VectorXd & radians) override;
  void deinitialize() override;
  void disconnect() override;

private:
  class Impl;

  RobotDriverMyrobotConfiguration settings_;
  std::unique_ptr<Impl> impl_;
};

}
