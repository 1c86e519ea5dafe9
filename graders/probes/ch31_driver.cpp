// Calls the driver as RobotDriverROS would, and as it never would. The argument selects the question: a driver that
// ends the whole program in one run must not stop the others from being checked.
#include "ask.hpp"
#include "sas_robot_driver_myrobot.hpp"

#include <atomic>
#include <string>
#include <vector>

namespace {

using Driver = sas::RobotDriverMyrobot;

std::atomic_bool flag(false);

sas::RobotDriverMyrobotConfiguration configuration() {
  sas::RobotDriverMyrobotConfiguration made;
  made.ip = "127.0.0.1";
  made.joint_limits = {Eigen::VectorXd::Constant(6, -2.0), Eigen::VectorXd::Constant(6, 3.0)};
  return made;
}

std::vector<double> numbers(const Eigen::VectorXd& vector) { return {vector.data(), vector.data() + vector.size()}; }

Eigen::VectorXd target(int joints) {
  Eigen::VectorXd made(joints);
  for (int joint = 0; joint < joints; ++joint) {
    made[joint] = 0.25 * (joint + 1);
  }
  return made;
}

// Whether there are more questions.
bool begin(Driver& driver) {
  bool begun = false;
  ask("connect", [&] { driver.connect(); });
  ask("initialize", [&] {
    driver.initialize();
    begun = true;
  });
  return begun;
}

void whole_life() {
  Driver driver(configuration(), &flag);
  if (!begin(driver)) {
    return;
  }
  ask("zeros", [&] { return numbers(driver.get_joint_positions()); });
  ask("follows", [&] {
    driver.set_target_joint_positions(target(6));
    return numbers(driver.get_joint_positions());
  });
}

void without_connection() {
  Driver driver(configuration(), &flag);
  ask("early", [&] { return numbers(driver.get_joint_positions()); });
}

void wrong_targets() {
  Driver driver(configuration(), &flag);
  if (!begin(driver)) {
    return;
  }
  ask("five", [&] { driver.set_target_joint_positions(target(5)); });
  ask("seven", [&] { driver.set_target_joint_positions(target(7)); });
}

void ends() {
  Driver never(configuration(), &flag);
  ask("deinitialize at once", [&] { never.deinitialize(); });
  ask("disconnect at once", [&] { never.disconnect(); });
  Driver driver(configuration(), &flag);
  if (!begin(driver)) {
    return;
  }
  ask("deinitialize", [&] { driver.deinitialize(); });
  ask("disconnect", [&] { driver.disconnect(); });
  ask("late", [&] { return numbers(driver.get_joint_positions()); });
  ask("deinitialize again", [&] { driver.deinitialize(); });
  ask("disconnect again", [&] { driver.disconnect(); });
}

}  // namespace

int main(int, char** arguments) {
  const std::string asked = arguments[1];
  if (asked == "life") {
    whole_life();
  } else if (asked == "early") {
    without_connection();
  } else if (asked == "wrong") {
    wrong_targets();
  } else {
    ends();
  }
  done();
  return 0;
}
