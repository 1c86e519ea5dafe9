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
  std::string unused = "another base";
};

}  // namespace probes
