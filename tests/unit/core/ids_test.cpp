// Strong ids: what must not compile is asked of the compiler.
#include <tetloft/ids.hpp>

#include <gtest/gtest.h>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace tetloft {
namespace {

template <class A, class B>
concept Equatable = requires(A a, B b) {
  a == b;
};
template <class A, class B>
concept Ordered = requires(A a, B b) {
  a < b;
};
template <class Container, class Index>
concept IndexedBy = requires(Container c, Index i) {
  c[i];
};

static_assert(Equatable<VertexId, VertexId>);
static_assert(!Equatable<VertexId, TetId>);
static_assert(Ordered<TetId, TetId>);
static_assert(!Ordered<VertexId, TetId>);
static_assert(!Equatable<VertexId, std::uint32_t>);
static_assert(!std::convertible_to<int, VertexId>);
static_assert(!std::convertible_to<VertexId, std::uint32_t>);
static_assert(!std::constructible_from<VertexId, TetId>);
static_assert(std::constructible_from<VertexId, std::size_t>);
static_assert(IndexedBy<IdVector<VertexId, int>, VertexId>);
static_assert(!IndexedBy<IdVector<VertexId, int>, TetId>);
static_assert(!IndexedBy<IdVector<VertexId, int>, std::size_t>);
static_assert(sizeof(VertexId) == 4);

TEST(Id, IsInvalidByDefault) {
  EXPECT_FALSE(VertexId().valid());
  EXPECT_EQ(VertexId().value(), VertexId::kInvalid);
  EXPECT_TRUE(VertexId(0).valid());
  EXPECT_NE(VertexId(), VertexId(0));
}

TEST(Id, OrdersByValueWithInvalidLast) {
  EXPECT_LT(TetId(3), TetId(4));
  EXPECT_LT(TetId(1U << 31), TetId());
}

TEST(IdVector, PushBackReturnsTheIdOfWhatItAppended) {
  IdVector<TetId, std::string> names;
  EXPECT_EQ(names.end_id(), TetId(0));
  EXPECT_EQ(names.push_back("a"), TetId(0));
  EXPECT_EQ(names.push_back("b"), TetId(1));
  EXPECT_EQ(names.end_id(), TetId(2));
  EXPECT_EQ(names[TetId(1)], "b");
}

TEST(IdVector, HoldsWhatItWasFilledWith) {
  IdVector<VertexId, int> values(2, 7);
  values.resize(3, 8);
  EXPECT_EQ(values.raw(), (std::vector<int>{7, 7, 8}));
  values.assign(1, 9);
  EXPECT_EQ(values, (IdVector<VertexId, int>(std::vector<int>{9})));
  values.clear();
  EXPECT_TRUE(values.empty());
}

TEST(IdVector, OfFlagsCanBeWritten) {
  IdVector<ContourId, bool> flags(3, false);
  flags[ContourId(1)] = true;
  const auto& read = flags;
  EXPECT_FALSE(read[ContourId(0)]);
  EXPECT_TRUE(read[ContourId(1)]);
}

}  // namespace
}  // namespace tetloft
