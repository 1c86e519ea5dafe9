#include "joints.hpp"

#include <stdexcept>

const Eigen::VectorXd & Joints::positions() const
{
  return positions_;
}

void Joints::move(const Eigen::VectorXd & target)
{
  if (target.size() != positions_.size()) {
    throw std::runtime_error("A target needs six joint positions.");
  }
  positions_ = target;
}
