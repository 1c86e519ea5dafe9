// frames CASE: where frames are, without a node; 0 when it holds.

#include <chrono>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include "case.hpp"
#include "placed.hpp"
#include "tf2/LinearMath/Matrix3x3.h"
#include "tf2/LinearMath/Quaternion.h"
#include "tf2/LinearMath/Transform.h"
#include "tf2/LinearMath/Vector3.h"
#include "tf2/buffer_core.h"
#include "tf2/exceptions.h"
#include "tf2/time.h"
#include "tf2/utils.h"

using namespace std::chrono_literals;
using tf2::BufferCore;
using tf2::Matrix3x3;
using tf2::Quaternion;
using tf2::TimePointZero;
using tf2::Transform;
using tf2::Vector3;
using tf2::timeFromSec;

namespace
{

bool near(const Vector3 & one, const Vector3 & other) {return one.distance(other) < 1e-9;}
using ::near;

/// The same rotation: the sign does not matter.
bool near(const Quaternion & one, const Quaternion & other)
{
  return one.angleShortestPath(other) < 1e-6 && near(one.length(), other.length());
}

Quaternion turned(double roll, double pitch, double yaw)
{
  Quaternion q;
  q.setRPY(roll, pitch, yaw);
  return q;
}

/// world - turtle1 - carrot1, world - turtle2, and island - palm, which is elsewhere.
void fill(BufferCore & buffer)
{
  EXPECT(buffer.setTransform(placed("world", "turtle1", 10, 1, 2, M_PI_2), "test"));
  EXPECT(buffer.setTransform(placed("world", "turtle1", 12, 3, 2, M_PI_2), "test"));
  EXPECT(buffer.setTransform(placed("turtle1", "carrot1", 0, 0, 2), "test", true));
  EXPECT(buffer.setTransform(placed("world", "turtle2", 9, 5, 5), "test"));
  EXPECT(buffer.setTransform(placed("world", "turtle2", 11, 5, 7), "test"));
  EXPECT(buffer.setTransform(placed("island", "palm", 10, 1), "test"));
}

}  // namespace

void times()
{
  EXPECT(tf2::durationFromSec(1.5) == 1500ms && tf2::durationFromSec(-0.25) == -250ms);
  EXPECT(tf2::durationFromSec(1756000000.000000123) - 1756000000s < 500ns);
  EXPECT(tf2::durationToSec(-1500ms) == -1.5 && tf2::timeToSec(timeFromSec(2.25)) == 2.25);
  EXPECT(tf2::displayTimePoint(timeFromSec(1629873136.345539)) == "1629873136.345539");
  EXPECT(TimePointZero == tf2::TimePoint() && tf2::get_now() > TimePointZero);
}

void vectors()
{
  const Vector3 v(1, 2, 2), w(0, 3, 4);
  EXPECT(v.length() == 3 && v.dot(w) == 14 && v.cross(w) == Vector3(2, -4, 3));
  EXPECT(v + w == Vector3(1, 5, 6) && v - w == Vector3(1, -1, -2) && -v == Vector3(-1, -2, -2));
  EXPECT(v * 2 == 2.0 * v && v / 2 == Vector3(0.5, 1, 1) && v * w == Vector3(0, 6, 8));
  EXPECT(near(v.normalized().length(), 1) && v.lerp(w, 0.5) == Vector3(0.5, 2.5, 3));
  EXPECT(v.distance(w) == (-v).distance(-w) && v[2] == 2 && v.getY() == 2);
  EXPECT(v.maxAxis() != 0 && v.minAxis() == 0 && Vector3().isZero() && !v.fuzzyZero());
  EXPECT(near(Vector3(1, 0, 0).rotate({0, 0, 1}, M_PI_2), {0, 1, 0}));
  EXPECT(near(Vector3(1, 0, 0).angle({0, 2, 0}), M_PI_2));
  Vector3 changed;
  changed.setValue(1, 2, 3);
  changed.setX(4);
  changed *= changed.x();
  EXPECT(changed == Vector3(16, 8, 12));
}

