#include "io/drawing/dxf_arc.hpp"

#include <cmath>
#include <utility>

namespace tetloft::internal::io {

void append_arc(const Point3& p, const Point3& q, double bulge, std::vector<Point3>& points) {
  constexpr double kFlat = 0.05;  // the arc's height over half of its chord
  constexpr int kMostHalvings = 6;
  std::vector<Point3> arc{p, q};
  for (int i = 0; i < kMostHalvings && std::abs(bulge) > kFlat; ++i) {
    std::vector<Point3> finer{arc.front()};
    for (std::size_t k = 0; k + 1 < arc.size(); ++k) {
      const Point3& a = arc[k];
      const Point3& b = arc[k + 1];
      finer.push_back({(a.x + b.x) / 2 + bulge / 2 * (b.y - a.y),
                       (a.y + b.y) / 2 - bulge / 2 * (b.x - a.x), a.z});
      finer.push_back(b);
    }
    arc = std::move(finer);
    // tan(t / 2) of tan(t).
    bulge = bulge / (1 + std::sqrt(1 + bulge * bulge));
  }
  points.insert(points.end(), arc.begin() + 1, arc.end() - 1);
}

}  // namespace tetloft::internal::io
