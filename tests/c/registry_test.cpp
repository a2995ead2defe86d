// The registry of handles by itself.
#include "c/registry.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <new>
#include <set>

namespace tetloft::internal::c {
namespace {

Named number(int value) { return {HandleType::mesh, std::make_shared<const int>(value)}; }

TEST(Registry, FindsWhatWasAddedUntilItIsRemoved) {
  Registry registry;
  const HandleName one = registry.add(number(1));
  const HandleName two = registry.add(number(2));
  EXPECT_NE(one, two);
  EXPECT_EQ(registry.find(one).type, HandleType::mesh);
  EXPECT_EQ(*std::static_pointer_cast<const int>(registry.find(one).value), 1);
  EXPECT_EQ(*std::static_pointer_cast<const int>(registry.remove(two).value), 2);
  EXPECT_EQ(registry.find(two).value, nullptr);
  EXPECT_EQ(registry.remove(two).value, nullptr);
  EXPECT_EQ(registry.find(0).value, nullptr);
  EXPECT_EQ(*std::static_pointer_cast<const int>(registry.find(one).value), 1);
}

TEST(Registry, WhatIsRemovedLivesWithThoseWhoHoldIt) {
  Registry registry;
  const HandleName name = registry.add(number(7));
  const Named held = registry.find(name);
  const std::weak_ptr<const void> value = held.value;
  registry.remove(name);
  EXPECT_EQ(value.use_count(), 1);
  EXPECT_EQ(*std::static_pointer_cast<const int>(held.value), 7);
}

TEST(Registry, NamesAreNeitherSmallNorUsedTwice) {
  Registry registry;
  std::set<HandleName> names;
  for (int i = 0; i < 10000; ++i) {
    const HandleName name = registry.add(number(i));
    EXPECT_GT(name, 100000U);
    EXPECT_TRUE(names.insert(name).second);
    registry.remove(name);
  }
}

TEST(Registry, NamesEndAsMemoryDoes) {
  Registry registry(std::numeric_limits<HandleName>::max() - 2);
  const HandleName last_but_one = registry.add(number(1));
  const HandleName last = registry.add(number(2));
  EXPECT_NE(last, last_but_one);
  EXPECT_NE(last, 0U);
  for (int i = 0; i < 3; ++i)
    EXPECT_THROW(static_cast<void>(registry.add(number(3))), std::bad_alloc);
  EXPECT_EQ(*std::static_pointer_cast<const int>(registry.find(last).value), 2);
}

}  // namespace
}  // namespace tetloft::internal::c
