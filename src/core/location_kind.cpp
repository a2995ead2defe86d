#include <tetloft/location_kind.hpp>

namespace tetloft {

const char* name_of(LocationKind kind) {
  switch (kind) {
    case LocationKind::vertex: return "vertex";
    case LocationKind::edge: return "edge";
    case LocationKind::facet: return "facet";
    case LocationKind::tet: return "tet";
    case LocationKind::outside: return "outside";
  }
  return "unknown";
}

}  // namespace tetloft
