#include "sas_robot_driver_myrobot/sas_robot_driver_myrobot.hpp"
#include <iostream>
#include <memory>
#include <sas_core/eigen3_std_conversions.hpp>

namespace sas
{

class RobotDriverMyrobot::Impl
{
public:
    bool connected{false};
    bool motor_on{false};

    VectorXd joint_positions_;

    Impl()
    {
    }
};

RobotDriverMyrobot::RobotDriverMyrobot(const RobotDriverMyrobotConfiguration& configuration, std::atomic_bool* break_loops):
    RobotDriver(break_loops),
    configuration_(configuration)
{
    joint_limits_ = configuration.joint_limits;
    impl_ = std::make_unique<RobotDriverMyrobot::Impl>();
}

RobotDriverMyrobot::~RobotDriverMyrobot()
{
}

VectorXd RobotDriverMyrobot::get_joint_positions()
{
    if (impl_->joint_positions_.size() == 0)
        throw std::runtime_error("There are no valid joint positions");

    return impl_->joint_positions_;
}

void RobotDriverMyrobot::set_target_joint_positions(const VectorXd& desired_joint_positions_rad)
{
    if (desired_joint_positions_rad.size() != 6)
        throw std::runtime_error("The target has the wrong size");

    impl_->joint_positions_ = desired_joint_positions_rad;
}

void RobotDriverMyrobot::connect()
{
    if (impl_->connected)
        throw std::runtime_error("There is a connection already");

    impl_->connected = true;
    impl_->motor_on = false;
    impl_->joint_positions_ = (VectorXd(6) << 0, 0, 0, 0, 0, 0).finished();
}

void RobotDriverMyrobot::initialize()
{
    impl_->motor_on = true;
}

void RobotDriverMyrobot::deinitialize()
{
    impl_->motor_on = false;
}

void RobotDriverMyrobot::disconnect()
{
    impl_->connected = false;
    impl_->joint_positions_ = VectorXd();
}

}
