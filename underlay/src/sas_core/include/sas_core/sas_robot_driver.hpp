// What every robot driver offers. Derive from it for a robot; RobotDriverROS runs it.

#pragma once

#include <atomic>
#include <memory>
#include <tuple>

#include <Eigen/Dense>
#include <sas_core/sas_shutdown_signaler.hpp>

namespace sas
{

/// Positions are in rad, one element per joint.
///
/// Life: connect(), initialize(), then positions are read and targets set in turn, then deinitialize() and
/// disconnect(), which are called whatever happened before and must not throw.
class RobotDriver
{
public:
  /// What a robot can be told to do.
  enum class Functionality
  {
    None = 0,
    Unavailable = None,
    PositionControl,
    VelocityControl,
    ForceControl,
    Homing,
    ClearPositions
  };

  RobotDriver() = delete;
  RobotDriver(const RobotDriver &) = delete;
  RobotDriver & operator=(const RobotDriver &) = delete;
  virtual ~RobotDriver() = default;

  virtual Eigen::VectorXd get_joint_positions() = 0;
  virtual void set_target_joint_positions(const Eigen::VectorXd & target_joint_positions_rad) = 0;

  /// Open and close the way to the robot.
  virtual void connect() = 0;
  virtual void disconnect() = 0;

  /// Switch the robot on and off.
  virtual void initialize() = 0;
  virtual void deinitialize() = 0;

  /// Empty for a robot that does not measure them.
  virtual Eigen::VectorXd get_joint_velocities();
  virtual Eigen::VectorXd get_joint_torques();

  /// Throw std::runtime_error for a robot that does not take them.
  virtual void set_target_joint_velocities(const Eigen::VectorXd & target_joint_velocities);
  virtual void set_target_joint_torques(const Eigen::VectorXd & target_joint_torques);

  /// Least and greatest positions.
  virtual std::tuple<Eigen::VectorXd, Eigen::VectorXd> get_joint_limits();

  /// Throws std::runtime_error when there are not as many least positions as greatest ones.
  virtual void set_joint_limits(const std::tuple<Eigen::VectorXd, Eigen::VectorXd> & joint_limits);

protected:
  /// A driver's own loops end when `shutdown_signaler` says so.
  explicit RobotDriver(const std::shared_ptr<ShutdownSignaler> & shutdown_signaler);

  /// `break_loops` belongs to the program: a driver's own loops end when it is true.
  explicit RobotDriver(std::atomic_bool * break_loops);

  std::shared_ptr<ShutdownSignaler> shutdown_signaler_;
  std::atomic_bool * break_loops_;  // the same, as a flag
  std::tuple<Eigen::VectorXd, Eigen::VectorXd> joint_limits_;
};

}  // namespace sas

using namespace Eigen;  // NOLINT: drivers of this family write VectorXd without a namespace
