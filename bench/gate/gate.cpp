// tetloft_gate: fixed runs whose instructions bench/gate/run counts.
//
//   tetloft_gate --list     the names of the runs
//   tetloft_gate --build    compiler, C library and flags: what counts depend on
//   tetloft_gate NAME       makes the input, and runs
#include <cstdio>
#include <exception>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <gnu/libc-version.h>

#include "corpus/solids.hpp"
#include "engines.hpp"
#include "inputs.hpp"
#include "reconstruction.hpp"
#include "words.hpp"

namespace tetloft::bench {

// The counter is on in here, by this name: so it is no inline function, and no local one.
[[gnu::noinline]] void counted_work(const std::function<void()>& work) { work(); }

}  // namespace tetloft::bench

namespace {

using namespace tetloft::bench;

constexpr const char* kUsage = "usage: tetloft_gate NAME | --list | --build\n";

void count_reconstruction(const tetloft::SectionStack& stack, Between between) {
  const StackFile file(stack);
  counted_work([&] { reconstruct_file(file.path(), between, 1); });
}

void count_triangulations(const std::vector<std::vector<tetloft::Point3>>& sets) {
  counted_work([&] {
    for (const auto& points : sets) whole_call3(points, 1);
  });
}

tetloft::SectionStack sliced(Contouring contouring) {
  return slice(sample_solid(SolidKind::tubes, 1, 128), 4, contouring).stack;
}

struct GateRun {
  const char* name;
  void (*run)();
};

// Each a few billion instructions at most: a second or two for valgrind for every half billion.
constexpr GateRun kRuns[] = {
    {"branching", [] { count_reconstruction(branching(16'000, 12), Between::nothing); }},
    {"smooth", [] { count_reconstruction(sliced(Contouring::smooth), Between::by_need); }},
    {"lattice", [] { count_reconstruction(sliced(Contouring::lattice), Between::by_need); }},
    {"pixels", [] { count_triangulations({two_pixel_planes(50'000)}); }},
    {"slabs",
     [] {
       std::vector<std::vector<tetloft::Point3>> sets;
       for (std::size_t k = 0; k < 200; ++k) sets.push_back(thin_slab(200, k));
       count_triangulations(sets);
     }},
    {"points", [] { count_triangulations({uniform3(100'000)}); }},
    // For the test of the gate, and in no file of counts.
    {"smoke", [] { count_triangulations({uniform3(1000)}); }},
};

void print_build() {
#ifdef __clang__
  const char* compiler = "clang ";
#else
  const char* compiler = "g++ ";
#endif
  std::printf("%s%s, glibc %s, %s\n", compiler, __VERSION__, gnu_get_libc_version(),
              TETLOFT_GATE_FLAGS);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string word = argc == 2 ? argv[1] : "";
  std::vector<std::string> names;
  for (const GateRun& one : kRuns) names.emplace_back(one.name);
  if (word == "--list") {
    for (const std::string& name : names) std::printf("%s\n", name.c_str());
    return 0;
  }
  if (word == "--build") {
    print_build();
    return 0;
  }
  for (const GateRun& one : kRuns) {
    if (word != one.name) continue;
    try {
      one.run();
      return 0;
    } catch (const std::exception& e) {
      std::fprintf(stderr, "%s: %s\n", one.name, e.what());
      return 1;
    }
  }
  return usage_failure(no_such("NAME", word, names), kUsage);
}
