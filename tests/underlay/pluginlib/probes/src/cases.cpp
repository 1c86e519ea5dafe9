#include "case.hpp"
#include "pluginlib/class_loader.hpp"
#include "pluginlib_probes/lamp.hpp"

namespace
{

using Loader = pluginlib::ClassLoader<probes::Lamp>;
using Names = std::vector<std::string>;

Loader loader()
{
  return {"pluginlib_probes", "probes::Lamp"};
}

bool ends_with(const std::string & text, const std::string & end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

bool has(const std::string & text, const std::string & part)
{
  return text.find(part) != std::string::npos;
}

void makes_objects()
{
  auto lamps = loader();
  EXPECT(lamps.createSharedInstance("probes::Red")->shine() == "red");
  pluginlib::UniquePtr<probes::Lamp> green = lamps.createUniqueInstance("shop/green");
  EXPECT(green->shine() == "green");
  std::unique_ptr<probes::Lamp> own(lamps.createUnmanagedInstance("shop/green"));
  EXPECT(own->shine() == "green");
  EXPECT(lamps.createSharedInstance("shop/lantern")->shine() == "lantern");
}

void tells_what_is_described()
{
  auto lamps = loader();
  EXPECT(
    lamps.getDeclaredClasses() == Names{
      "probes::Red", "shop/forgotten", "shop/green", "shop/lantern", "shop/no_library", "shop/nowhere"});
  EXPECT(lamps.isClassAvailable("shop/green") && !lamps.isClassAvailable("probes::Green"));
  EXPECT(lamps.getBaseClassType() == "probes::Lamp");
  EXPECT(lamps.getName("probes::Red") == "Red");
  EXPECT(lamps.getName("shop/green") == "green");
  EXPECT(lamps.getName("plain") == "plain");
  EXPECT(lamps.getClassType("shop/green") == "probes::Green");
  EXPECT(lamps.getClassPackage("shop/green") == "pluginlib_probes");
  EXPECT(lamps.getClassDescription("probes::Red") == "Shines red.");
  const auto files = lamps.getPluginXmlPaths();
  EXPECT(files.size() == 2);
  EXPECT(ends_with(files[0], "/share/pluginlib_probes/lamps.xml"));
  EXPECT(ends_with(files[1], "/share/pluginlib_probes/more/lanterns.xml"));
  EXPECT(lamps.getPluginManifestPath("shop/lantern") == files[1]);
  EXPECT(ends_with(lamps.getClassLibraryPath("probes::Red"), "/lib/liblamps.so"));
  EXPECT(ends_with(lamps.getClassLibraryPath("shop/lantern"), "/lib/liblanterns.so"));
}

void loads_and_unloads()
{
  auto lamps = loader();
  EXPECT(!lamps.isClassLoaded("shop/green"));
  EXPECT(has(THROWN(pluginlib::LibraryUnloadException, lamps.unloadLibraryForClass("shop/green")), "never"));
  lamps.loadLibraryForClass("shop/green");
  lamps.loadLibraryForClass("shop/green");
  EXPECT(lamps.isClassLoaded("shop/green") && lamps.isClassLoaded("probes::Red"));
  EXPECT(!lamps.isClassLoaded("shop/lantern"));
  EXPECT(lamps.getRegisteredLibraries() == Names{lamps.getClassLibraryPath("shop/green")});
  auto green = lamps.createSharedInstance("shop/green");
  EXPECT(lamps.unloadLibraryForClass("shop/green") == 1 && lamps.isClassLoaded("shop/green"));
  green.reset();
  EXPECT(lamps.unloadLibraryForClass("shop/green") == 0 && !lamps.isClassLoaded("shop/green"));
  EXPECT(lamps.getRegisteredLibraries().empty());
  EXPECT(lamps.createSharedInstance("shop/green")->shine() == "green");
}

void objects_outlive_their_loader()
{
  auto lamp = loader().createSharedInstance("probes::Red");
  EXPECT(lamp->shine() == "red");
  lamp.reset();
  EXPECT(loader().createSharedInstance("probes::Red")->shine() == "red");
}

void reads_the_index_again()
{
  auto lamps = Loader("pluginlib_probes", "probes::Lamp", "plugin", {"nothing.xml"});
  EXPECT(lamps.getDeclaredClasses().empty());
  lamps.refreshDeclaredClasses();
  EXPECT(lamps.getDeclaredClasses().size() == 6 && lamps.getPluginXmlPaths().size() == 2);
  lamps.loadLibraryForClass("shop/green");
  lamps.refreshDeclaredClasses();
  EXPECT(lamps.isClassLoaded("shop/green") && lamps.unloadLibraryForClass("shop/green") == 0);
}

void says_why_there_is_no_loader()
{
  const auto said = THROWN(pluginlib::ClassLoaderException, Loader("nosuch_package", "probes::Lamp"));
  EXPECT(has(said, "nosuch_package"));
  EXPECT(Loader("pluginlib_probes", "probes::Lam").getDeclaredClasses().empty());
  EXPECT(Loader("pluginlib", "probes::Lamp").getDeclaredClasses().empty());
}

void says_why_there_is_no_object()
{
  using Fault = pluginlib::LibraryLoadException;
  auto lamps = loader();
  const auto unknown = THROWN(Fault, lamps.createSharedInstance("probes::Green"));
  EXPECT(has(unknown, "probes::Green") && has(unknown, "probes::Red, shop/forgotten, shop/green"));
  EXPECT(THROWN(pluginlib::LibraryUnloadException, lamps.unloadLibraryForClass("probes::Green")) == unknown);
  EXPECT(lamps.getClassType("probes::Green").empty() && lamps.getClassPackage("probes::Green").empty());
  const auto missing = THROWN(Fault, lamps.createUniqueInstance("shop/nowhere"));
  EXPECT(has(missing, "'nowhere'") && has(missing, "share/pluginlib_probes/lamps.xml"));
  EXPECT(has(THROWN(Fault, lamps.loadLibraryForClass("shop/no_library")), "libno_library.so"));
  EXPECT(lamps.getRegisteredLibraries().empty());
  const auto forgotten = THROWN(pluginlib::CreateClassException, lamps.createSharedInstance("shop/forgotten"));
  EXPECT(has(forgotten, "PLUGINLIB_EXPORT_CLASS(probes::Forgotten, probes::Lamp)"));
  // All of them are one kind, which is a std::runtime_error.
  EXPECT(!THROWN(pluginlib::PluginlibException, lamps.createUnmanagedInstance("shop/forgotten")).empty());
  EXPECT(!THROWN(std::runtime_error, lamps.createUnmanagedInstance("shop/nowhere")).empty());
}

}  // namespace

int main(int, char * argv[])
{
  return run_case({
    {"makes_objects", makes_objects},
    {"tells_what_is_described", tells_what_is_described},
    {"loads_and_unloads", loads_and_unloads},
    {"objects_outlive_their_loader", objects_outlive_their_loader},
    {"reads_the_index_again", reads_the_index_again},
    {"says_why_there_is_no_loader", says_why_there_is_no_loader},
    {"says_why_there_is_no_object", says_why_there_is_no_object},
  }, argv[1]);
}
