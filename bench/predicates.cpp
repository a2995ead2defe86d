#include "predicates.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <tetloft/predicates.hpp>

#include "core/prng.hpp"
#include "measure.hpp"

namespace tetloft::bench {

namespace {

using Arguments = std::array<Point3, 5>;
constexpr std::size_t kCalls = 4000;

std::vector<Arguments> draw(double (*coordinate)(Prng&)) {
  Prng prng(1);
  std::vector<Arguments> all(kCalls);
  for (Arguments& points : all) {
    for (Point3& p : points) {
      p.x = coordinate(prng);
      p.y = coordinate(prng);
      p.z = coordinate(prng);
    }
  }
  return all;
}

// Corners of cubes: cospherical, coplanar by fours in places.
template <double (*scale)(Prng&)>
std::vector<Arguments> cubes() {
  Prng prng(2);
  std::vector<Arguments> all(kCalls);
  for (Arguments& points : all) {
    const double size = scale(prng);
    std::array<unsigned, 8> corner{0, 1, 2, 3, 4, 5, 6, 7};
    prng.shuffle(corner);
    for (std::size_t i = 0; i < points.size(); ++i) {
      points[i] = {size * (corner[i] & 1U), size * ((corner[i] >> 1) & 1U),
                   size * ((corner[i] >> 2) & 1U)};
    }
  }
  return all;
}

double unit(Prng& prng) { return prng.unit(); }
double pixel(Prng& prng) { return static_cast<double>(prng.below(3)); }
double tenth(Prng& prng) { return static_cast<double>(prng.below(4)) / 10; }
double tenths(Prng& prng) { return static_cast<double>(1 + prng.below(9)) / 10; }
double huge(Prng& prng) { return 1e250 * static_cast<double>(prng.below(3)); }

struct Named {
  const char* name;
  PredicateCounters::Stages PredicateCounters::*counters;
  int (*call)(const Arguments&);
};

Point2 flat(const Point3& p) { return {p.x, p.y}; }

const Named kPredicates[] = {
    {"orient2d", &PredicateCounters::orient2d,
     [](const Arguments& p) {
       return static_cast<int>(orient2d(flat(p[0]), flat(p[1]), flat(p[2])));
     }},
    {"orient3d", &PredicateCounters::orient3d,
     [](const Arguments& p) { return static_cast<int>(orient3d(p[0], p[1], p[2], p[3])); }},
    {"incircle_perturbed", &PredicateCounters::incircle,
     [](const Arguments& p) {
       return static_cast<int>(incircle_perturbed(flat(p[0]), flat(p[1]), flat(p[2]), flat(p[3])));
     }},
    {"insphere_perturbed", &PredicateCounters::insphere,
     [](const Arguments& p) {
       return static_cast<int>(insphere_perturbed(p[0], p[1], p[2], p[3], p[4]));
     }},
};

PredicateTime time_one(const Named& predicate, const std::vector<Arguments>& arguments,
                       int rounds) {
  PredicateTime time{predicate.name, "", 1e300, 0};
  volatile int sink = 0;
  for (int round = 0; round < rounds; ++round) {
    const Clock clock;
    int sum = 0;
    for (const Arguments& a : arguments) sum += predicate.call(a);
    time.nanoseconds = std::min(time.nanoseconds, 1e9 * clock.seconds() / kCalls);
    sink = sum;
  }
  (void)sink;
  PredicateCounters counters;
  {
    const PredicateCounting counting(counters);
    for (const Arguments& a : arguments) predicate.call(a);
  }
  const PredicateCounters::Stages& s = counters.*predicate.counters;
  const std::pair<std::uint64_t, const char*> stages[] = {{s.filter, "filter"},
                                                          {s.lattice, "lattice"},
                                                          {s.expansion, "expansion"},
                                                          {s.integer, "integer"},
                                                          {s.symbolic, "symbolic"}};
  std::uint64_t total = 0;
  std::pair<std::uint64_t, const char*> most{0, ""};
  for (const auto& stage : stages) {
    total += stage.first;
    if (stage.first > most.first) most = stage;
  }
  time.stage = most.second;
  time.share = total == 0 ? 0 : static_cast<double>(most.first) / static_cast<double>(total);
  return time;
}

}  // namespace

std::vector<PredicateTime> time_predicates(int rounds) {
  const std::vector<std::vector<Arguments>> families{draw(unit), draw(pixel), draw(tenth),
                                                     cubes<tenths>(), draw(huge)};
  std::vector<PredicateTime> times;
  for (const Named& predicate : kPredicates) {
    for (const auto& family : families) times.push_back(time_one(predicate, family, rounds));
  }
  return times;
}

}  // namespace tetloft::bench
