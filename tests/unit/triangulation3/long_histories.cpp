// tetloft_histories: random histories of triangulations of space, as long as you have patience for.
// Small ones are compared with the batch often, large ones seldom.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "support.hpp"

namespace {

using namespace tetloft;
using namespace tetloft::test;

constexpr const char* kUsage =
    "usage: tetloft_histories [--operations N] [--seed S]\n"
    "  --operations N  in all (default 100000)\n"
    "  --seed S        of the first history, each next one has one more (default 1)\n"
    "Exit code 0: all equal the batch; 1: one does not, which is named.\n";

struct Options {
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

// Of more places than those of point_sources().
std::vector<PointSource> large_sources() {
  const auto grid = [](Prng& r, std::uint64_t side) { return static_cast<double>(r.below(side)); };
  return {{"large cube",
           [](Prng& r) {
             const double x = r.unit(), y = r.unit();
             return Point3{x, y, r.unit()};
           }},
          {"large lattice",
           [=](Prng& r) {
             const double x = grid(r, 16), y = grid(r, 16);
             return Point3{x, y, grid(r, 16)};
           }},
          {"large plane and a few",
           [=](Prng& r) {
             const double x = grid(r, 40), y = grid(r, 40);
             return Point3{x, y, r.chance(0.05) ? 1 + grid(r, 3) : 0};
           }},
          {"sphere up to rounding", [](Prng& r) {
             const double x = r.unit() - 0.5, y = r.unit() - 0.5, z = r.unit() - 0.5;
             const double length = std::sqrt(x * x + y * y + z * z);
             return length > 0 ? Point3{x / length, y / length, z / length} : Point3{1, 0, 0};
           }}};
}

// False where the triangulation is not that of the batch, or an operation ends as it should not.
class History {
 public:
  History(const PointSource& source, std::uint64_t seed) : source_(source), prng_(seed) {}

  // Grows to about so many vertices, shrinks, and grows again.
  bool run(const Size& size, Totals& totals) {
    for (std::uint64_t k = 1; k <= size.operations; ++k) {
      const bool growing = (k * 4 / size.operations) % 2 == 0;
      if (!change(growing)) return false;
      ++totals.operations;
      totals.most_vertices = std::max(totals.most_vertices, live_.size());
      if (k % size.between != 0 && k != size.operations) continue;
      ++totals.comparisons;
      const testing::AssertionResult equal = equals_batch(made_);
      if (!equal) {
        std::printf("operation %llu: %s\n", static_cast<unsigned long long>(k), equal.message());
        return false;
      }
    }
    return true;
  }

 private:
  bool change(bool growing) {
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
      live_[k] = live_.back();
      live_.pop_back();
      return made_.remove(v).ok() && !made_.is_live(v);
    }
    // Where another vertex is, it stays.
    (void)made_.move(live_[k], source_.draw(prng_));
    return made_.is_live(live_[k]);
  }
  DelaunayVertex any() { return live_[prng_.below(live_.size())]; }

  const PointSource& source_;
  Prng prng_;
  DelaunayTriangulation3 made_;
  std::vector<DelaunayVertex> live_;
};

bool parse(int argc, char** argv, Options& options) {
  for (int i = 1; i < argc; i += 2) {
    const std::string_view name = argv[i];
    if (i + 1 == argc || (name != "--operations" && name != "--seed")) return false;
    const std::string_view text = argv[i + 1];
    std::uint64_t& value = name == "--seed" ? options.seed : options.operations;
    const char* const end = text.data() + text.size();
    const auto [stopped, failed] = std::from_chars(text.data(), end, value);
    if (failed != std::errc() || stopped != end) return false;
  }
  return true;
}

// One history of each source in turns, small or large as it is.
bool run_all(const Options& options, Totals& totals) {
  const std::vector<PointSource> small = point_sources();
  const std::vector<PointSource> large = large_sources();
  std::uint64_t seed = options.seed;
  const auto run = [&](const PointSource& source, const Size& size) {
    History history(source, seed);
    const bool fine = history.run(size, totals);
    if (!fine) {
      std::printf("%s, seed %llu: FAILED\n", source.name.c_str(),
                  static_cast<unsigned long long>(seed));
    }
    return fine;
  };
  for (; totals.operations < options.operations; ++seed) {
    for (const PointSource& source : small) {
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
  const bool fine = run_all(options, totals);
  std::printf("%llu operations, %llu comparisons with the batch, up to %zu vertices: %s\n",
              static_cast<unsigned long long>(totals.operations),
              static_cast<unsigned long long>(totals.comparisons), totals.most_vertices,
              fine ? "all equal" : "FAILED");
  return fine ? 0 : 1;
}
