// Says what sas_core does, one line per fact: a name, then numbers or words.

#include <atomic>
#include <chrono>
#include <functional>
#include <iomanip>
#include <iostream>
#include <string>
#include <thread>

#include <dqrobotics/utils/DQ_Math.h>
#include <sas_core/sas_core.hpp>

namespace
{

using sas::Clock;
using sas::Statistics;

std::string what_of(const std::function<void()> & action)
{
  try {
    action();
    return "nothing";
  } catch (const std::exception & error) {
    return error.what();
  }
}

void work(std::chrono::milliseconds time)
{
  std::this_thread::sleep_for(time);
}

void steady_clock_of_rounds(int rounds)
{
  Clock clock(0.05);
  clock.init();
  for (int i = 0; i < rounds; ++i) {
    work(std::chrono::milliseconds(20));
    clock.update_and_sleep();
  }
  std::cout << "elapsed " << clock.get_elapsed_time_sec() << "\n";
  std::cout << "moments " << rounds + clock.get_overrun_count() << "\n";
  for (const auto statistics : {Statistics::Mean, Statistics::Minimum, Statistics::Maximum}) {
    std::cout << "statistics";
    for (const auto time_type :
      {Clock::TimeType::Computational, Clock::TimeType::Idle, Clock::TimeType::EffectiveSampling})
    {
      std::cout << " " << clock.get_statistics(statistics, time_type);
    }
    std::cout << "\n";
  }
  std::cout << "last " << clock.get_computation_time() << " " << clock.get_sleep_time() << " " <<
    clock.get_effective_thread_sampling_time_sec() << "\n";
  std::cout << "desired " << clock.get_desired_thread_sampling_time_sec() << "\n";
}

void newer_clock()
{
  const auto began = std::chrono::system_clock::now();
  Clock clock(0.05, false);
  std::cout << "unasked " << clock.get_time(Clock::TimeType::Idle) << "\n";
  clock.init();
  clock.update_and_sleep();
  std::cout << "time " << clock.get_time(Clock::TimeType::Idle) + clock.get_time(
    Clock::TimeType::Computational) - clock.get_time(Clock::TimeType::EffectiveSampling) << "\n";
  const auto seconds = [](auto duration) {return std::chrono::duration<double>(duration).count();};
  std::cout << "wall " << seconds(clock.get_initial_time() - began) << " " <<
    seconds(clock.get_last_update_time() - clock.get_initial_time()) << "\n";
  std::cout << "unkept " << what_of(
    [&] {clock.get_statistics(Statistics::Mean, Clock::TimeType::Idle);}) << "\n";
  const auto before = std::chrono::steady_clock::now();
  clock.blocking_sleep_seconds(0.1);
  std::cout << "blocked " << seconds(std::chrono::steady_clock::now() - before) << "\n";
  std::cout << "order " << static_cast<int>(Clock::TimeType::Computational) <<
    static_cast<int>(Clock::TimeType::EffectiveSampling) << static_cast<int>(Clock::TimeType::Idle) << "\n";
}

void matrices()
{
  const auto line = [](const std::string & name, const Eigen::MatrixXd & matrix) {
      const Eigen::IOFormat format(Eigen::StreamPrecision, Eigen::DontAlignCols, " ", " / ");
      std::cout << name << " " << matrix.format(format) << "\n";
    };
  const VectorXd a = VectorXd::LinSpaced(2, 1.0, 2.0), b = VectorXd::LinSpaced(3, 3.0, 5.0);
  const Eigen::MatrixXd square = Eigen::MatrixXd::Ones(2, 2), row = 3.0 * Eigen::MatrixXd::Ones(1, 2);
  line("concatenated", sas::concatenate(a, b).transpose());
  line("concatenated", sas::concatenate(std::vector<VectorXd>{b, VectorXd(), a}).transpose());
  line("stacked", sas::vstack(square, row));
  line("stacked", sas::vstack(Eigen::MatrixXd(), row));
  line("diagonal", sas::block_diag({row, square}));
  for (const auto & part : sas::split(sas::concatenate(a, b), {1, 0, 3})) {
    line("part", part.transpose());
  }
  std::cout << "columns " << what_of([&] {sas::vstack(square, b);}) << "\n";
  std::cout << "parts " << what_of([&] {sas::split(a, {1, 2});}) << "\n";
  static_assert(sas::incremental_mean(2.0, 3, 6.0) == 3.0);
  std::cout << "samples " << what_of([] {sas::incremental_mean(2.0, -1, 6.0);}) << "\n";
}

class Named : public sas::Object
{
public:
  Named() : Object("Named") {}
};

void late_clock()
{
  Clock clock(0.01);
  clock.init();
  work(std::chrono::milliseconds(35));
  clock.update_and_sleep();
  std::cout << "missed " << clock.get_overrun_count() << "\n";
  std::atomic_bool break_loops(true);
  Clock::safe_sleep_seconds(1000.0, &break_loops);  // ends at once
}

void figures()
{
  sas::RunningStatistics statistics;
  std::cout << "empty " << statistics.get(Statistics::Mean) << "\n";
  for (const double value : {2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0}) {
    statistics.add(value);
  }
  std::cout << "figures";
  for (const auto which : {Statistics::Mean, Statistics::Variance, Statistics::StandardDeviation,
      Statistics::Minimum, Statistics::Maximum})
  {
    std::cout << " " << statistics.get(which);
  }
  std::cout << "\n";
}

void vectors()
{
  const auto doubles = sas::std_vector_double_to_vectorxd({180.0, -90.0, 0.5});
  std::cout << "radians " << deg2rad(doubles).transpose() << "\n";
  std::cout << "degrees " << rad2deg(deg2rad(doubles)).transpose() << " " << rad2deg(deg2rad(30.0)) << "\n";
  std::cout << "sizes " << sas::vectorxd_to_std_vector_double(doubles).size() << " " <<
    sas::vectorxi_to_std_vector_int(sas::std_vector_int_to_vectorxi({3, 4})).size() << " " <<
    sas::std_vector_double_to_vectorxd({}).size() << "\n";
}

class Driver : public sas::RobotDriver
{
public:
  explicit Driver(std::atomic_bool * break_loops)
  : RobotDriver(break_loops) {}
  explicit Driver(const std::shared_ptr<sas::ShutdownSignaler> & shutdown_signaler)
  : RobotDriver(shutdown_signaler) {}

