#include "pluginlib/detail/plugin_loader.hpp"

#include <filesystem>
#include <sstream>
#include <utility>

#include "ament_index_cpp/get_package_prefix.hpp"
#include "ament_index_cpp/get_resource.hpp"
#include "ament_index_cpp/get_resources.hpp"
#include "descriptions.hpp"
#include "pluginlib/exceptions.hpp"
#include "rcutils/logging_macros.h"

namespace pluginlib::detail
{

namespace
{

/// Where a library of a package may be. The name may have a folder, and begin with `lib`; neither is needed.
std::vector<std::filesystem::path> candidates(const std::string & library, const std::string & package)
{
  const std::filesystem::path prefix = ament_index_cpp::get_package_prefix(package);
  const std::filesystem::path given = library;
  const auto name = given.filename().string();
  std::vector<std::filesystem::path> found;
  for (const auto & folder : {prefix / "lib", prefix / "lib64"}) {
    for (const auto & inside : {folder, folder / package}) {
      for (const auto & parent : {inside / given.parent_path(), inside}) {
        found.push_back(parent / ("lib" + name + ".so"));
        if (name.compare(0, 3, "lib") == 0) {
          found.push_back(parent / (name + ".so"));
        }
      }
    }
  }
  return found;
}

}  // namespace

PluginLoader::PluginLoader(
  std::string package, std::string base_class, std::string attrib_name,
  std::vector<std::string> plugin_xml_paths)
: package_(std::move(package)), base_class_(std::move(base_class)), attrib_name_(std::move(attrib_name)),
  files_(std::move(plugin_xml_paths))
{
  try {
    ament_index_cpp::get_package_prefix(package_);
  } catch (const std::exception & error) {
    throw ClassLoaderException(error.what());
  }
  if (files_.empty()) {
    files_ = files_in_index();
  }
  read_files();
}

std::vector<std::string> PluginLoader::files_in_index() const
{
  const auto resource = package_ + "__pluginlib__" + attrib_name_;
  std::vector<std::string> files;
  for (const auto & [package, found_in] : ament_index_cpp::get_resources(resource)) {
    std::string content;
    std::string prefix;
    ament_index_cpp::get_resource(resource, package, content, &prefix);
    std::istringstream lines(content);
    for (std::string line; std::getline(lines, line); ) {
      if (!line.empty()) {
        files.push_back(prefix + "/" + line);
      }
    }
  }
  return files;
}

void PluginLoader::read_files()
{
  for (const auto & file : files_) {
    try {
      for (auto & described : read_descriptions(file)) {
        if (described.base_class_ == base_class_) {
          classes_.emplace(described.lookup_name_, std::move(described));
        }
      }
    } catch (const InvalidXMLException & error) {
      RCUTILS_LOG_ERROR_NAMED("pluginlib.ClassLoader", "Skipped a file: %s", error.what());
    }
  }
}

std::vector<std::string> PluginLoader::getPluginXmlPaths()
{
  return files_;
}

std::vector<std::string> PluginLoader::getDeclaredClasses()
{
  std::vector<std::string> names;
  for (const auto & [name, described] : classes_) {
    names.push_back(name);
  }
  return names;
}

void PluginLoader::refreshDeclaredClasses()
{
  for (auto one = classes_.begin(); one != classes_.end(); ) {
    one = libraries_.count(one->second.resolved_library_path_) ? std::next(one) : classes_.erase(one);
  }
  files_ = files_in_index();
  read_files();
}

std::string PluginLoader::getBaseClassType() const
{
  return base_class_;
}

std::string PluginLoader::getName(const std::string & lookup_name)
{
  return lookup_name.substr(lookup_name.find_last_of("/:") + 1);
}

bool PluginLoader::isClassAvailable(const std::string & lookup_name)
{
  return described(lookup_name) != nullptr;
}

std::string PluginLoader::getClassType(const std::string & lookup_name)
{
  const auto found = described(lookup_name);
  return found ? found->derived_class_ : "";
}

std::string PluginLoader::getClassDescription(const std::string & lookup_name)
{
  const auto found = described(lookup_name);
  return found ? found->description_ : "";
}

std::string PluginLoader::getClassPackage(const std::string & lookup_name)
{
  const auto found = described(lookup_name);
  return found ? found->package_ : "";
}

std::string PluginLoader::getPluginManifestPath(const std::string & lookup_name)
{
  const auto found = described(lookup_name);
  return found ? found->plugin_manifest_path_ : "";
}

std::string PluginLoader::getClassLibraryPath(const std::string & lookup_name)
{
  const auto found = described(lookup_name);
  if (!found) {
    throw LibraryLoadException(unknown(lookup_name));
  }
  try {
    for (const auto & path : candidates(found->library_name_, found->package_)) {
      if (std::filesystem::exists(path)) {
        return path;
      }
    }
  } catch (const std::exception & error) {  // from the index
    throw LibraryLoadException(error.what());
  }
  throw LibraryLoadException(
          "The package " + found->package_ + " has not installed the library '" + found->library_name_ +
          "' of the class " + lookup_name + ". Compare the name with the one in its CMakeLists.txt. It is "
          "taken from " + found->plugin_manifest_path_);
}

void PluginLoader::loadLibraryForClass(const std::string & lookup_name)
{
  const auto path = getClassLibraryPath(lookup_name);
  try {
    if (!libraries_.count(path)) {
      libraries_[path] = std::make_unique<class_loader::ClassLoader>(path);
    }
  } catch (const class_loader::LibraryLoadException & error) {
    throw LibraryLoadException(error.what());
  }
  classes_.at(lookup_name).resolved_library_path_ = path;
}

int PluginLoader::unloadLibraryForClass(const std::string & lookup_name)
{
  const auto found = classes_.find(lookup_name);
  if (found == classes_.end()) {
    throw LibraryUnloadException(unknown(lookup_name));
  }
  const auto & path = found->second.resolved_library_path_;
  if (path == "UNRESOLVED") {
    throw LibraryUnloadException("The library of the class " + lookup_name + " was never loaded.");
  }
  const auto library = libraries_.find(path);
  const int left = library == libraries_.end() ? 0 : library->second->unloadLibrary();
  if (left == 0 && library != libraries_.end()) {
    libraries_.erase(library);
  }
  return left;
}

std::vector<std::string> PluginLoader::getRegisteredLibraries()
{
  std::vector<std::string> paths;
  for (const auto & [path, library] : libraries_) {
    paths.push_back(path);
  }
  return paths;
}

void PluginLoader::throw_not_registered(const std::string & lookup_name) const
{
  const auto found = described(lookup_name);
  if (!found) {
    throw CreateClassException(unknown(lookup_name));
  }
  const auto & type = found->derived_class_;
  throw CreateClassException(
          "No library that is loaded registers the class " + type + " with the base class " + base_class_ +
          ". The library '" + found->library_name_ + "' needs PLUGINLIB_EXPORT_CLASS(" + type + ", " +
          base_class_ + "), with the same names as in " + found->plugin_manifest_path_);
}

const ClassDesc * PluginLoader::described(const std::string & lookup_name) const
{
  const auto found = classes_.find(lookup_name);
  return found == classes_.end() ? nullptr : &found->second;
}

std::string PluginLoader::unknown(const std::string & lookup_name) const
{
  std::string names;
  for (const auto & [name, described] : classes_) {
    names += (names.empty() ? "" : ", ") + name;
  }
  return "No package describes a class " + lookup_name + " with the base class " + base_class_ +
         ". Classes that are described: " + (names.empty() ? "none" : names);
}

}  // namespace pluginlib::detail
