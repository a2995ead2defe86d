// Bytes: what is read back is what was written, and what is damaged is refused.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <string>

#include "constrained_support.hpp"
#include "support/signed_record.hpp"

namespace tetloft::test {
namespace {

TEST(Bytes, BringBackHandlesConstraintsAndTriangles) {
  std::size_t bent = 0, gone = 0;
  for (const PlaneSource& source : plane_sources()) {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      SCOPED_TRACE(::testing::Message() << source.name << ", seed " << seed);
      Prng prng(seed);
      DelaunayTriangulation2 t = constrained_at_random(source, prng);
      const std::vector<std::byte> bytes = value_of(t.serialise());
      DelaunayTriangulation2 back = value_of(DelaunayTriangulation2::deserialise(bytes));
      ASSERT_TRUE(are_same_constrained(t, back));
      ASSERT_TRUE(is_constrained_delaunay(back, false));
      EXPECT_EQ(value_of(back.serialise()), bytes);
      for (const ConstraintId c : t.constraints()) bent += t.edges(c).size() > 1 ? 1U : 0U;
      // What is done to both leaves both the same.
      const auto made = value_of(t.insert({100, 101}));
      EXPECT_EQ(value_of(back.insert({100, 101})).vertex, made.vertex);
      const DelaunayVertex u = live_vertices(t).front();
      for (DelaunayTriangulation2* one : {&t, &back}) {
        (void)value_of(one->insert_constraint(u, made.vertex, Crossing::split));
      }
      ASSERT_TRUE(are_same_constrained(t, back));
      gone += t.constraints().back().index() + 1 > t.constraint_count() ? 1U : 0U;
      for (const ConstraintId c : t.constraints()) succeed(back.remove_constraint(c));
      EXPECT_TRUE(equals_batch(back));
    }
  }
  EXPECT_GT(bent, 100U);
  EXPECT_GT(gone, 10U);
}

TEST(Bytes, OfNothing) {
  const std::vector<std::byte> bytes = value_of(DelaunayTriangulation2().serialise());
  EXPECT_EQ(value_of(DelaunayTriangulation2::deserialise(bytes)).vertex_slots(), 0U);
  EXPECT_EQ(DelaunayTriangulation2::deserialise({}).error().code, ErrorCode::invalid_input);
  DelaunayTriangulation2 t;
  succeed(t.remove(value_of(t.insert({1, 2})).vertex));
  DelaunayTriangulation2 back =
      value_of(DelaunayTriangulation2::deserialise(value_of(t.serialise())));
  EXPECT_EQ(value_of(back.insert({3, 4})).vertex, (DelaunayVertex{0, 1}));
}

TEST(Bytes, DamagedAreRefused) {
  Prng prng(5);
  const DelaunayTriangulation2 t = constrained_at_random(plane_sources()[1], prng);
  const std::vector<std::byte> whole = value_of(t.serialise());
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::vector<std::byte> bytes = whole;
    bytes[i] ^= static_cast<std::byte>(1U << prng.below(8));
    EXPECT_EQ(DelaunayTriangulation2::deserialise(bytes).error().code, ErrorCode::invalid_input);
    bytes = whole;
    bytes.resize(i);
    EXPECT_EQ(DelaunayTriangulation2::deserialise(bytes).error().code, ErrorCode::invalid_input);
  }
}

Result<DelaunayTriangulation2> read_of(const std::string& record) {
  const std::string bytes = tetloft::testing::signed_again(record);
  return DelaunayTriangulation2::deserialise(std::as_bytes(std::span(bytes)));
}

std::string record_of(const DelaunayTriangulation2& t) {
  const std::vector<std::byte> bytes = value_of(t.serialise());
  std::string record(bytes.size(), '\0');
  std::memcpy(record.data(), bytes.data(), bytes.size());
  return record;
}