void rotations()
{
  EXPECT(turned(0, 0, 0) == Quaternion(0, 0, 0, 1) && turned(0, 0, 0) == Quaternion::getIdentity());
  EXPECT(near(turned(0, 0, M_PI_2), Quaternion(0, 0, std::sqrt(0.5), std::sqrt(0.5))));
  EXPECT(near(turned(0.1, 0.2, 0.3), turned(0, 0, 0.3) * turned(0, 0.2, 0) * turned(0.1, 0, 0)));
  EXPECT(!near(turned(0.1, 0.2, 0.3), turned(0.1, 0, 0) * turned(0, 0.2, 0) * turned(0, 0, 0.3)));
  Quaternion euler;
  euler.setEuler(0.3, 0.2, 0.1);
  EXPECT(near(euler, turned(0, 0.3, 0) * turned(0.2, 0, 0) * turned(0, 0, 0.1)));

  const Quaternion q = turned(0.4, -0.5, 0.6);
  EXPECT(near(q * q.inverse(), Quaternion::getIdentity()) && near((q * 3).normalize(), q));
  EXPECT(near(Quaternion(q.getAxis(), q.getAngle()), q));
  EXPECT(near(Quaternion(Vector3(0, 0, 5), 0.7), turned(0, 0, 0.7)));
  EXPECT(near(Quaternion::getIdentity().getAxis(), {1, 0, 0}));
  EXPECT(near(turned(0, 0, 0.2).slerp(turned(0, 0, 0.8), 0.5), turned(0, 0, 0.5)));
  EXPECT(near(turned(0, 0, 0.2).slerp(-turned(0, 0, 0.8), 0.25), turned(0, 0, 0.35)));
  EXPECT(near(turned(0, 0, 0.2).angleShortestPath(-turned(0, 0, 0.8)), 0.6));
  EXPECT(near(turned(0, 0, 0.2).angle(turned(0, 0, 0.8)), 0.3));
  EXPECT(near(tf2::quatRotate(turned(0, 0, M_PI_2), {1, 0, 0}), {0, 1, 0}));
  for (const Vector3 & to : {Vector3(0, 1, 0), Vector3(-1, 0, 0), Vector3(1, 0, 0), Vector3(0, 0.6, -0.8)}) {
    EXPECT(near(tf2::quatRotate(tf2::shortestArcQuat({1, 0, 0}, to), {1, 0, 0}), to));
  }
  EXPECT(q.nearest(-q) == q && q.farthest(q) == -q && q[3] == q.w() && q.getX() == q.x());
}

void matrices()
{
  for (const double roll : {-3.0, -0.3, 0.0, 1.1}) {
    for (const double pitch : {-1.5, 0.0, 0.7}) {
      for (const double yaw : {-2.0, 0.0, 3.0}) {
        double r, p, y;
        const Matrix3x3 matrix(turned(roll, pitch, yaw));
        matrix.getRPY(r, p, y);
        EXPECT(near(r, roll) && near(p, pitch) && near(y, yaw));
        matrix.getEulerYPR(y, p, r, 2);
        EXPECT(!near(p, pitch) && near(turned(r, p, y), turned(roll, pitch, yaw)));
        Quaternion q;
        matrix.getRotation(q);
        EXPECT(near(q, turned(roll, pitch, yaw)));
        tf2::getEulerYPR(q * 2, y, p, r);
        EXPECT(near(r, roll) && near(p, pitch) && near(y, yaw) && near(tf2::getYaw(q), yaw));
      }
    }
  }
  const Matrix3x3 m(1, 2, 0, 0, 1, 3, 4, 0, 1);
  EXPECT(m.determinant() == 25 && m.transpose()[0] == Vector3(1, 0, 4) && m.getColumn(1) == Vector3(2, 1, 0));
  const Matrix3x3 one = m * m.inverse();
  for (int i = 0; i < 3; ++i) {
    EXPECT(near(one[i], Matrix3x3::getIdentity()[i]));
  }
  EXPECT(m * Vector3(1, 1, 1) == Vector3(3, 4, 5) && Vector3(1, 1, 1) * m == Vector3(5, 3, 4));
  EXPECT(m.transposeTimes(m) == m.transpose() * m && m.timesTranspose(m) == m * m.transpose());
  const Matrix3x3 quarter(0, -1, 0, 1, 0, 0, 0, 0, 1);
  EXPECT(near(quarter * Vector3(1, 0, 0), {0, 1, 0}));
  Matrix3x3 doubled;
  doubled.setRotation(turned(0, 0, M_PI_2) * 2);  // its length does not matter
  EXPECT(near(doubled[0], quarter[0]) && near(doubled[1], quarter[1]));
}

