#pragma once

#include <string>

namespace probes
{

class Lamp
{
public:
  virtual ~Lamp() = default;
  virtual std::string shine() const = 0;
};

class Other
{
public:
  virtual ~Other() = default;
  virtual std::string shade() const {return "another base";}
};

}  // namespace probes
