// geogram: its sequential triangulation, and its parallel one for several threads.
#include "engines.hpp"

#include <vector>

#include <geogram/basic/command_line.h>
#include <geogram/basic/command_line_args.h>
#include <geogram/basic/common.h>
#include <geogram/basic/logger.h>
#include <geogram/basic/process.h>
#include <geogram/delaunay/delaunay.h>

#include "measure.hpp"

namespace tetloft::bench {

namespace {

Run run3(std::span<const Point3> points, unsigned threads) {
  std::vector<double> coordinates;
  coordinates.reserve(3 * points.size());
  for (const Point3& p : points) coordinates.insert(coordinates.end(), {p.x, p.y, p.z});
  GEO::initialize();
  GEO::Logger::instance()->set_quiet(true);
  GEO::CmdLine::import_arg_group("standard");
  GEO::CmdLine::import_arg_group("algo");
  GEO::Process::set_max_threads(threads);
  const Clock clock;
  const GEO::Delaunay_var d = GEO::Delaunay::create(3, threads > 1 ? "PDEL" : "BDEL");
  d->set_vertices(static_cast<GEO::index_t>(points.size()), coordinates.data());
  const double seconds = clock.seconds();
  return {seconds, d->nb_cells()};
}

}  // namespace

Peer geogram() { return {"geogram", "", run3, {}, true}; }

}  // namespace tetloft::bench
