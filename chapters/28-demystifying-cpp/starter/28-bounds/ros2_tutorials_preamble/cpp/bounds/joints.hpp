#pragma once

#include <cstddef>
#include <vector>

// Returns the position of a joint in rad. The first joint has the number 0.
// Throws std::out_of_range if there is no such joint.
double position_of(const std::vector<double>& positions, std::size_t joint);

// Returns the angle in rad that has this cosine.
// Throws std::domain_error if no angle has it.
double angle_of(double cosine);
