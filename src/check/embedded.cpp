// Guarantee 3: positive tets whose boundary surface is embedded and winds at most once
// around any point.
#include "check/embedded.hpp"

#include <algorithm>
#include <string>

#include <tetloft/predicates.hpp>

#include "check/winding.hpp"
#include "contact/contact.hpp"

namespace tetloft::internal::checking {

namespace {

// Of a model in ruins not every contact is of interest.
constexpr std::size_t kMostContacts = 1000;

}  // namespace

Findings check_embedded(const ModelView& view, const SurfaceComponents& surface,
                        const CheckOptions& options) {
  Findings findings(3, "embedded", options.places);
  for (const VertexId v : view.not_finite) {
    findings.fail(1, "a coordinate is not finite",
                  [&] { return "vertex " + std::to_string(v.value()); });
  }
  for (std::size_t t = 0; t < view.tets.size(); ++t) {
    const TetVertices& tet = view.tets[t];
    const auto point = [&](std::size_t i) -> const Point3& { return view.points[tet[i].index()]; };
    if (orient3d(point(0), point(1), point(2), point(3)) == Sign::positive) continue;
    findings.fail(2, "a tet is not positive", [&] { return tet_text(view.id[t]); });
  }
  const std::size_t limit = std::max(kMostContacts, options.places);
  for (const Contact& contact : find_contacts(view.points, view.boundary, limit)) {
    findings.fail(3, "two boundary triangles touch beyond what they share", [&] {
      return face_text(view.boundary[contact.first]) + " and " +
             face_text(view.boundary[contact.second]);
    });
  }
  // Winding numbers need an embedded surface.
  if (!findings.pass()) return findings;
  const std::vector<long> winding =
      outer_winding(view.points, view.boundary, surface.component, surface.topology.size());
  std::vector<std::size_t> first(winding.size(), 0);
  for (std::size_t i = view.boundary.size(); i-- > 0;) first[surface.component[i]] = i;
  for (std::size_t c = 0; c < winding.size(); ++c) {
    if (winding[c] == 0) continue;
    findings.fail(4, "tets lie on the outer side of a boundary surface",
                  [&] { return "surface at " + face_text(view.boundary[first[c]]); });
  }
  return findings;
}

}  // namespace tetloft::internal::checking
