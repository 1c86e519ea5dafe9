#pragma once

#include "tinyqp/tinyqp.hpp"

#include <optional>
#include <vector>

namespace tinyqp {

// If other numbers are about one, a number below this counts as zero.
inline constexpr double tiny = 1e-9;

// All points with a' x = b. The length of a is one.
struct Line {
  Vector a{};
  double b = 0.0;

  Vector direction() const;
  // Returns the point of the line that is nearest to the origin.
  Vector point() const;
};

double dot(const Vector& left, const Vector& right);

// left + factor * right
Vector sum(const Vector& left, double factor, const Vector& right);

// Returns the constraints, including the limits of x1 and x2.
std::vector<Constraint> all_constraints(const Problem& problem);

// Returns the edges of all constraints, except limits at infinity and constraints whose a is zero.
std::vector<Line> edges(const std::vector<Constraint>& constraints);

// Returns the point where two lines meet, or nothing if they are parallel.
std::optional<Vector> meeting(const Line& one, const Line& other);

bool satisfies(const std::vector<Constraint>& constraints, const Vector& x);

// Returns whether the constraints allow moving in this direction forever.
bool leads_away(const std::vector<Constraint>& constraints, const Vector& direction);

}  // namespace tinyqp
