#pragma once

#include <cstddef>
#include <vector>

// The position of a joint in rad; the first joint has the number 0.
// Throws std::out_of_range where there is no such joint.
double position_of(const std::vector<double>& positions, std::size_t joint);

// The angle in rad that has this cosine.
// Throws std::domain_error where no angle has it.
double angle_of(double cosine);
