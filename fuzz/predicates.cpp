// The predicates against their definitions in rational arithmetic, and their identities.
#include <utility>

#include <tetloft/predicates.hpp>

#include "fuzz/target.hpp"
#include "support/exact/predicates.hpp"

namespace tetloft::fuzz {
namespace {

bool equal(Sign s, int by_definition) { return static_cast<int>(s) == by_definition; }

void in_the_plane(Coordinates& coordinates) {
  std::array<Point2, 4> p{};
  for (Point2& q : p) q = {coordinates.next(), coordinates.next()};
  const auto& [a, b, c, d] = p;
  require(equal(orient2d(a, b, c), oracle::orient2d(a, b, c)), "orient2d");
  require(orient2d(b, a, c) == -orient2d(a, b, c), "orient2d under a swap");
  require(equal(incircle(a, b, c, d), oracle::incircle(a, b, c, d)), "incircle");
  require(incircle(a, c, b, d) == -incircle(a, b, c, d), "incircle under a swap");
  const Sign perturbed = incircle_perturbed(a, b, c, d);
  require(equal(perturbed, oracle::incircle_perturbed(a, b, c, d)), "incircle_perturbed");
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      auto q = p;
      std::swap(q[i], q[j]);
      require(incircle_perturbed(q[0], q[1], q[2], q[3]) == -perturbed,
              "incircle_perturbed under a swap");
    }
  }
  if (incircle(a, b, c, d) != Sign::zero) {
    require(perturbed == incircle(a, b, c, d), "the perturbation changed a sign (plane)");
  }
}

void in_space(Coordinates& coordinates) {
  std::array<Point3, 5> p{};
  for (Point3& q : p) q = {coordinates.next(), coordinates.next(), coordinates.next()};
  const auto& [a, b, c, d, e] = p;
  require(equal(orient3d(a, b, c, d), oracle::orient3d(a, b, c, d)), "orient3d");
  require(orient3d(a, b, d, c) == -orient3d(a, b, c, d), "orient3d under a swap");
  require(equal(insphere(a, b, c, d, e), oracle::insphere(a, b, c, d, e)), "insphere");
  const Sign perturbed = insphere_perturbed(a, b, c, d, e);
  require(equal(perturbed, oracle::insphere_perturbed(a, b, c, d, e)), "insphere_perturbed");
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      auto q = p;
      std::swap(q[i], q[j]);
      require(insphere_perturbed(q[0], q[1], q[2], q[3], q[4]) == -perturbed,
              "insphere_perturbed under a swap");
    }
  }
  if (insphere(a, b, c, d, e) != Sign::zero) {
    require(perturbed == insphere(a, b, c, d, e), "the perturbation changed a sign (space)");
  }
}

}  // namespace
}  // namespace tetloft::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tetloft::fuzz;
  if (size > 256) return 0;
  Bytes bytes(data, size);
  Coordinates coordinates(bytes);
  in_the_plane(coordinates);
  in_space(coordinates);
  return 0;
}
