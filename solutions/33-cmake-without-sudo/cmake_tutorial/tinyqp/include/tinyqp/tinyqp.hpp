#pragma once

#include <array>
#include <limits>
#include <vector>

// Quadratic programs in two variables:
//
//   minimize    1/2 x' H x + g' x
//   subject to  lower <= x <= upper, and lower <= a' x <= upper for each constraint
namespace tinyqp {

using Vector = std::array<double, 2>;

inline constexpr double infinity = std::numeric_limits<double>::infinity();

// lower <= a' x <= upper
struct Constraint {
  Vector a{};
  double lower = -infinity;
  double upper = infinity;
};

struct Problem {
  // The symmetric matrix H as its numbers h11, h12, h22. It must be positive semidefinite.
  std::array<double, 3> h{};
  Vector g{};
  Vector lower{-infinity, -infinity};
  Vector upper{infinity, infinity};
  std::vector<Constraint> constraints{};
};

enum class Status {
  solved,
  infeasible,  // no point satisfies all the constraints
  unbounded,   // there is always a better point
  not_convex   // H is not positive semidefinite, or something is not a number
};

// x and objective are valid only if status is solved. If there are several solutions, x is one of them.
struct Solution {
  Status status = Status::infeasible;
  Vector x{};
  double objective = 0.0;
};

Solution solve(const Problem& problem);

}  // namespace tinyqp
