#pragma once

#include <atomic>
#include <memory>

#include <sas_core/sas_robot_driver.hpp>
#include <sas_robot_driver_myrobot/configuration.hpp>

class Joints;

namespace sas
{

class RobotDriverMyrobot : public RobotDriver
{
public:
  RobotDriverMyrobot(const RobotDriverMyrobotConfiguration & configuration, std::atomic_bool * break_loops);
  ~RobotDriverMyrobot() override;
  RobotDriverMyrobot(const RobotDriverMyrobot &) = delete;
  RobotDriverMyrobot & operator=(const RobotDriverMyrobot &) = delete;

  VectorXd get_joint_positions() override;
  void set_target_joint_positions(const VectorXd & target) override;
  void connect() override;
  void disconnect() override;
  void initialize() override;
  void deinitialize() override;

private:
  std::unique_ptr<Joints> joints_;  // empty while there is no connection
};

}  // namespace sas
