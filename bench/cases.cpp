#include "cases.hpp"

#include <filesystem>
#include <utility>

#include <tetloft/io.hpp>

#include "inputs.hpp"
#include "reconstruction.hpp"
#include "value_of.hpp"

namespace tetloft::bench {

namespace {

using Field = Case::Field;

template <class Point>
std::size_t count(const Sets<Point>& sets) {
  std::size_t n = 0;
  for (const auto& set : *sets) n += set.size();
  return n;
}

void add_peers(Field& field, const Sets<Point3>& sets, const std::vector<Peer>& peers) {
  for (const Peer& peer : peers) {
    if (!peer.run3) continue;
    const auto run = [run3 = peer.run3](std::span<const Point3> points) { return run3(points, 1); };
    field.peers.push_back(
        {peer.name, over_all<Point3>(sets, run), false, left_out(peer, field.points)});
  }
}

Case in_space(std::string name, std::string what,
              std::function<std::vector<std::vector<Point3>>()> make, bool two_planes) {
  return {std::move(name), std::move(what), [=](const std::vector<Peer>& peers) {
            const auto sets = std::make_shared<const std::vector<std::vector<Point3>>>(make());
            Field field;
            field.points = count<Point3>(sets);
            if (two_planes) field.own.push_back({"slab", over_all<Point3>(sets, slab3), true});
            field.own.push_back({"incremental", over_all<Point3>(sets, incremental3), true});
            const auto whole = [](std::span<const Point3> points) {
              return whole_call3(points, 1);
            };
            field.own.push_back({"whole call", over_all<Point3>(sets, whole), true});
            add_peers(field, sets, peers);
            return field;
          }};
}

Case in_plane(std::string name, std::string what, std::function<std::vector<Point2>()> make) {
  return {std::move(name), std::move(what), [=](const std::vector<Peer>& peers) {
            const auto sets = std::make_shared<const std::vector<std::vector<Point2>>>(1, make());
            Field field;
            field.points = count<Point2>(sets);
            field.own.push_back({"incremental", over_all<Point2>(sets, incremental2), true});
            field.own.push_back({"whole call", over_all<Point2>(sets, whole_call2), true});
            for (const Peer& peer : peers) {
              if (!peer.run2) continue;
              field.peers.push_back({peer.name, over_all<Point2>(sets, peer.run2), false,
                                     left_out(peer, field.points)});
            }
            return field;
          }};
}

using Reconstruct = std::function<Run(unsigned threads)>;

// Ours on one thread, whose calls of predicates are counted, and on two.
Field reconstructions(const SectionStack& stack, const Reconstruct& run) {
  Field field;
  field.points = stack.vertex_count();
  field.own.push_back({"1 thread", [run] { return run(1); }, true});
  field.own.push_back({"2 threads", [run] { return run(2); }});
  return field;
}

// The same, and peers, who only triangulate the slabs.
Field against_slabs(const SectionStack& stack, const Reconstruct& run,
                    const std::vector<Peer>& peers) {
  Field field = reconstructions(stack, run);
  add_peers(field, std::make_shared<const std::vector<std::vector<Point3>>>(slabs_of(stack)),
            peers);
  return field;
}

Case whole(const std::string& path) {
  return {"reconstruct " + std::filesystem::path(path).stem().string(),
          "reading, reconstruction and writing; peers triangulate the slabs only",
          [=](const std::vector<Peer>& peers) {
            const auto run = [path](unsigned threads) {
              return reconstruct_file(path, Between::nothing, threads);
            };
            return against_slabs(value_of(read_cnt(path)).stack, run, peers);
          }};
}

// A generated stack, written before it is timed.
Case generated(std::string name, const std::string& what,
               const std::function<SectionStack()>& make) {
  return {std::move(name), what + "; peers triangulate the slabs only",
          [=](const std::vector<Peer>& peers) {
            const SectionStack stack = make();
            const auto file = std::make_shared<const StackFile>(stack);
            const auto run = [file](unsigned threads) {
              return reconstruct_file(file->path(), Between::nothing, threads);
            };
            return against_slabs(stack, run, peers);
          }};
}

Case scaling(std::size_t vertices) {
  return {"scaling " + std::to_string(vertices / 1000) + "k",
          "reconstruction of a tube of sections of 200 vertices, in memory",
          [=](const std::vector<Peer>&) {
            const auto stack = std::make_shared<const SectionStack>(tube(vertices));
            return reconstructions(*stack, [stack](unsigned threads) {
              return reconstruct_stack(*stack, Between::nothing, threads);
            });
          }};
}

}  // namespace

std::string size_name(std::size_t n) {
  if (n % 1'000'000 == 0) return std::to_string(n / 1'000'000) + 'M';
  return n % 1000 == 0 ? std::to_string(n / 1000) + 'k' : std::to_string(n);
}

std::string left_out(const Peer& peer, std::size_t points) {
  if (points <= peer.most_points) return {};
  return "left out above " + std::to_string(peer.most_points) + " points";
}

std::vector<Case> all_cases(const std::vector<std::string>& stacks) {
  using Sets3 = std::vector<std::vector<Point3>>;
  std::vector<Case> cases{
      in_space(
          "smoke", "a thousand uniform points", [] { return Sets3{uniform3(1000)}; }, false),
      in_space(
          "uniform 100k", "uniform in a cube", [] { return Sets3{uniform3(100'000)}; }, false),
      in_space(
          "uniform 1M", "uniform in a cube", [] { return Sets3{uniform3(1'000'000)}; }, false),
      in_space(
          "grid 60^3", "integer grid", [] { return Sets3{grid3(60)}; }, false),
      in_space(
          "sphere 200k", "on a sphere up to rounding", [] { return Sets3{sphere(200'000)}; },
          false),
      in_space(
          "bumpy sphere 200k", "on a sphere with bumps",
          [] { return Sets3{bumpy_sphere(200'000)}; }, false),
      in_space(
          "clusters 200k", "1000 tight clusters", [] { return Sets3{clusters(200'000, 1000)}; },
          false),
      in_space(
          "lines 5k", "on 20 segments", [] { return Sets3{lines(5000, 20)}; }, false),
      in_space(
          "curves 5k", "on 10 parabolas", [] { return Sets3{curves(5000, 10)}; }, false),
      in_space(
          "two planes 2x50k", "wiggly circles in two planes",
          [] { return Sets3{two_planes(50'000)}; }, true),
      in_space(
          "two planes, pixels", "the same on a half-integer lattice",
          [] { return Sets3{two_pixel_planes(50'000)}; }, true),
      in_space(
          "500 slabs of 2x200", "wiggly circles, times added",
          [] {
            Sets3 sets;
            for (std::size_t k = 0; k < 500; ++k) sets.push_back(thin_slab(200, k));
            return sets;
          },
          true),
      in_plane("plane 50k", "uniform in a square", [] { return uniform2(50'000); }),
      in_plane("plane 1M", "uniform in a square", [] { return uniform2(1'000'000); }),
  };
  const std::string branches = "wiggly circles with holes that part in four";
  cases.push_back(generated("smoke stack", branches, [] { return branching(1000, 6); }));
  cases.push_back(
      generated("reconstruct 128k in 48", branches, [] { return branching(128'000, 48); }));
  cases.push_back(
      generated("coasts 3x20k", "outlines of islands", [] { return coasts(20'000, 3); }));
  for (const char* sample : {"bifurcation", "bunny", "terrain", "tooth", "torus"}) {
    cases.push_back(whole(std::string(TETLOFT_DATA_DIR) + '/' + sample + ".cnt"));
  }
  for (const std::string& path : stacks) cases.push_back(whole(path));
  for (const std::size_t vertices : {10'000U, 30'000U, 100'000U, 300'000U, 1'000'000U}) {
    cases.push_back(scaling(vertices));
  }
  return cases;
}

}  // namespace tetloft::bench
