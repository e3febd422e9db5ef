// SPDX-License-Identifier: Apache-2.0
#include "core/base/bounded_queue.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <numeric>
#include <thread>
#include <vector>

namespace burin::base {
namespace {

using namespace std::chrono_literals;

TEST(BoundedQueue, DeliversInOrderThenEndsWhenClosed) {
  BoundedQueue<int> queue(4);
  std::vector<int> got;
  std::thread consumer([&] {
    while (const auto item = queue.Pop()) got.push_back(*item);
  });
  for (int i = 0; i < 1000; ++i) ASSERT_TRUE(queue.Push(i));
  queue.Close();
  consumer.join();
  std::vector<int> expected(1000);
  std::iota(expected.begin(), expected.end(), 0);
  EXPECT_EQ(got, expected);
}

TEST(BoundedQueue, NeverHoldsMoreThanItsCapacity) {
  BoundedQueue<int> queue(3);
  std::atomic<int> pushed{0};
  std::thread producer([&] {
    for (int i = 0; i < 10; ++i) {
      if (queue.Push(i)) ++pushed;
    }
  });
  while (queue.size() < 3) std::this_thread::sleep_for(1ms);
  std::this_thread::sleep_for(20ms);
  EXPECT_EQ(queue.size(), 3U);
  EXPECT_EQ(pushed, 3);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(queue.Pop(), i);
  producer.join();
}

TEST(BoundedQueue, AbortWakesAWaitingProducerAndDropsItems) {
  BoundedQueue<std::unique_ptr<int>> queue(1);
  ASSERT_TRUE(queue.Push(std::make_unique<int>(1)));
  std::atomic<bool> refused{false};
  std::thread producer([&] { refused = !queue.Push(std::make_unique<int>(2)); });
  std::this_thread::sleep_for(10ms);
  queue.Abort();
  producer.join();
  EXPECT_TRUE(refused);
  EXPECT_TRUE(queue.aborted());
  EXPECT_FALSE(queue.Pop().has_value());
}

TEST(BoundedQueue, AbortWakesAWaitingConsumer) {
  BoundedQueue<int> queue(1);
  std::atomic<bool> ended{false};
  std::thread consumer([&] { ended = !queue.Pop().has_value(); });
  std::this_thread::sleep_for(10ms);
  queue.Abort();
  consumer.join();
  EXPECT_TRUE(ended);
}

TEST(BoundedQueue, RefusesItemsOnceClosed) {
  BoundedQueue<int> queue(2);
  ASSERT_TRUE(queue.Push(1));
  queue.Close();
  EXPECT_FALSE(queue.Push(2));
  EXPECT_EQ(queue.Pop(), 1);
  EXPECT_FALSE(queue.Pop().has_value());
  EXPECT_FALSE(queue.aborted());
}

TEST(BoundedQueue, LosesNothingAmongManyThreads) {
  BoundedQueue<int> queue(5);
  constexpr int kProducers = 3, kItems = 500;
  std::atomic<long> sum{0};
  std::vector<std::thread> consumers, producers;
  for (int i = 0; i < 3; ++i) {
    consumers.emplace_back([&] {
      while (const auto item = queue.Pop()) sum += *item;
    });
  }
  for (int p = 0; p < kProducers; ++p) {
    producers.emplace_back([&] {
      for (int i = 1; i <= kItems; ++i) static_cast<void>(queue.Push(i));
    });
  }
  for (std::thread& thread : producers) thread.join();
  queue.Close();
  for (std::thread& thread : consumers) thread.join();
  EXPECT_EQ(sum, long{kProducers} * kItems * (kItems + 1) / 2);
}

}  // namespace
}  // namespace burin::base
