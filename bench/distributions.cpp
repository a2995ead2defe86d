#include "distributions.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include <tetloft/formats.hpp>
#include <tetloft/io.hpp>

#include "inputs.hpp"
#include "reconstruction.hpp"
#include "value_of.hpp"

namespace tetloft::bench {

namespace {

using Points = std::vector<Point3>;

struct Distribution {
  const char* name;
  const char* what;
  Points (*make)(std::size_t n);
};

// About as many points as have as many tets on a moment curve as n uniform points, which have 7 n.
std::size_t of_quadratic(std::size_t n) {
  return static_cast<std::size_t>(std::sqrt(14 * static_cast<double>(n)));
}

constexpr Distribution kDistributions[] = {
    {"uniform", "uniform in a cube", uniform3},
    {"sphere", "on a sphere up to rounding", sphere},
    {"clusters", "tight clusters of 200",
     [](std::size_t n) { return clusters(n, std::max<std::size_t>(1, n / 200)); }},
    {"line", "around a line", around_line},
    {"moment curve", "n^2 / 2 tets; as many points as give 7 tets for each of the size",
     [](std::size_t n) { return moment_curve(of_quadratic(n)); }},
    {"lattice", "integer grid",
     [](std::size_t n) {
       return grid3(static_cast<std::size_t>(std::cbrt(static_cast<double>(n)) + 0.5));
     }},
    {"two planes", "wiggly circles in two planes", [](std::size_t n) { return two_planes(n / 2); }},
};

Points vertices_of(const SectionStack& stack) {
  Points points;
  for (const Section& section : stack.sections) append_vertices(section, points);
  return points;
}

// The vertices of a stack or of a surface, else points as they stand.
Points read_any_points(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  if (ending == ".cnt") return vertices_of(value_of(read_cnt(path)).stack);
  for (const char* surface : {".stl", ".obj", ".ply", ".off"}) {
    if (ending == surface) return value_of(read_triangles(path)).mesh.points;
  }
  return value_of(read_points(path)).points;
}

using Triangulate = std::function<Run(std::span<const Point3>, unsigned)>;

Contestant contestant(const std::string& engine, const Triangulate& run, unsigned threads,
                      const Sets<Point3>& sets) {
  Contestant result;
  result.engine = engine;
  result.threads = threads;
  result.name = threads == 1 ? engine : engine + ", " + std::to_string(threads) + " threads";
  result.run = over_all<Point3>(
      sets, [run, threads](std::span<const Point3> points) { return run(points, threads); });
  return result;
}

Case distribution_case(const std::string& name, const std::string& size, const std::string& what,
                       const std::function<Points()>& make, const std::vector<unsigned>& threads) {
  Case result;
  result.name = "distribution " + name + (size.empty() ? "" : " " + size);
  result.what = what;
  result.distribution = name;
  result.make = [=](const std::vector<Peer>& peers) {
    const Sets<Point3> sets = std::make_shared<const std::vector<Points>>(1, make());
    Case::Field field;
    field.points = sets->front().size();
    for (const unsigned t : threads) {
      field.own.push_back(contestant("tetloft", whole_call3, t, sets));
    }
    for (const Peer& peer : peers) {
      if (!peer.run3) continue;
      for (const unsigned t : peer.parallel ? threads : std::vector<unsigned>{1}) {
        Contestant& added = field.peers.emplace_back(contestant(peer.name, peer.run3, t, sets));
        added.left_out = left_out(peer, field.points);
      }
    }
    return field;
  };
  return result;
}

}  // namespace

std::vector<Case> distribution_cases(const DistributionOptions& options) {
  std::vector<Case> cases;
  for (const Distribution& one : kDistributions) {
    for (const std::size_t n : options.sizes) {
      cases.push_back(distribution_case(
          one.name, size_name(n), one.what, [&one, n] { return one.make(n); }, options.threads));
    }
  }
  const auto of_file = [&](const std::string& name, const std::string& path) {
    cases.push_back(distribution_case(
        name, "", "a scanned surface, or what else is in the file",
        [path] { return read_any_points(path); }, options.threads));
  };
  of_file("bunny", std::string(TETLOFT_DATA_DIR) + "/bunny.cnt");
  for (const std::string& path : options.files) {
    of_file(std::filesystem::path(path).stem().string(), path);
  }
  return cases;
}

}  // namespace tetloft::bench