void upright()
{
  for (const double pitch : {-M_PI_2, M_PI_2}) {
    const Quaternion q = turned(0.2, pitch, 0.7);
    double yaw, found, roll;
    tf2::getEulerYPR(q, yaw, found, roll);
    EXPECT(near(found, pitch) && std::abs(turned(roll, found, yaw).angleShortestPath(q)) < 1e-6);
  }
  double yaw, pitch, roll;
  Matrix3x3(0, 0.6, 0.8, 0, 0.8, -0.6, -1, 0, 0).getRPY(roll, pitch, yaw);
  EXPECT(near(pitch, M_PI_2) && near(yaw, 0) && near(roll, std::atan2(0.6, 0.8)));
}

void transforms()
{
  const Transform t(turned(0, 0, M_PI_2), {1, 2, 3});
  EXPECT(near(t * Vector3(1, 0, 0), {1, 3, 3}) && near(t(Vector3(0, 1, 0)), {0, 2, 3}));
  EXPECT(near((t * t).getOrigin(), {-1, 3, 6}) && near((t * t).getRotation(), turned(0, 0, M_PI)));
  EXPECT(near(t.inverse() * (t * Vector3(4, 5, 6)), {4, 5, 6}));
  EXPECT(near(t.invXform({1, 3, 3}), {1, 0, 0}) && near(t.inverseTimes(t).getOrigin(), {}));
  EXPECT(near(t * Quaternion::getIdentity(), turned(0, 0, M_PI_2)));
  Transform other;
  other.setIdentity();
  EXPECT(other == Transform::getIdentity() && other * t == t);
  other.setOrigin({1, 0, 0});
  other.setRotation(turned(0, 0, M_PI));
  EXPECT(near(other.getBasis() * Vector3(1, 0, 0), {-1, 0, 0}));
}

void lookups()
{
  BufferCore buffer;
  fill(buffer);
  const auto at = [&buffer](const char * target, const char * source, double seconds) {
      return buffer.lookupTransform(target, source, timeFromSec(seconds));
    };
  EXPECT(is_at(at("world", "turtle1", 10), 1, 2, M_PI_2) && is_at(at("world", "turtle1", 12), 3, 2, M_PI_2));
  EXPECT(is_at(at("turtle1", "world", 10), -2, 1, -M_PI_2));
  EXPECT(is_at(at("turtle1", "carrot1", 7), 0, 2) && is_at(at("carrot1", "turtle1", 7), 0, -2));
  EXPECT(is_at(at("world", "carrot1", 11), 0, 2, M_PI_2));
  EXPECT(is_at(at("turtle2", "carrot1", 10), -6, -4, M_PI_2));
  EXPECT(is_at(at("carrot1", "turtle2", 10), 4, -6, -M_PI_2));
  EXPECT(is_at(at("nowhere", "nowhere", 3), 0, 0) && at("nowhere", "nowhere", 3).header.stamp.sec == 3);
  const auto found = at("turtle2", "carrot1", 10.5);
  EXPECT(found.header.frame_id == "turtle2" && found.child_frame_id == "carrot1");
  EXPECT(found.header.stamp.sec == 10 && found.header.stamp.nanosec == 500000000);
}

void latest()
{
  BufferCore buffer;
  fill(buffer);
  const auto stamp = [&buffer](const char * target, const char * source) {
      return buffer.lookupTransform(target, source, TimePointZero).header.stamp.sec;
    };
  EXPECT(stamp("world", "turtle1") == 12 && stamp("turtle2", "carrot1") == 11 && stamp("turtle1", "turtle2") == 11);
  EXPECT(stamp("turtle1", "carrot1") == 0 && stamp("turtle1", "turtle1") == 12 && stamp("world", "world") == 0);
  EXPECT(is_at(buffer.lookupTransform("world", "turtle1", TimePointZero), 3, 2, M_PI_2));
}

void interpolation()
{
  BufferCore buffer;
  EXPECT(buffer.setTransform(placed("world", "robot", 14, 4, 0, 1), "test"));  // in any order
  EXPECT(buffer.setTransform(placed("world", "robot", 10, 0, 0, 0), "test"));
  EXPECT(buffer.setTransform(placed("world", "robot", 12, 1, 6, 0), "test"));
  EXPECT(is_at(buffer.lookupTransform("world", "robot", timeFromSec(11)), 0.5, 3, 0));
  EXPECT(is_at(buffer.lookupTransform("world", "robot", timeFromSec(12)), 1, 6, 0));
  EXPECT(is_at(buffer.lookupTransform("world", "robot", timeFromSec(12.5)), 1.75, 4.5, 0.25));
  // Who gets another parent is not halfway between both.
  EXPECT(buffer.setTransform(placed("ship", "robot", 16, 100), "test"));
  EXPECT(is_at(buffer.lookupTransform("world", "robot", timeFromSec(15)), 4, 0, 1));
  EXPECT(is_at(buffer.lookupTransform("ship", "robot", timeFromSec(16)), 100, 0));
}

