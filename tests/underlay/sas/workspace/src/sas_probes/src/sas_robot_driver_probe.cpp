#include "sas_robot_driver_probe.hpp"

#include <iostream>
#include <stdexcept>

#include <dqrobotics/utils/DQ_Math.h>

namespace sas
{

class RobotDriverProbe::Impl
{
public:
  VectorXd joint_positions;
  int rounds = 0;
};

RobotDriverProbe::RobotDriverProbe(
  const RobotDriverProbeConfiguration & configuration, std::atomic_bool * break_loops)
: RobotDriver(break_loops), configuration_(configuration)
{
  impl_ = std::make_unique<RobotDriverProbe::Impl>();
  joint_limits_ = configuration.joint_limits;
}

RobotDriverProbe::~RobotDriverProbe() = default;

void RobotDriverProbe::call(const std::string & name)
{
  std::cout << "call " << name << " " << *break_loops_ << std::endl;
  if (configuration_.fail_in == name) {
    throw std::runtime_error("the probe fails in " + name);
  }
}

VectorXd RobotDriverProbe::get_joint_positions()
{
  if (++impl_->rounds == 50 && configuration_.fail_in == "loop") {
    throw 50;
  }
  return impl_->joint_positions;
}

void RobotDriverProbe::set_target_joint_positions(const VectorXd & set_target_joint_positions_rad)
{
  if (set_target_joint_positions_rad.size() != impl_->joint_positions.size()) {
    throw std::runtime_error("a target of another size");
  }
  impl_->joint_positions = set_target_joint_positions_rad;
}

void RobotDriverProbe::connect()
{
  call("connect");
  impl_->joint_positions = deg2rad(VectorXd::Zero(6).eval());
}

void RobotDriverProbe::disconnect()
{
  call("disconnect");
}

void RobotDriverProbe::initialize()
{
  call("initialize");
}

void RobotDriverProbe::deinitialize()
{
  call("deinitialize");
}

}  // namespace sas
