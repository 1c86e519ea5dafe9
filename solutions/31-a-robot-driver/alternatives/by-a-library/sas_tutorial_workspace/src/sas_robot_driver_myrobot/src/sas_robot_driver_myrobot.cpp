#include "sas_robot_driver_myrobot.hpp"

#include <cstdio>
#include <stdexcept>

namespace sas
{

class RobotDriverMyrobot::Impl
{
public:
    bool there = false;
    VectorXd joints;
};

RobotDriverMyrobot::RobotDriverMyrobot(const RobotDriverMyrobotConfiguration& given, std::atomic_bool* flag)
    : RobotDriver(flag), configuration_(given), impl_(std::make_unique<Impl>())
{
    joint_limits_ = configuration_.joint_limits;
}

RobotDriverMyrobot::~RobotDriverMyrobot() = default;

void RobotDriverMyrobot::connect()
{
    impl_->joints = VectorXd::Zero(6);
    impl_->there = true;
    std::printf("Connected.\n");
}

void RobotDriverMyrobot::disconnect()
{
    impl_->there = false;
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

VectorXd RobotDriverMyrobot::get_joint_positions()
{
    if (not impl_->there)
        throw std::runtime_error("There is no robot to ask.");
    return impl_->joints;
}

void RobotDriverMyrobot::set_target_joint_positions(const VectorXd& radians)
{
    const auto& lowest = std::get<0>(joint_limits_);
    if (radians.size() != lowest.size())
        throw std::runtime_error("This target is for another robot.");
    impl_->joints = radians;
}

}
