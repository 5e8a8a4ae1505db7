// The functions of the language for one number: the bits of lane.hpp, in one lane.
#pragma once

#include "interexpserv/instruction.hpp"

namespace animado::interexpserv {

class Table;

// What `op` makes of up to three numbers. tables: of Op::table.
double value_of(Op op, double a, double b, double c, const Table* tables = nullptr);

double sine(double x);
double cosine(double x);
double exponential(double x);
double logarithm(double x);
double power(double x, double y);

}  // namespace animado::interexpserv
