#include "sas_robot_driver_myrobot.hpp"

#include <cstdio>

namespace sas
{

class RobotDriverMyrobot::Impl
{
public:
    Impl() = default;
    bool connected_ = false;
    VectorXd joint_positions_;
};

RobotDriverMyrobot::RobotDriverMyrobot(const RobotDriverMyrobotConfiguration& configuration, std::atomic_bool* break_loops):
    RobotDriver(break_loops),
    configuration_(configuration)
{
    impl_ = std::make_unique<RobotDriverMyrobot::Impl>();
    joint_limits_ = configuration_.joint_limits;
}

RobotDriverMyrobot::~RobotDriverMyrobot()
{

}

VectorXd RobotDriverMyrobot::get_joint_positions()
{
    if (not impl_->connected_)
        throw std::runtime_error("RobotDriverMyrobot::get_joint_positions::Not connected.");
    return impl_->joint_positions_;
}

void RobotDriverMyrobot::set_target_joint_positions(const VectorXd& desired_joint_positions_rad)
{
    if (desired_joint_positions_rad.size() != std::get<0>(joint_limits_).size())
        throw std::runtime_error("RobotDriverMyrobot::set_target_joint_positions::Wrong size.");
    impl_->joint_positions_ = desired_joint_positions_rad;
}

void RobotDriverMyrobot::connect()
{
    impl_->joint_positions_ = VectorXd::Zero(6);
    impl_->connected_ = true;
    std::printf("Connected.\n");
}

void RobotDriverMyrobot::disconnect()
{
    impl_->connected_ = false;
    std::printf("Disconnected.\n");
}

void RobotDriverMyrobot::initialize()
{
    std::printf("Motor on.\n");
}

void RobotDriverMyrobot::deinitialize()
{
    std::printf("Motor off.\n");
}

}
