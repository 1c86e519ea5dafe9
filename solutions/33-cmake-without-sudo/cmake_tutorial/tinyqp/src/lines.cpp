#include "lines.hpp"

#include <algorithm>
#include <cmath>

namespace tinyqp {

namespace {

double length(const Vector& vector) {
  return std::hypot(vector[0], vector[1]);
}

}  // namespace

double dot(const Vector& left, const Vector& right) {
  return left[0] * right[0] + left[1] * right[1];
}

Vector sum(const Vector& left, double factor, const Vector& right) {
  return {left[0] + factor * right[0], left[1] + factor * right[1]};
}

Vector Line::direction() const {
  return {-a[1], a[0]};
}

Vector Line::point() const {
  return {b * a[0], b * a[1]};
}

std::vector<Constraint> all_constraints(const Problem& problem) {
  std::vector<Constraint> all = problem.constraints;
  all.push_back({{1.0, 0.0}, problem.lower[0], problem.upper[0]});
  all.push_back({{0.0, 1.0}, problem.lower[1], problem.upper[1]});
  return all;
}

std::vector<Line> edges(const std::vector<Constraint>& constraints) {
  std::vector<Line> lines;
  for (const Constraint& constraint : constraints) {
    const double norm = length(constraint.a);
    if (norm == 0.0) {
      continue;
    }
    for (const double bound : {constraint.lower, constraint.upper}) {
      if (std::isfinite(bound)) {
        lines.push_back({{constraint.a[0] / norm, constraint.a[1] / norm}, bound / norm});
      }
    }
  }
  return lines;
}

std::optional<Vector> meeting(const Line& one, const Line& other) {
  const double determinant = one.a[0] * other.a[1] - one.a[1] * other.a[0];
  if (std::abs(determinant) < tiny) {
    return std::nullopt;
  }
  return Vector{(one.b * other.a[1] - other.b * one.a[1]) / determinant,
                (one.a[0] * other.b - other.a[0] * one.b) / determinant};
}

bool satisfies(const std::vector<Constraint>& constraints, const Vector& x) {
  return std::all_of(constraints.begin(), constraints.end(), [&x](const Constraint& constraint) {
    const double value = dot(constraint.a, x);
    const double slack = tiny * std::max({1.0, std::abs(value), length(constraint.a) * length(x)});
    return value >= constraint.lower - slack && value <= constraint.upper + slack;
  });
}

bool leads_away(const std::vector<Constraint>& constraints, const Vector& direction) {
  return std::all_of(constraints.begin(), constraints.end(), [&direction](const Constraint& constraint) {
    const double change = dot(constraint.a, direction);
    const bool up_is_open = std::isinf(constraint.upper) && constraint.upper > 0.0;
    const bool down_is_open = std::isinf(constraint.lower) && constraint.lower < 0.0;
    return (change <= tiny || up_is_open) && (change >= -tiny || down_is_open);
  });
}

}  // namespace tinyqp
