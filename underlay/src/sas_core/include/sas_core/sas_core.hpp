// All of sas_core.

#pragma once

#include <stdexcept>
#include <vector>

#include <Eigen/Dense>
#include <sas_core/eigen3_std_conversions.hpp>
#include <sas_core/sas_clock.hpp>
#include <sas_core/sas_object.hpp>
#include <sas_core/sas_robot_driver.hpp>
#include <sas_core/sas_shutdown_signaler.hpp>
#include <sas_core/sas_statistics.hpp>

namespace sas
{

/// The mean of so many samples and one more. Throws std::range_error for a negative number of samples.
template<class T>
constexpr T incremental_mean(
  const T & current_mean, const int & current_number_of_samples, const T & new_sample)
{
  if (current_number_of_samples < 0) {
    throw std::range_error("sas::incremental_mean: the number of samples must not be negative.");
  }
  return (current_mean * current_number_of_samples + new_sample) / (current_number_of_samples + 1);
}

/// One vector of all elements, in order.
Eigen::VectorXd concatenate(const Eigen::VectorXd & a, const Eigen::VectorXd & b);
Eigen::VectorXd concatenate(const std::vector<Eigen::VectorXd> & as);

/// The rows of `a` above those of `b`; an empty matrix counts for nothing. Throws std::range_error when they
/// have different numbers of columns.
Eigen::MatrixXd vstack(const Eigen::MatrixXd & a, const Eigen::MatrixXd & b);

/// The matrices along the diagonal, and zeros elsewhere.
Eigen::MatrixXd block_diag(const std::vector<Eigen::MatrixXd> & as);

/// Parts of these sizes, from the beginning. Throws std::range_error when they need more than there is, or a
/// size is negative.
std::vector<Eigen::VectorXd> split(const Eigen::VectorXd & a, const std::vector<int> & ns);

}  // namespace sas
