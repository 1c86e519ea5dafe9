#include "class_loader/registry.hpp"

namespace class_loader::detail
{

Registry & registry_of(const std::string & base)
{
  static std::mutex mutex;
  static std::map<std::string, Registry> registries;
  const std::lock_guard lock(mutex);
  return registries[base];
}

std::string & library_being_loaded()
{
  static thread_local std::string path;
  return path;
}

}  // namespace class_loader::detail
