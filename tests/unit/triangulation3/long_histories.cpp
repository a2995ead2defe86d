// tetloft_histories: random histories of triangulations of space or of the plane, as long as you
// have patience for. Small ones are compared with the batch often, large ones seldom.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "support.hpp"
#include "unit/triangulation2/constrained_support.hpp"

namespace {

using namespace tetloft;
using namespace tetloft::test;

constexpr const char* kUsage =
    "usage: tetloft_histories [--plane] [--operations N] [--seed S]\n"
    "  --plane         of triangulations of the plane, with constraints that come and go\n"
    "  --operations N  in all (default 100000)\n"
    "  --seed S        of the first history, each next one has one more (default 1)\n"
    "Exit code 0: all equal the batch; 1: one does not, which is named.\n";

struct Options {
  bool plane = false;
  std::uint64_t operations = 100'000;
  std::uint64_t seed = 1;
};

struct Size {
  std::uint64_t operations;  // of a history
  std::uint64_t between;     // comparisons
};
constexpr Size kSmall{400, 10};
constexpr Size kLarge{20'000, 4'000};

struct Totals {
  std::uint64_t operations = 0;
  std::uint64_t comparisons = 0;
  std::size_t most_vertices = 0;
};

double of_grid(Prng& prng, std::uint64_t side) { return static_cast<double>(prng.below(side)); }

// Of more places than those of point_sources().
std::vector<PointSource> large_sources() {
  return {{"large cube",
           [](Prng& r) {
             const double x = r.unit(), y = r.unit();
             return Point3{x, y, r.unit()};
           }},
          {"large lattice",
           [](Prng& r) {
             const double x = of_grid(r, 16), y = of_grid(r, 16);
             return Point3{x, y, of_grid(r, 16)};
           }},
          {"large plane and a few",
           [](Prng& r) {
             const double x = of_grid(r, 40), y = of_grid(r, 40);
             return Point3{x, y, r.chance(0.05) ? 1 + of_grid(r, 3) : 0};
           }},
          {"sphere up to rounding", [](Prng& r) {
             const double x = r.unit() - 0.5, y = r.unit() - 0.5, z = r.unit() - 0.5;
             const double length = std::sqrt(x * x + y * y + z * z);
             return length > 0 ? Point3{x / length, y / length, z / length} : Point3{1, 0, 0};
           }}};
}

// Of more places than those of plane_sources().
std::vector<PlaneSource> large_plane_sources() {
  return {{"large square",
           [](Prng& r) {
             const double x = r.unit();
             return Point2{x, r.unit()};
           }},
          {"large lattice",
           [](Prng& r) {
             const double x = of_grid(r, 64);
             return Point2{x, of_grid(r, 64)};
           }},
          {"large row and a few",
           [](Prng& r) {
             const double x = of_grid(r, 4000);
             return Point2{x, r.chance(0.05) ? 1 + of_grid(r, 3) : 0};
           }},
          {"circle up to rounding", [](Prng& r) {
             const double angle = 6.283185307179586 * r.unit();
             return Point2{std::cos(angle), std::sin(angle)};
           }}};
}

// Of a triangulation of the plane: constraints that come and go, and what they allow.
class Constraints {
 public:
  explicit Constraints(DelaunayTriangulation2& made) : made_(made) {}

  // One more or one less. Those that cross others are refused.
  void change(DelaunayVertex u, DelaunayVertex v, bool growing, Prng& prng) {
    if (live_.empty() || prng.chance(growing ? 0.6 : 0.3)) {
      if (const auto c = made_.insert_constraint(u, v)) live_.push_back(*c);
      return;
    }
    const std::size_t k = prng.below(live_.size());
    succeed(made_.remove_constraint(live_[k]));
    live_[k] = live_.back();
    live_.pop_back();
  }
  [[nodiscard]] bool holds(DelaunayVertex v) const {
    const std::vector<DelaunayVertex> all = made_.neighbours(v);
    return std::any_of(all.begin(), all.end(),
                       [&](DelaunayVertex u) { return !made_.constraints(u, v).empty(); });
  }
  [[nodiscard]] testing::AssertionResult are_respected() const {
    for (const ConstraintId c : live_) {
      if (testing::AssertionResult covers = covers_its_segment(made_, c); !covers) return covers;
    }
    return is_constrained_delaunay(made_, false);
  }
  [[nodiscard]] bool empty() const { return live_.empty(); }

 private:
  DelaunayTriangulation2& made_;
  std::vector<ConstraintId> live_;
};

// There are none in space.
class NoConstraints {
 public:
  explicit NoConstraints(DelaunayTriangulation3&) {}
  [[nodiscard]] bool holds(DelaunayVertex) const { return false; }
};

// False where the triangulation is not that of the batch, or an operation ends as it should not.
template <class Triangulation, class Point>
class History {
  static constexpr bool kIsPlane = std::is_same_v<Point, Point2>;

