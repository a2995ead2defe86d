#include "predicates.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <tetloft/predicates.hpp>

#include "core/prng.hpp"
#include "measure.hpp"

namespace tetloft::bench {

using namespace internal;

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

constexpr std::pair<const char*, std::uint64_t PredicateCounters::Stages::*> kStages[] = {
    {"filter", &PredicateCounters::Stages::filter},
    {"lattice", &PredicateCounters::Stages::lattice},
    {"expansion", &PredicateCounters::Stages::expansion},
    {"integer", &PredicateCounters::Stages::integer},
    {"symbolic", &PredicateCounters::Stages::symbolic}};

// The best of the rounds, for one call.
double nanoseconds(const Named& predicate, const std::vector<Arguments>& arguments, int rounds) {
  double best = 1e300;
  // Few calls are repeated, as a clock does not resolve them.
  const std::size_t passes = 1 + kCalls / arguments.size();
  volatile int sink = 0;
  for (int round = 0; round < rounds; ++round) {
    const Clock clock;
    int sum = 0;
    for (std::size_t pass = 0; pass < passes; ++pass) {
      for (const Arguments& a : arguments) sum += predicate.call(a);
    }
    best = std::min(best, 1e9 * clock.seconds() / static_cast<double>(passes * arguments.size()));
    sink = sum;
  }
  (void)sink;
  return best;
}

void time_stages(const Named& predicate, const std::string& input,
                 const std::vector<Arguments>& arguments, int rounds,
                 std::vector<PredicateTime>& times) {
  times.push_back({predicate.name, input, "all", nanoseconds(predicate, arguments, rounds), 1});
  std::array<std::vector<Arguments>, std::size(kStages)> settled;
  for (const Arguments& a : arguments) {
    PredicateCounters counters;
    {
      const PredicateCounting counting(counters);
      predicate.call(a);
    }
    // The symbolic stage comes after one that found zero: the last that counted has settled.
    for (std::size_t k = std::size(kStages); k-- > 0;) {
      if (counters.*predicate.counters.*kStages[k].second == 0) continue;
      settled[k].push_back(a);
      break;
    }
  }
  for (std::size_t k = 0; k < std::size(kStages); ++k) {
    if (settled[k].empty()) continue;
    times.push_back(
        {predicate.name, input, kStages[k].first, nanoseconds(predicate, settled[k], rounds),
         static_cast<double>(settled[k].size()) / static_cast<double>(arguments.size())});
  }
}

}  // namespace

std::vector<PredicateTime> time_predicates(int rounds) {
  const std::pair<const char*, std::vector<Arguments>> families[] = {{"uniform", draw(unit)},
                                                                     {"pixels", draw(pixel)},
                                                                     {"tenths", draw(tenth)},
                                                                     {"cubes", cubes<tenths>()},
                                                                     {"huge", draw(huge)}};
  std::vector<PredicateTime> times;
  for (const Named& predicate : kPredicates) {
    for (const auto& [input, arguments] : families) {
      time_stages(predicate, input, arguments, rounds, times);
    }
  }
  return times;
}

}  // namespace tetloft::bench
