// The five guarantees, checked exactly on any model: shares predicates with the
// reconstruction and none of its construction.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <tetloft/correspondence.hpp>
#include <tetloft/execution.hpp>
#include <tetloft/export.hpp>
#include <tetloft/model.hpp>
#include <tetloft/result.hpp>
#include <tetloft/section_stack.hpp>

namespace tetloft {

/// A condition that fails, with counts and the first places.
struct CheckFailure {
  /// The condition, with its number in src/check/README.md: "1.4 a vertex link is …".
  std::string what;
  std::size_t count = 0;
  std::vector<std::string> places;  ///< the first few
};

/// One guarantee: 1 manifold, 2 re-sampling, 3 embedded, 4 components, 5 cavities and tunnels.
struct GuaranteeVerdict {
  int number = 0;
  std::string name;
  bool pass = true;
  /// Why it was not asked; empty if it was. 5 is not, and does not pass, while 1, 2 or 4 fail. By
  /// VoidRule::free it asks nothing, and passes.
  std::string not_asked;
  std::vector<CheckFailure> failures;
};

struct CheckOptions {
  CorrespondenceOptions correspondence = {};
  /// An inserted vertex may lie this many ulps (of the largest coordinate magnitude of its
  /// contour edge) off the edge.
  double split_ulps = 4;
  std::size_t places = 5;  ///< how many places to report for each failure
  /// By correspondence `moved`: estimate motions anew, too, and ask that the model's are the same,
  /// bit for bit. Otherwise they are taken from the model, where the rule has any.
  bool recompute_motions = false;
  /// Guarantee 5 without exceptions: deviations that the model lists, links of voids that it says
  /// were forced or unrealisable, fail, too.
  bool strict = false;
  Execution execution = {};  ///< threads share the guarantees
};

struct TETLOFT_API CheckReport {
  std::vector<GuaranteeVerdict> guarantees;  ///< the five, in order
  [[nodiscard]] bool pass() const;
  // Figures beside the guarantees.
  std::size_t components = 0;
  /// Genus of each boundary surface component, by first triangle.
  std::vector<long> genus;
  double volume = 0;
  /// The largest sideways distance of a vertex between two sections from both sections'
  /// regions, in gaps of its slab; 0 without such vertices. Beyond an end from the one
  /// region, in gaps of the next slab; of a single section in twice the height over it.
  double overshoot = 0;
  double smallest_dihedral_degrees = 0;
  double largest_split_ulps = 0;  ///< of inserted vertices off their contour edge
  /// Vertices in section planes off the contours, as meshers insert them; reconstruct makes none.
  std::size_t inner_vertices = 0;
  /// Links of the correspondence that the model says no tets could realise (rule 8): they are left
  /// out where guarantee 4 is decided.
  std::size_t dropped_links = 0;
  /// Of the model; none while guarantee 1 or 2 fails.
  std::optional<std::size_t> cavities = std::nullopt;
  /// By the links of regions and voids, the genus summed over all boundary surfaces, between what:
  /// a range where regions touch; none where they cannot be recomputed, and by VoidRule::free.
  std::optional<std::size_t> expected_cavities = std::nullopt;
  std::optional<long> least_genus = std::nullopt;
  std::optional<long> most_genus = std::nullopt;
  /// What the model lists of them (guarantee 5), right or wrong.
  std::size_t deviations = 0;
  /// Links of voids that the model says were forced, or unrealisable (rule V6), as far as that may
  /// be.
  std::size_t forced_voids = 0;
  std::size_t unrealisable_voids = 0;
};

/// Checks points and tets of `model` (not its labels and provenance) against the input.
///
/// Guarantee 4: the correspondence is computed anew, from the input and the options. Two things are
/// taken from the model: its motions, by `moved` (but see recompute_motions), and which links were
/// dropped. It fails where the rule has no such motion or candidate. A model that has neither links
/// nor motions, as when a mesher refined it and left them out, is checked with motions estimated
/// anew, and fails if links had been dropped.
///
/// Guarantee 5, with the rule of voids.hpp: links of voids, and the Euler characteristic of what
/// each slab holds, are computed anew, from the input, the options and the links of guarantee 4.
/// Taken from the model: which links of voids were forced or unrealisable, and where the topology
/// deviates, which is a failure where it does not. So the model of a mesher that left them out
/// fails where there were any.
///
/// Guarantee 2: cutting the solid with a section plane gives back the section's region as a set,
/// on each side on which the stack goes on; the input's vertices are vertices of the model, bit for
/// bit. What else of the model may lie in the plane: vertices on contour edges, off them by no
/// more than split_ulps, as if the input had had them; and vertices, edges and faces inside the
/// region. So right models stay right when they are refined. Fails too where it cannot be decided:
/// a tet that crosses a section plane (reconstruct makes none) leaves no faces there to look at.
///
/// Takes any model: what is malformed (ids out of range, coordinates that are not finite, …)
/// fails a guarantee. Refused (invalid_input) for an invalid stack, invalid labels or decisions or
/// 2^30 tets, (usage) for options out of range, (cancelled) if it was stopped. Both ends may be
/// flat or extend beyond the stack.
[[nodiscard]] TETLOFT_API Result<CheckReport> check(const Model& model, const SectionStack& stack,
                                                    const CheckOptions& options = {});

}  // namespace tetloft
