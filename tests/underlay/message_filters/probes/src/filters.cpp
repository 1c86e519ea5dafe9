#include "case.hpp"
#include "message_filters/cache.h"
#include "message_filters/pass_through.h"
#include "message_filters/subscriber.h"
#include "message_filters/sync_policies/approximate_time.h"
#include "message_filters/sync_policies/exact_time.h"
#include "message_filters/synchronizer.h"
#include "message_filters/time_sequencer.h"
#include "message_filters/time_synchronizer.h"
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/header.hpp"

namespace
{

using namespace std::chrono_literals;
using std::placeholders::_1;
using std::placeholders::_2;

struct Note
{
  std_msgs::msg::Header header;
};
using Ptr = std::shared_ptr<Note const>;
using Input = message_filters::PassThrough<Note>;
using Numbers = std::vector<int>;

constexpr std::int64_t kSecond = 1000000000;

rclcpp::Time at(int seconds)
{
  return rclcpp::Time(seconds, 0, RCL_ROS_TIME);
}

Ptr note(int seconds)
{
  const auto made = std::make_shared<Note>();
  made->header.stamp = at(seconds);
  return made;
}

int time_of(const Ptr & one)
{
  return one ? static_cast<int>(one->header.stamp.sec) : -1;
}

Numbers times_of(const std::vector<Ptr> & notes)
{
  Numbers times;
  for (const auto & one : notes) {
    times.push_back(time_of(one));
  }
  return times;
}

Numbers heard_by_function;

void by_function(const Ptr & one)
{
  heard_by_function.push_back(time_of(one));
}

/// Hears of messages in all ways.
struct Listener
{
  void by_pointer(const std::shared_ptr<Note> one) {changed = one;}
  void by_event(const message_filters::MessageEvent<Note const> & event) {received = event.getReceiptTime();}
  void of_two(const Ptr & one, const Ptr & other) {sets.push_back({time_of(one), time_of(other)});}
  void by_value(const Note & one, std::shared_ptr<Note> other)
  {
    sets.push_back({static_cast<int>(one.header.stamp.sec), time_of(other)});
  }
  void dropped(const Ptr & one, const Ptr & other) {drops.push_back({time_of(one), time_of(other)});}

