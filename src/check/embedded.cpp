// Guarantee 3: positive tets whose boundary surface is embedded and winds at most once
// around any point.
#include "check/embedded.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include <tetloft/predicates.hpp>

#include "check/winding.hpp"
#include "contact/contact.hpp"

namespace tetloft::internal::checking {

namespace {

// Of a model in ruins not every contact is of interest.
constexpr std::size_t kMostContacts = 1000;

constexpr const char* kEmbedded = "embedded";

void fail_contact(const ModelView& view, const Contact& contact, Findings& findings) {
  findings.fail(3, "two boundary triangles touch beyond what they share", [&] {
    return face_text(view, view.boundary[contact.first]) + " and " +
           face_text(view, view.boundary[contact.second]);
  });
}

std::size_t most_contacts(const CheckOptions& options) {
  return std::max(kMostContacts, options.places);
}

}  // namespace

Findings check_tets_and_contacts(const ModelView& view, const CheckOptions& options) {
  Findings findings(3, kEmbedded, options.places);
  for (const VertexId v : view.not_finite) {
    findings.fail(1, "a coordinate is not finite",
                  [&] { return "vertex " + std::to_string(view.number(v).value()); });
  }
  for (std::size_t t = 0; t < view.tets.size(); ++t) {
    const TetVertices& tet = view.tets[t];
    const auto point = [&](std::size_t i) -> const Point3& { return view.points[tet[i].index()]; };
    if (orient3d(point(0), point(1), point(2), point(3)) == Sign::positive) continue;
    findings.fail(2, "a tet is not positive", [&] { return tet_text(view.id[t]); });
  }
  for (const Contact& contact : find_contacts(view.points, view.boundary, most_contacts(options))) {
    fail_contact(view, contact, findings);
  }
  return findings;
}

Findings check_contacts_at_seam(const ModelView& view, std::size_t first_upper,
                                const CheckOptions& options) {
  // 0 and 1: of the lower and the upper side, 2: in the seam.
  std::vector<std::uint8_t> side;
  for (std::size_t i = 0; i < view.boundary.size(); ++i) {
    const bool upper = view.boundary_face[i].index() / 4 >= first_upper;
    side.push_back(view.in_seam(view.boundary[i]) ? 2 : (upper ? 1 : 0));
  }
  Findings findings(3, kEmbedded, options.places);
  for (const Contact& contact :
       find_contacts(view.points, view.boundary, most_contacts(options), side)) {
    if (side[contact.first] == 1 && side[contact.second] == 1) continue;
    fail_contact(view, contact, findings);
  }
  return findings;
}

void fail_winding(Findings& findings, const std::string& place) {
  findings.fail(4, "tets lie on the outer side of a boundary surface",
                [&] { return "surface at " + place; });
}

Findings check_embedded(const ModelView& view, const SurfaceComponents& surface,
                        const CheckOptions& options) {
  Findings findings = check_tets_and_contacts(view, options);
  // Winding numbers need an embedded surface.
  if (!findings.pass()) return findings;
  const std::vector<long> winding =
      outer_winding(view.points, view.boundary, surface.component, surface.topology.size());
  std::vector<std::size_t> first(winding.size(), 0);
  for (std::size_t i = view.boundary.size(); i-- > 0;) first[surface.component[i]] = i;
  for (std::size_t c = 0; c < winding.size(); ++c) {
    if (winding[c] != 0) fail_winding(findings, face_text(view, view.boundary[first[c]]));
  }
  return findings;
}

}  // namespace tetloft::internal::checking
