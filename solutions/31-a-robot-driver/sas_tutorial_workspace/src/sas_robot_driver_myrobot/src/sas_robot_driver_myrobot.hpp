#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <tuple>

#include <sas_core/sas_robot_driver.hpp>

namespace sas
{

struct RobotDriverMyrobotConfiguration
{
  std::string ip;
  std::tuple<Eigen::VectorXd, Eigen::VectorXd> joint_limits;  // lowest and highest, in rad
};

/// Drives the robot myrobot, whose six joints move to each target instantly.
class RobotDriverMyrobot : public RobotDriver
{
public:
  RobotDriverMyrobot(const RobotDriverMyrobotConfiguration & configuration, std::atomic_bool * break_loops);
  ~RobotDriverMyrobot() override;

  RobotDriverMyrobot() = delete;
  RobotDriverMyrobot(const RobotDriverMyrobot &) = delete;
  RobotDriverMyrobot & operator=(const RobotDriverMyrobot &) = delete;

  Eigen::VectorXd get_joint_positions() override;
  void set_target_joint_positions(const Eigen::VectorXd & target_joint_positions_rad) override;

  void connect() override;
  void disconnect() override;

  void initialize() override;
  void deinitialize() override;

private:
  class Impl;
  std::unique_ptr<Impl> impl_;

  RobotDriverMyrobotConfiguration configuration_;
};

}  // namespace sas