// Whoever makes the checksum fit as well gets a triangulation that is one, or nothing.
TEST(Bytes, ForgedAreRefusedOrOfATriangulation) {
  std::size_t read = 0, refused = 0;
  for (const PlaneSource& source : plane_sources()) {
    SCOPED_TRACE(source.name);
    Prng prng(6);
    const std::string whole = record_of(constrained_at_random(source, prng));
    for (int round = 0; round < 150; ++round) {
      std::string record = whole;
      for (std::uint64_t k = prng.below(3); k < 3; ++k) {
        // Behind the header; mostly in numbers of one byte.
        const std::size_t at = 24 + prng.below(record.size() - 32);
        record[at] = static_cast<char>(prng.chance(0.8) ? prng.below(40) : prng.below(256));
      }
      Result<DelaunayTriangulation2> t = read_of(record);
      if (!t) {
        EXPECT_EQ(t.error().code, ErrorCode::invalid_input) << to_string(t.error());
        ++refused;
        continue;
      }
      ++read;
      ASSERT_TRUE(is_constrained_delaunay(*t, false));
      EXPECT_EQ(record_of(*t), tetloft::testing::signed_again(record));
      for (const ConstraintId c : t->constraints()) succeed(t->remove_constraint(c));
      ASSERT_TRUE(constrained_edges(*t).empty());
      while (t->vertex_count() != 0) succeed(t->remove(*t->vertices().begin()));
    }
  }
  EXPECT_GT(read, 100U);
  EXPECT_GT(refused, 500U);
}

// The square 0 1 2 3 with 4 in the middle; 4-byte numbers of its record from behind the vertices:
// two counts of eight bytes, then constraints by their ends, and pieces by edge and constraint.
struct Square {
  std::string record;
  std::size_t constraints;  // where they begin
  std::size_t pieces;

  Square() {
    const std::vector<Point2> points{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 1}};
    DelaunayTriangulation2 t = value_of(DelaunayTriangulation2::of(points));
    (void)value_of(t.insert_constraint(t.vertex_at(0), t.vertex_at(1)));
    (void)value_of(t.insert_constraint(t.vertex_at(0), t.vertex_at(2)));
    record = record_of(t);
    constraints = 24 + 8 + 5 * 4 + 8 + 8 + 5 * 20 + 8;
    pieces = constraints + 2 * 8 + 8;
  }
  void put(std::size_t at, std::uint32_t value) {
    for (std::size_t i = 0; i < 4; ++i) record[at + i] = static_cast<char>(value >> (8 * i));
  }
  [[nodiscard]] std::string refusal() const {
    const Result<DelaunayTriangulation2> read = read_of(record);
    return read.ok() ? "none" : read.error().message;
  }
};

void expect_refusal(const std::function<void(Square&)>& forge, const std::string& reason) {
  Square square;
  forge(square);
  EXPECT_NE(square.refusal().find(reason), std::string::npos) << square.refusal();
}

TEST(Bytes, ForgedConstraintsAreNamed) {
  constexpr std::uint32_t kNone = 0xFFFFFFFFU;
  expect_refusal([](Square&) {}, "none");
  expect_refusal([](Square& s) { s.put(s.constraints, 1); }, "ends are no two vertices");
  expect_refusal([](Square& s) { s.put(s.constraints + 4, 5); }, "ends are no two vertices");
  expect_refusal([](Square& s) { s.put(s.constraints, kNone); }, "ends are no two vertices");
  expect_refusal([](Square& s) { s.put(s.constraints + 4, 2); }, "no way between its ends");
  // Constraint 0 is gone, its edge is there.
  expect_refusal(
      [](Square& s) {
        s.put(s.constraints, kNone);
        s.put(s.constraints + 4, kNone);
      },
      "that there is none of");
  expect_refusal([](Square& s) { s.put(s.pieces + 8, 2); }, "that there is none of");
  expect_refusal([](Square& s) { s.put(s.pieces, 1); }, "over what is no edge");
  expect_refusal([](Square& s) { s.put(s.pieces + 4, 9); }, "over what is no edge");
  expect_refusal([](Square& s) { s.put(s.pieces + 4, 3); }, "not in order");
  expect_refusal([](Square& s) { s.put(s.pieces + 12 + 8, 0); }, "no way between its ends");
  // 0 1 becomes 1 3, which crosses 0 2.
  expect_refusal(
      [](Square& s) {
        s.put(s.constraints, 1);
        s.put(s.constraints + 4, 3);
        s.put(s.pieces + 0, 0);
        s.put(s.pieces + 4, 2);
        s.put(s.pieces + 8, 1);
        s.put(s.pieces + 12, 1);
        s.put(s.pieces + 16, 3);
        s.put(s.pieces + 20, 0);
      },
      "constraints that cross");
  // Vertex 4 comes to lie on 0 2, its second coordinate being 2.
  expect_refusal([](Square& s) { s.put(24 + 8 + 20 + 8 + 8 + 4 * 20 + 16, 0x40000000U); },
                 "pass vertices");
  // Vertex 1 comes to lie at vertex 0.
  expect_refusal([](Square& s) { s.put(24 + 8 + 20 + 8 + 8 + 20 + 8, 0); }, "at one point");
}

}  // namespace
}  // namespace tetloft::test
