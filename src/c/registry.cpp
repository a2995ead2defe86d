#include "c/registry.hpp"

#include <limits>
#include <mutex>
#include <new>
#include <utility>

namespace tetloft::internal::c {

namespace {

// Names are serial numbers times an odd number, modulo the size of a word: all different, and
// neither small integers nor addresses, which is what a wrong handle mostly is.
constexpr HandleName kSpread = static_cast<HandleName>(0x9E3779B97F4A7C15ULL);
static_assert(kSpread % 2 == 1);

}  // namespace

const char* name_of(HandleType type) {
  switch (type) {
    case HandleType::warnings: return "a list of warnings";
    case HandleType::stop: return "a stop";
    case HandleType::bytes: return "bytes";
    case HandleType::stack: return "a stack";
    case HandleType::labels: return "labels";
    case HandleType::links: return "links";
    case HandleType::model: return "a model";
    case HandleType::surface: return "a surface";
    case HandleType::verdict: return "a verdict";
    case HandleType::mesh: return "a mesh";
    case HandleType::triangulation: return "a triangulation";
    case HandleType::points: return "points";
    case HandleType::delaunay: return "a Delaunay triangulation";
    case HandleType::delaunay_plane: return "a Delaunay triangulation of the plane";
    case HandleType::cells: return "Voronoi cells";
    case HandleType::plane_cells: return "Voronoi cells in the plane";
    case HandleType::natural_neighbours: return "natural neighbours";
    case HandleType::periodic_tets: return "tets of a periodic set";
  }
  return "nothing";
}

Registry& Registry::of_process() {
  static Registry* const registry = new Registry;
  return *registry;
}

HandleName Registry::add(Named named) {
  const std::unique_lock lock(mutex_);
  if (last_serial_ == std::numeric_limits<HandleName>::max()) throw std::bad_alloc();
  const HandleName name = (last_serial_ + 1) * kSpread;
  named_.emplace(name, std::move(named));
  ++last_serial_;
  return name;
}

Named Registry::find(HandleName name) const {
  const std::shared_lock lock(mutex_);
  const auto found = named_.find(name);
  return found == named_.end() ? Named{} : found->second;
}

Named Registry::remove(HandleName name) noexcept {
  const std::unique_lock lock(mutex_);
  const auto found = named_.find(name);
  if (found == named_.end()) return {};
  Named named = std::move(found->second);
  named_.erase(found);
  return named;
}

}  // namespace tetloft::internal::c
