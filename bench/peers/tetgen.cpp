// TetGen: the Delaunay triangulation of points, no quality, quiet.
#include "engines.hpp"

#include <stdexcept>
#include <string>

#define TETLIBRARY
#include <tetgen.h>

#include "measure.hpp"

namespace tetloft::bench {

namespace {

Run run3(std::span<const Point3> points, unsigned) {
  tetgenio in;
  tetgenio out;
  in.numberofpoints = static_cast<int>(points.size());
  in.pointlist = new REAL[3 * points.size()];  // the library's to delete
  for (std::size_t i = 0; i < points.size(); ++i) {
    in.pointlist[3 * i] = points[i].x;
    in.pointlist[3 * i + 1] = points[i].y;
    in.pointlist[3 * i + 2] = points[i].z;
  }
  char switches[] = "QN";
  const Clock clock;
  try {
    tetrahedralize(switches, &in, &out);
  } catch (const int code) {  // all that TetGen throws
    throw std::runtime_error("TetGen gave up with code " + std::to_string(code));
  }
  const double seconds = clock.seconds();
  return {seconds, static_cast<std::size_t>(out.numberoftetrahedra)};
}

}  // namespace

Peer tetgen() { return {"TetGen", "1.5", run3, {}}; }

}  // namespace tetloft::bench