  /// Whether both ways to ask say the same.
  bool ends() const {return *break_loops_ && shutdown_signaler_->should_shutdown();}

  VectorXd get_joint_positions() override {return {};}
  void set_target_joint_positions(const VectorXd &) override {}
  void connect() override {}
  void disconnect() override {}
  void initialize() override {}
  void deinitialize() override {}
};

void driver()
{
  std::atomic_bool break_loops(false);
  Driver driver(&break_loops);
  std::cout << "unmeasured " << driver.get_joint_velocities().size() << " " <<
    driver.get_joint_torques().size() << "\n";
  std::cout << "velocities " << what_of([&] {driver.set_target_joint_velocities(VectorXd(1));}) << "\n";
  std::cout << "torques " << what_of([&] {driver.set_target_joint_torques(VectorXd(1));}) << "\n";
  std::cout << "limits " << what_of([&] {driver.set_joint_limits({VectorXd(2), VectorXd(3)});}) << "\n";
  driver.set_joint_limits({VectorXd::Zero(2), VectorXd::Ones(2)});
  std::cout << "named " << Named().get_class_name() << "\n";
  const auto signaler = std::make_shared<sas::ShutdownSignaler>();
  Driver second(signaler);
  std::cout << "ends " << driver.ends() << second.ends();
  signaler->shutdown();
  sas::ShutdownSignaler(&break_loops).shutdown();
  std::cout << driver.ends() << second.ends() << "\n";
  static_assert(sas::RobotDriver::Functionality::None == sas::RobotDriver::Functionality::Unavailable);
  std::cout << "greatest " << std::get<1>(driver.get_joint_limits()).transpose() << "\n";
}

}  // namespace

int main()
{
  std::cout << std::setprecision(17);
  steady_clock_of_rounds(20);
  newer_clock();
  matrices();
  late_clock();
  std::cout << "invalid " << what_of([] {Clock clock(0.0);}) << "\n";
  figures();
  vectors();
  driver();
  return 0;
}