 public:
  History(const SourceOf<Point>& source, std::uint64_t seed)
      : source_(source), prng_(seed), constraints_(made_) {}

  // Grows to about so many vertices, shrinks, and grows again.
  bool run(const Size& size, Totals& totals) {
    for (std::uint64_t k = 1; k <= size.operations; ++k) {
      const bool growing = (k * 4 / size.operations) % 2 == 0;
      if (!change(growing)) return false;
      ++totals.operations;
      totals.most_vertices = std::max(totals.most_vertices, live_.size());
      if (k % size.between != 0 && k != size.operations) continue;
      ++totals.comparisons;
      const testing::AssertionResult equal = compared();
      if (!equal) {
        std::printf("operation %llu: %s\n", static_cast<unsigned long long>(k), equal.message());
        return false;
      }
    }
    return true;
  }

 private:
  [[nodiscard]] testing::AssertionResult compared() const {
    if constexpr (kIsPlane) {
      if (!constraints_.empty()) return constraints_.are_respected();
    }
    return equals_batch(made_);
  }
  bool change(bool growing) {
    if constexpr (kIsPlane) {
      if (live_.size() > 2 && prng_.chance(0.2)) {
        const DelaunayVertex u = any();
        constraints_.change(u, any(), growing, prng_);
        return true;
      }
    }
    const std::uint64_t draw = prng_.below(10);
    const std::uint64_t inserted_below = growing ? 7 : 2;
    if (live_.empty() || draw < inserted_below) {
      const bool from_any = live_.empty() || prng_.chance(0.5);
      const DelaunayVertex near = from_any ? DelaunayVertex() : any();
      const auto made = made_.insert(source_.draw(prng_), near);
      if (made && made->is_new) live_.push_back(made->vertex);
      return made.ok();
    }
    const std::size_t k = prng_.below(live_.size());
    if (draw < 9) {
      const DelaunayVertex v = live_[k];
      if (constraints_.holds(v)) return !made_.remove(v) && made_.is_live(v);
      live_[k] = live_.back();
      live_.pop_back();
      return made_.remove(v).ok() && !made_.is_live(v);
    }
    // Where another vertex is, or a constraint holds it, it stays.
    (void)made_.move(live_[k], source_.draw(prng_));
    return made_.is_live(live_[k]);
  }
  DelaunayVertex any() { return live_[prng_.below(live_.size())]; }

  const SourceOf<Point>& source_;
  Prng prng_;
  Triangulation made_;
  std::conditional_t<kIsPlane, Constraints, NoConstraints> constraints_;
  std::vector<DelaunayVertex> live_;
};

bool parse(int argc, char** argv, Options& options) {
  for (int i = 1; i < argc; ++i) {
    const std::string_view name = argv[i];
    if (name == "--plane") {
      options.plane = true;
      continue;
    }
    if (++i == argc || (name != "--operations" && name != "--seed")) return false;
    const std::string_view text = argv[i];
    std::uint64_t& value = name == "--seed" ? options.seed : options.operations;
    const char* const end = text.data() + text.size();
    const auto [stopped, failed] = std::from_chars(text.data(), end, value);
    if (failed != std::errc() || stopped != end) return false;
  }
  return true;
}

// One history of each source in turns, small or large as it is.
template <class Triangulation, class Point>
bool run_all(const std::vector<SourceOf<Point>>& small, const std::vector<SourceOf<Point>>& large,
             const Options& options, Totals& totals) {
  std::uint64_t seed = options.seed;
  const auto run = [&](const SourceOf<Point>& source, const Size& size) {
    History<Triangulation, Point> history(source, seed);
    const bool fine = history.run(size, totals);
    if (!fine) {
      std::printf("%s, seed %llu: FAILED\n", source.name.c_str(),
                  static_cast<unsigned long long>(seed));
    }
    return fine;
  };
  for (; totals.operations < options.operations; ++seed) {
    for (const SourceOf<Point>& source : small) {
      if (!run(source, kSmall)) return false;
    }
    // As many operations in large ones as in small ones.
    if (seed % 4 == 0 && !run(large[(seed / 4) % large.size()], kLarge)) return false;
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  if (!parse(argc, argv, options)) {
    std::fputs(kUsage, stderr);
    return 2;
  }
  Totals totals;
  const bool fine =
      options.plane
          ? run_all<DelaunayTriangulation2>(plane_sources(), large_plane_sources(), options, totals)
          : run_all<DelaunayTriangulation3>(point_sources(), large_sources(), options, totals);
  std::printf("%llu operations, %llu comparisons with the batch, up to %zu vertices: %s\n",
              static_cast<unsigned long long>(totals.operations),
              static_cast<unsigned long long>(totals.comparisons), totals.most_vertices,
              fine ? "all equal" : "FAILED");
  return fine ? 0 : 1;
}
