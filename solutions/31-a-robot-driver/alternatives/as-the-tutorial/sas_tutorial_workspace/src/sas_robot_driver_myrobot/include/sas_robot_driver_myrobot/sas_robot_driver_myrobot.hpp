#pragma once

#include <atomic>
#include <memory>
#include <sas_core/sas_robot_driver.hpp>

using namespace Eigen;

namespace sas
{

struct RobotDriverMyrobotConfiguration
{
    std::string ip;
    std::tuple<VectorXd, VectorXd> joint_limits;
};

class RobotDriverMyrobot: public RobotDriver
{
private:
    RobotDriverMyrobotConfiguration configuration_;

    class Impl;
    std::unique_ptr<Impl> impl_;

public:
    RobotDriverMyrobot(const RobotDriverMyrobot&)=delete;
    RobotDriverMyrobot()=delete;
    ~RobotDriverMyrobot();

    RobotDriverMyrobot(const RobotDriverMyrobotConfiguration& configuration, std::atomic_bool* break_loops);

    VectorXd get_joint_positions() override;
    void set_target_joint_positions(const VectorXd& desired_joint_positions_rad) override;

    void connect() override;
    void disconnect() override;

    void initialize() override;
    void deinitialize() override;
};

}
