#include "two_problems.hpp"

namespace
{
  tinyqp::Problem common(double g1, double g2)
  {
    tinyqp::Problem problem;
    problem.h[0] = 1;
    problem.h[2] = 0.5;
    problem.g[0] = g1;
    problem.g[1] = g2;
    return problem;
  }

  tinyqp::Constraint sum_between(double lower, double upper)
  {
    tinyqp::Constraint constraint;
    constraint.a[0] = constraint.a[1] = 1;
    constraint.lower = lower;
    constraint.upper = upper;
    return constraint;
  }
}

tinyqp::Problem first_problem()
{
  tinyqp::Problem problem = common(1.5, 1);
  problem.lower = {0.5, -2};
  problem.upper = {5, 2};
  problem.constraints.push_back(sum_between(-1, 2));
  return problem;
}

tinyqp::Problem second_problem()
{
  tinyqp::Problem problem = common(1, 1.5);
  problem.lower = {0, -1};
  problem.upper = {5, -0.5};
  problem.constraints.push_back(sum_between(-2, 1));
  return problem;
}