  std::shared_ptr<Note> changed;
  rclcpp::Time received;
  std::vector<Numbers> sets;
  std::vector<Numbers> drops;
};

void callbacks_of_any_form()
{
  Input input;
  Listener listener;
  Numbers heard;
  input.registerCallback(by_function);
  input.registerCallback(&Listener::by_pointer, &listener);
  input.registerCallback(&Listener::by_event, &listener);
  auto lambda = input.registerCallback([&](const Ptr & one) {heard.push_back(time_of(one));});
  input.registerCallback(
    std::function<void(const Note &)>([&](const Note & one) {heard.push_back(-one.header.stamp.sec);}));
  const auto sent = note(5);
  input.add(message_filters::MessageEvent<Note const>(sent, at(7)));
  EXPECT(heard_by_function == Numbers{5});
  EXPECT(time_of(listener.changed) == 5 && listener.changed != sent);
  EXPECT(listener.received == at(7));
  EXPECT(heard == Numbers({5, -5}));
  lambda.disconnect();
  input.add(note(6));
  EXPECT(heard == Numbers({5, -5, -6}));
}

void a_callback_may_disconnect_itself()
{
  message_filters::Connection connection;
  int calls = 0;
  int others = 0;
  {
    Input input;
    connection = input.registerCallback([&](const Ptr &) {++calls; connection.disconnect();});
    input.registerCallback([&](const Ptr &) {++others;});
    input.add(note(1));
    input.add(note(2));
  }
  connection.disconnect();  // its input is gone
  EXPECT(calls == 1 && others == 2);
}

void a_cache_keeps_the_last_ones()
{
  Input input;
  message_filters::Cache<Note> cache(input, 4);
  EXPECT(!cache.getElemBeforeTime(at(9)) && cache.getSurroundingInterval(at(1), at(9)).empty());
  EXPECT(cache.getLatestTime().nanoseconds() == 0);
  for (const int time : {1, 7, 3, 5, 9}) {
    input.add(note(time));
  }
  EXPECT(times_of(cache.getInterval(at(0), at(20))) == Numbers({3, 5, 7, 9}));
  EXPECT(times_of(cache.getInterval(at(5), at(7))) == Numbers({5, 7}));
  EXPECT(cache.getInterval(at(10), at(20)).empty());
  EXPECT(times_of(cache.getSurroundingInterval(at(6), at(6))) == Numbers({5, 7}));
  EXPECT(times_of(cache.getSurroundingInterval(at(1), at(4))) == Numbers({3, 5}));
  EXPECT(times_of(cache.getSurroundingInterval(at(30), at(40))) == Numbers{9});
  EXPECT(time_of(cache.getElemBeforeTime(at(5))) == 3 && !cache.getElemBeforeTime(at(3)));
  EXPECT(time_of(cache.getElemAfterTime(at(5))) == 7 && !cache.getElemAfterTime(at(9)));
  EXPECT(cache.getOldestTime() == at(3) && cache.getLatestTime() == at(9));
}

void equal_times_come_together()
{
  Input one;
  Input other;
  Listener listener;
  message_filters::TimeSynchronizer<Note, Note> sync(one, other, 2);
  sync.registerCallback(&Listener::of_two, &listener);
  sync.registerCallback(std::bind(&Listener::of_two, &listener, _2, _1));
  sync.registerCallback(&Listener::by_value, &listener);
  sync.registerDropCallback(&Listener::dropped, &listener);
  one.add(note(1));
  one.add(note(2));
  EXPECT(listener.sets.empty());
  other.add(note(2));
  EXPECT(listener.sets == std::vector<Numbers>({{2, 2}, {2, 2}, {2, 2}}));
  EXPECT(listener.drops == std::vector<Numbers>({{1, -1}}));
  EXPECT(sync.getLastSignalTime() == at(2));
  other.add(note(5));
  other.add(note(4));
  one.add(note(6));
  EXPECT(listener.drops == std::vector<Numbers>({{1, -1}, {-1, 4}}));
}

void nine_inputs_come_together()
{
  using Policy = message_filters::sync_policies::ExactTime<
    Note, Note, Note, Note, Note, Note, Note, Note, Note>;
  Input in[9];
  message_filters::Synchronizer<Policy> sync(
    Policy(10), in[0], in[1], in[2], in[3], in[4], in[5], in[6], in[7], in[8]);
  int sum = 0;
  sync.registerCallback([&](const auto & ... each) {sum += (... + time_of(each));});
  for (auto & input : in) {
    EXPECT(sum == 0);
    input.add(note(2));
  }
  EXPECT(sum == 18);
}

using Pairs = message_filters::Synchronizer<message_filters::sync_policies::ApproximateTime<Note, Note>>;

/// Gives messages to `pairs`: an odd time to the second input, an even time to the first one.
std::vector<Numbers> brought_together(Pairs & pairs, const Numbers & times)
{
  Listener listener;
  auto connection = pairs.registerCallback(&Listener::of_two, &listener);
  for (const int time : times) {
    time % 2 == 0 ? pairs.add<0>(note(time)) : pairs.add<1>(note(time));
  }
  connection.disconnect();
  return listener.sets;
}

void close_times_come_together()
{
  Pairs early(10);
  EXPECT(brought_together(early, {0, 1, 10, 11, 20, 21}) == std::vector<Numbers>({{0, 1}, {10, 11}}));
  // 10 is closer to 13 than 0 is, and 14 is closer still.
  Pairs best(10);
  EXPECT(brought_together(best, {0, 10, 13, 14, 31, 40}) == std::vector<Numbers>({{14, 13}}));
  EXPECT(brought_together(best, {41, 70, 71}) == std::vector<Numbers>({{40, 41}}));
  EXPECT(brought_together(best, {80, 81}) == std::vector<Numbers>({{70, 71}}));
}

void options_of_approximate_times()
{
  Pairs narrow(10);
  narrow.setMaxIntervalDuration(rclcpp::Duration(3, 0));
  EXPECT(brought_together(narrow, {0, 5, 10, 11, 20, 21}) == std::vector<Numbers>({{10, 11}}));
  // Nothing closer can come within the next 8 seconds.
  Pairs bounded(10);
  bounded.setInterMessageLowerBound(0, rclcpp::Duration(8, 0));
  bounded.setInterMessageLowerBound(1, rclcpp::Duration(8, 0));
  EXPECT(brought_together(bounded, {0, 1}) == std::vector<Numbers>({{0, 1}}));
  // 8 is closer to 5 than 0 is, but later.
  Pairs patient(10);
  EXPECT(brought_together(patient, {0, 5, 8, 21}) == std::vector<Numbers>({{8, 5}}));
  Pairs hasty(10);
  hasty.setAgePenalty(100);
  EXPECT(brought_together(hasty, {0, 5, 8, 21}) == std::vector<Numbers>({{0, 5}}));
  // Only two of each are kept.
  Pairs small(2);
  EXPECT(brought_together(small, {0, 2, 4, 6, 7, 9, 20, 21}) == std::vector<Numbers>({{6, 7}, {20, 21}}));
  // 0 was dropped, and 1 belongs to it.
  Pairs lossy(2);
  EXPECT(brought_together(lossy, {0, 2, 4, 1, 5, 20, 21}) == std::vector<Numbers>({{4, 5}}));
}

void a_sequencer_puts_in_order()
{
  rclcpp::init(0, nullptr);
  const auto node = std::make_shared<rclcpp::Node>("sequencer");
  Input input;
  message_filters::TimeSequencer<Note> sequencer(
    input, rclcpp::Duration(1, 0), rclcpp::Duration(0, 1000000), 3, node);
  Numbers heard;
  sequencer.registerCallback([&](const Ptr & one) {heard.push_back(time_of(one));});
  for (const int time : {9, 4, 2, 6}) {
    input.add(note(time));
  }
  EXPECT(heard.empty());
  wait_until([&] {rclcpp::spin_some(node); return heard.size() == 3;});
  EXPECT(heard == Numbers({4, 6, 9}));  // the oldest was one too many
  input.add(note(8));
  input.add(note(10));
  wait_until([&] {rclcpp::spin_some(node); return heard.size() > 3;});
  EXPECT(heard == Numbers({4, 6, 9, 10}));
  const auto future = static_cast<int>(node->now().nanoseconds() / kSecond) + 100;
  input.add(note(future));
  std::this_thread::sleep_for(50ms);
  rclcpp::spin_some(node);
  EXPECT(heard.size() == 4);
  rclcpp::shutdown();
}

void subscribers_are_inputs()
{
  using std_msgs::msg::Header;
  rclcpp::init(0, nullptr);
  auto node = std::make_shared<rclcpp::Node>("filters");
  message_filters::Subscriber<Header> first(node, "first");
  message_filters::Subscriber<Header> second;
  second.subscribe();  // has no topic yet
  second.subscribe(node.get(), "second", rmw_qos_profile_sensor_data);
  EXPECT(second.getTopic() == "second" && second.getSubscriber());
  int calls = 0;
  first.registerCallback([&](const std::shared_ptr<Header const> &) {++calls;});
  second.registerCallback([&](const std::shared_ptr<Header const> &) {++calls;});
  const auto to_first = node->create_publisher<Header>("first", 10);
  const auto to_second = node->create_publisher<Header>("second", 10);
  const auto said = [&] {
      const int before = calls;
      to_first->publish(Header());
      to_second->publish(Header());
      wait_until([&] {rclcpp::spin_some(node); return calls > before;});
      std::this_thread::sleep_for(20ms);
      rclcpp::spin_some(node);
      return calls - before;
    };
  wait_until([&] {return to_first->get_subscription_count() && to_second->get_subscription_count();});
  wait_until([&] {return said() == 2;});
  second.unsubscribe();
  EXPECT(!second.getSubscriber() && said() == 1);
  second.subscribe();
  wait_until([&] {return said() == 2;});
  rclcpp::shutdown();
}

}  // namespace

int main(int, char * argv[])
{
  return run_case({
    {"callbacks_of_any_form", callbacks_of_any_form},
    {"a_callback_may_disconnect_itself", a_callback_may_disconnect_itself},
    {"a_cache_keeps_the_last_ones", a_cache_keeps_the_last_ones},
    {"equal_times_come_together", equal_times_come_together},
    {"nine_inputs_come_together", nine_inputs_come_together},
    {"close_times_come_together", close_times_come_together},
    {"options_of_approximate_times", options_of_approximate_times},
    {"a_sequencer_puts_in_order", a_sequencer_puts_in_order},
    {"subscribers_are_inputs", subscribers_are_inputs},
  }, argv[1]);
}