void extrapolation()
{
  BufferCore buffer;
  fill(buffer);
  EXPECT(
    THROWN(tf2::ForwardExtrapolationException, buffer.lookupTransform("turtle2", "turtle1", timeFromSec(11.5))) ==
    "Lookup would require extrapolation into the future.  Requested time 11.500000 but the latest data is at "
    "time 11.000000, when looking up transform from frame [turtle1] to frame [turtle2]");
  EXPECT(
    THROWN(tf2::BackwardExtrapolationException, buffer.lookupTransform("turtle2", "carrot1", timeFromSec(9.5))) ==
    "Lookup would require extrapolation into the past.  Requested time 9.500000 but the earliest data is at "
    "time 10.000000, when looking up transform from frame [carrot1] to frame [turtle2]");
  EXPECT(
    THROWN(tf2::NoDataForExtrapolationException, buffer.lookupTransform("island", "palm", timeFromSec(11))) ==
    "Lookup would require extrapolation at time 11.000000, but only time 10.000000 is in the buffer, when "
    "looking up transform from frame [palm] to frame [island]");
  EXPECT((std::is_base_of_v<tf2::ExtrapolationException, tf2::NoDataForExtrapolationException>));
  EXPECT((std::is_base_of_v<tf2::TransformException, tf2::ExtrapolationException>));
}

void unknown()
{
  BufferCore buffer;
  fill(buffer);
  EXPECT(
    THROWN(tf2::LookupException, buffer.lookupTransform("turtle3", "turtle1", TimePointZero)) ==
    "\"turtle3\" passed to lookupTransform argument target_frame does not exist. ");
  EXPECT(
    THROWN(tf2::LookupException, buffer.lookupTransform("turtle1", "turtle3", TimePointZero)) ==
    "\"turtle3\" passed to lookupTransform argument source_frame does not exist. ");
  EXPECT(
    THROWN(tf2::InvalidArgumentException, buffer.lookupTransform("/world", "turtle1", TimePointZero)) ==
    "Invalid argument \"/world\" passed to lookupTransform argument target_frame - in tf2 frame_ids cannot start "
    "with a '/'");
  EXPECT(
    THROWN(tf2::InvalidArgumentException, buffer.lookupTransform("", "turtle1", TimePointZero)) ==
    "Invalid argument \"\" passed to lookupTransform argument target_frame - in tf2 frame_ids cannot be empty");
  for (const auto time : {TimePointZero, timeFromSec(10)}) {
    EXPECT(
      THROWN(tf2::ConnectivityException, buffer.lookupTransform("palm", "turtle1", time)) ==
      "Could not find a connection between 'palm' and 'turtle1' because they are not part of the same tree.Tf has "
      "two or more unconnected trees.");
  }
}

void questions()
{
  BufferCore buffer;
  fill(buffer);
  std::string error;
  EXPECT(buffer.canTransform("turtle2", "carrot1", timeFromSec(10), &error) && error.empty());
  EXPECT(buffer.canTransform("nowhere", "nowhere", TimePointZero));
  EXPECT(!buffer.canTransform("turtle3", "turtle1", TimePointZero));
  EXPECT(!buffer.canTransform("turtle3", "turtle1", TimePointZero, &error));
  EXPECT(error == "Invalid frame ID \"turtle3\" passed to canTransform argument target_frame - frame does not exist");
  EXPECT(!buffer.canTransform("turtle1", "/world", TimePointZero, &error));
  EXPECT(
    error == "Invalid frame ID \"/world\" passed to canTransform argument source_frame - in tf2 frame_ids cannot "
    "start with a '/'");
  EXPECT(!buffer.canTransform("turtle2", "turtle1", timeFromSec(20), &error));
  EXPECT(error.find("into the future.  Requested time 20.000000") != std::string::npos);
  EXPECT(buffer.canTransform("turtle2", timeFromSec(11), "turtle1", timeFromSec(12), "world", &error));
  EXPECT(!buffer.canTransform("turtle2", timeFromSec(12), "turtle1", timeFromSec(12), "world", &error));
  EXPECT(!buffer.canTransform("turtle2", timeFromSec(11), "turtle1", timeFromSec(12), "moon", &error));
  EXPECT(error == "Invalid frame ID \"moon\" passed to canTransform argument fixed_frame - frame does not exist");
}

