#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <tuple>

#include <sas_core/sas_robot_driver.hpp>

using namespace Eigen;

namespace sas
{

// ip: the robot's address. joint_limits: the lowest and the highest positions, in radians.
struct RobotDriverMyrobotConfiguration
{
    std::string ip;
    std::tuple<VectorXd, VectorXd> joint_limits;
};

class RobotDriverMyrobot : public RobotDriver
{
    class Impl;
    const RobotDriverMyrobotConfiguration configuration_;
    const std::unique_ptr<Impl> impl_;

public:
    RobotDriverMyrobot(const RobotDriverMyrobotConfiguration& given, std::atomic_bool* flag);
    RobotDriverMyrobot(const RobotDriverMyrobot&) = delete;
    ~RobotDriverMyrobot() override;

    // Each pair is called once, at the beginning and at the end.
    void connect() override;
    void disconnect() override;
    void initialize() override;
    void deinitialize() override;

    // These two are called in each cycle.
    VectorXd get_joint_positions() override;
    void set_target_joint_positions(const VectorXd& radians) override;
};

}
