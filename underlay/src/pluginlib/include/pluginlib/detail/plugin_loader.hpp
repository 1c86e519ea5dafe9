#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "class_loader/class_loader.hpp"
#include "pluginlib/class_desc.hpp"
#include "pluginlib/class_loader_base.hpp"

namespace pluginlib::detail
{

/// The part of a class loader that is not a template.
class PluginLoader : public ClassLoaderBase
{
public:
  std::vector<std::string> getPluginXmlPaths() override;
  std::vector<std::string> getDeclaredClasses() override;
  void refreshDeclaredClasses() override;
  std::string getBaseClassType() const override;
  std::string getName(const std::string & lookup_name) override;
  bool isClassAvailable(const std::string & lookup_name) override;
  std::string getClassType(const std::string & lookup_name) override;
  std::string getClassDescription(const std::string & lookup_name) override;
  std::string getClassPackage(const std::string & lookup_name) override;
  std::string getPluginManifestPath(const std::string & lookup_name) override;
  std::string getClassLibraryPath(const std::string & lookup_name) override;
  void loadLibraryForClass(const std::string & lookup_name) override;
  int unloadLibraryForClass(const std::string & lookup_name) override;
  std::vector<std::string> getRegisteredLibraries() override;

protected:
  using Libraries = std::map<std::string, std::unique_ptr<class_loader::ClassLoader>>;

  PluginLoader(
    std::string package, std::string base_class, std::string attrib_name,
    std::vector<std::string> plugin_xml_paths);

  /// Those that are loaded, by their paths.
  const Libraries & libraries() const {return libraries_;}
  /// Throws CreateClassException, because no library that is loaded registers the class.
  [[noreturn]] void throw_not_registered(const std::string & lookup_name) const;

private:
  /// Nothing if there is no such class.
  const ClassDesc * described(const std::string & lookup_name) const;
  std::vector<std::string> files_in_index() const;
  void read_files();
  std::string unknown(const std::string & lookup_name) const;

  const std::string package_;
  const std::string base_class_;
  const std::string attrib_name_;
  std::vector<std::string> files_;
  std::map<std::string, ClassDesc> classes_;
  Libraries libraries_;
};

}  // namespace pluginlib::detail