void fixed_frames()
{
  BufferCore buffer;
  fill(buffer);
  const auto then = buffer.lookupTransform("turtle2", timeFromSec(11), "turtle1", timeFromSec(10), "world");
  EXPECT(is_at(then, -4, -5, M_PI_2) && then.header.stamp.sec == 11 && then.header.frame_id == "turtle2");
  EXPECT(is_at(buffer.lookupTransform("turtle1", timeFromSec(12), "turtle1", timeFromSec(10), "world"), 0, 2));
  EXPECT(
    THROWN(
      tf2::LookupException,
      buffer.lookupTransform("turtle2", TimePointZero, "turtle1", TimePointZero, "moon")) ==
    "\"moon\" passed to lookupTransform argument fixed_frame does not exist. ");
}

void static_frames()
{
  BufferCore buffer;
  EXPECT(buffer.setTransform(placed("base", "laser", 100, 1), "test", true));
  EXPECT(is_at(buffer.lookupTransform("base", "laser", timeFromSec(3)), 1, 0));
  EXPECT(buffer.setTransform(placed("base", "laser", 50, 2), "test", true));
  EXPECT(is_at(buffer.lookupTransform("base", "laser", timeFromSec(1000)), 2, 0));
  buffer.clear();
  EXPECT(buffer.canTransform("base", "laser", TimePointZero));
  EXPECT(buffer.setTransform(placed("base", "laser", 60, 3), "test"));  // it moves from now on
  EXPECT(!buffer.canTransform("base", "laser", timeFromSec(61)));
}

void memory()
{
  BufferCore buffer(5s);
  EXPECT(buffer.getCacheLength() == 5s && BufferCore().getCacheLength() == 10s);
  EXPECT(buffer.setTransform(placed("world", "robot", 100, 0), "test"));
  EXPECT(buffer.setTransform(placed("world", "robot", 104, 4), "test"));
  EXPECT(buffer.canTransform("world", "robot", timeFromSec(100)));
  EXPECT(buffer.setTransform(placed("world", "robot", 107, 7), "test"));
  EXPECT(buffer.setTransform(placed("world", "robot", 108, 8), "test"));
  EXPECT(!buffer.canTransform("world", "robot", timeFromSec(100)));
  EXPECT(is_at(buffer.lookupTransform("world", "robot", timeFromSec(105)), 5, 0));
  EXPECT(!buffer.setTransform(placed("world", "robot", 102, 2), "test"));
  EXPECT(buffer.setTransform(placed("world", "robot", 103.5, 3.5), "test"));
  buffer.clear();
  EXPECT(!buffer.canTransform("world", "robot", TimePointZero) && buffer._frameExists("robot"));
  EXPECT(buffer.setTransform(placed("world", "robot", 1, 1), "test"));
}

void nonsense()
{
  BufferCore buffer;
  EXPECT(!buffer.setTransform(placed("world", "world", 1, 0), "test"));
  EXPECT(!buffer.setTransform(placed("/world", "world", 1, 0), "test"));
  EXPECT(!buffer.setTransform(placed("", "robot", 1, 0), "test"));
  EXPECT(!buffer.setTransform(placed("world", "", 1, 0), "test"));
  EXPECT(!buffer.setTransform(placed("world", "robot", 1, std::numeric_limits<double>::quiet_NaN()), "test"));
  auto none = placed("world", "robot", 1, 0);
  none.transform.rotation.w = 0;
  EXPECT(!buffer.setTransform(none, "test"));
  EXPECT(buffer.getAllFrameNames().empty() && buffer.allFramesAsYAML() == "[]");
  EXPECT(buffer.setTransform(placed("/world", "/robot", 1, 3), "test"));
  EXPECT((buffer.getAllFrameNames() == std::vector<std::string>{"robot", "world"}));
  auto twice = placed("world", "robot", 2, 3, 0, M_PI_2);
  twice.transform.rotation.z *= 2;
  twice.transform.rotation.w *= 2;
  EXPECT(buffer.setTransform(twice, "test"));
  EXPECT(near(buffer.lookupTransform("world", "robot", TimePointZero).transform.rotation.z, std::sqrt(0.5)));
}

