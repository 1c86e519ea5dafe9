#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <tuple>

#include <sas_core/sas_robot_driver.hpp>

namespace sas
{

struct RobotDriverProbeConfiguration
{
  std::string ip;
  std::tuple<VectorXd, VectorXd> joint_limits;
  std::string fail_in;  // the call that throws
};

/// Six joints; prints each call of its life.
class RobotDriverProbe : public RobotDriver
{
private:
  RobotDriverProbeConfiguration configuration_;

  class Impl;
  std::unique_ptr<Impl> impl_;

  void call(const std::string & name);

public:
  RobotDriverProbe(const RobotDriverProbe &) = delete;
  RobotDriverProbe() = delete;
  ~RobotDriverProbe();

  RobotDriverProbe(const RobotDriverProbeConfiguration & configuration, std::atomic_bool * break_loops);

  VectorXd get_joint_positions() override;
  void set_target_joint_positions(const VectorXd & set_target_joint_positions_rad) override;

  void connect() override;
  void disconnect() override;

  void initialize() override;
  void deinitialize() override;
};

}  // namespace sas
