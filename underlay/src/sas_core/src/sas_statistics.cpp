#include <sas_core/sas_statistics.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace sas
{

void RunningStatistics::add(double value)
{
  ++count_;
  const double distance = value - mean_;
  mean_ += distance / static_cast<double>(count_);
  squares_ += distance * (value - mean_);
  minimum_ = count_ == 1 ? value : std::min(minimum_, value);
  maximum_ = count_ == 1 ? value : std::max(maximum_, value);
}

double RunningStatistics::get(Statistics which) const
{
  if (count_ == 0) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  switch (which) {
    case Statistics::Mean: return mean_;
    case Statistics::Variance: return variance();
    case Statistics::StandardDeviation: return std::sqrt(variance());
    case Statistics::Minimum: return minimum_;
    case Statistics::Maximum: return maximum_;
  }
  throw std::invalid_argument("sas::RunningStatistics: there is no such statistic.");
}

double RunningStatistics::variance() const
{
  return squares_ / static_cast<double>(count_);
}

}  // namespace sas
