#pragma once

#include <chrono>
#include <cstdio>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <thread>

/// Fails the case that runs, with the expression and its line.
#define EXPECT(...) \
  do { \
    if (!(__VA_ARGS__)) { \
      throw std::logic_error(std::string("line ") + std::to_string(__LINE__) + ": " + #__VA_ARGS__); \
    } \
  } while (0)

/// What an expression throws: its text, when it is a `type`.
#define THROWN(type, ...) \
  [&]() -> std::string { \
    try { \
      static_cast<void>(__VA_ARGS__); \
    } catch (const type & error) { \
      return error.what(); \
    } \
    throw std::logic_error(std::string("line ") + std::to_string(__LINE__) + ": no " + #type); \
  }()

/// Waits, and fails the case after a minute.
template<typename Condition>
void wait_until(Condition holds)
{
  const auto limit = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (!holds()) {
    EXPECT(std::chrono::steady_clock::now() < limit);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

using Cases = std::map<std::string, std::function<void()>>;

/// Runs the case that is asked for; 0 when it holds.
inline int run_case(const Cases & cases, const std::string & name)
{
  const auto found = cases.find(name);
  if (found == cases.end()) {
    std::fprintf(stderr, "there is no case %s\n", name.c_str());
    return 2;
  }
  try {
    found->second();
  } catch (const std::exception & error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
