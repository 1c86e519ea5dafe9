// Figures of a series of numbers, kept up to date without keeping the numbers.

#pragma once

namespace sas
{

enum class Statistics
{
  Mean,
  Variance,
  StandardDeviation,
  Minimum,
  Maximum
};

/// Takes numbers one by one and tells any of the Statistics so far; before the first it tells NaN.
class RunningStatistics
{
public:
  void add(double value);
  double get(Statistics which) const;

private:
  double variance() const;

  long count_ = 0;
  double mean_ = 0.0;
  double squares_ = 0.0;  // of the distances to the mean, summed (Welford)
  double minimum_ = 0.0;
  double maximum_ = 0.0;
};

}  // namespace sas
