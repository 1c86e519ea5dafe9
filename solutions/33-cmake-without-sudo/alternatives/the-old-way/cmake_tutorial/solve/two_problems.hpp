#ifndef TWO_PROBLEMS_HPP
#define TWO_PROBLEMS_HPP

#include <tinyqp/tinyqp.hpp>

tinyqp::Problem first_problem();
tinyqp::Problem second_problem();

#endif