void loops()
{
  BufferCore buffer;
  EXPECT(buffer.setTransform(placed("hen", "egg", 1, 0), "test"));
  EXPECT(buffer.setTransform(placed("egg", "hen", 1, 0), "test"));
  EXPECT(buffer.setTransform(placed("world", "robot", 1, 0), "test"));
  for (const auto time : {TimePointZero, timeFromSec(1)}) {
    const auto text = THROWN(tf2::LookupException, buffer.lookupTransform("robot", "egg", time));
    EXPECT(text.find("The tf tree is invalid because it contains a loop.\nFrame egg exists with parent hen.\n") == 0);
    EXPECT(!THROWN(tf2::LookupException, buffer.lookupTransform("egg", "robot", time)).empty());
  }
  EXPECT(buffer.canTransform("egg", "hen", TimePointZero));
}

void lists()
{
  BufferCore buffer;
  EXPECT(buffer.setTransform(placed("world", "robot", 10, 0), "somebody"));
  EXPECT(buffer.setTransform(placed("world", "robot", 12, 0), "somebody"));
  EXPECT(buffer.setTransform(placed("robot", "laser", 12, 0), "another", true));
  EXPECT(buffer.allFramesAsString() == "Frame robot exists with parent world.\nFrame laser exists with parent robot.\n");
  EXPECT(
    buffer.allFramesAsYAML(timeFromSec(12.5)) ==
    "robot: \n  parent: 'world'\n  broadcaster: 'somebody'\n  rate: 1.000\n  most_recent_transform: 12.000000\n"
    "  oldest_transform: 10.000000\n  transform_delay: 0.500\n  buffer_length: 2.000\n"
    "laser: \n  parent: 'robot'\n  broadcaster: 'another'\n  rate: 10000.000\n  most_recent_transform: 0.000000\n"
    "  oldest_transform: 0.000000\n  transform_delay: 12.500\n  buffer_length: 0.000\n");
  EXPECT(buffer.allFramesAsYAML().find("transform_delay") == std::string::npos);
  std::string parent;
  EXPECT(buffer._getParent("laser", TimePointZero, parent) && parent == "robot");
  EXPECT(!buffer._getParent("robot", timeFromSec(20), parent) && !buffer._getParent("moon", TimePointZero, parent));
  EXPECT(!buffer._getParent("world", TimePointZero, parent));
}

void requests()
{
  BufferCore buffer;
  std::vector<std::string> answers;
  const auto note =
    [&answers](auto, const std::string & target, const std::string & source, auto, tf2::TransformableResult result) {
      answers.push_back(target + " " + source + (result == tf2::TransformAvailable ? " yes" : " no"));
    };
  EXPECT(buffer.addTransformableRequest(note, "same", "same", TimePointZero) == 0);
  EXPECT(buffer.addTransformableRequest(note, "world", "robot", timeFromSec(11)) == 1);
  EXPECT(buffer.addTransformableRequest(note, "world", "laser", timeFromSec(11)) == 2);
  EXPECT(buffer.addTransformableRequest(note, "world", "laser", timeFromSec(12)) == 3);
  EXPECT(buffer.setTransform(placed("world", "robot", 10, 0), "test") && answers.empty());
  EXPECT(buffer.setTransform(placed("world", "robot", 12, 0), "test"));
  EXPECT((answers == std::vector<std::string>{"world robot yes"}));
  buffer.cancelTransformableRequest(3);
  EXPECT(buffer.setTransform(placed("robot", "laser", 0, 0), "test", true));
  EXPECT((answers == std::vector<std::string>{"world robot yes", "world laser yes"}));
  EXPECT(buffer.addTransformableRequest(note, "world", "laser", timeFromSec(11)) == 0);
  EXPECT(buffer.addTransformableRequest(note, "world", "laser", timeFromSec(1)) == ~0ULL);
  EXPECT(buffer.addTransformableRequest(note, "world", "laser", timeFromSec(13)) == 4);
  buffer.clear();
  EXPECT(buffer.setTransform(placed("world", "robot", 30, 0), "test"));
  EXPECT(answers.back() == "world laser no");
}

int main(int, char * argv[])
{
  return run_case(
  {
    {"times", times},
    {"vectors", vectors},
    {"rotations", rotations},
    {"matrices", matrices},
    {"upright", upright},
    {"transforms", transforms},
    {"lookups", lookups},
    {"latest", latest},
    {"interpolation", interpolation},
    {"extrapolation", extrapolation},
    {"unknown", unknown},
    {"questions", questions},
    {"fixed_frames", fixed_frames},
    {"static_frames", static_frames},
    {"memory", memory},
    {"nonsense", nonsense},
    {"loops", loops},
    {"lists", lists},
    {"requests", requests},
  }, argv[1]);
}
