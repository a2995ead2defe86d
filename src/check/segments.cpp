#include "check/segments.hpp"

#include <cstdint>
#include <iterator>
#include <span>
#include <utility>

#include "check/embedded.hpp"
#include "check/manifold.hpp"
#include "check/resampling.hpp"
#include "core/parallel.hpp"

namespace tetloft::internal::checking {

namespace {

constexpr std::uint8_t kLowerSeam = 1;
constexpr std::uint8_t kUpperSeam = 2;

// Of sections first … end − 1 those that are no seams.
SectionRange own_sections(const SectionRange& sections, std::size_t all) {
  return {sections.first + (sections.first > 0 ? 1 : 0),
          sections.end - (sections.end < all ? 1 : 0)};
}

}  // namespace

SegmentCheck::SegmentCheck(const SectionStack& stack, const CheckOptions& options,
                           WatchedWork& work)
    : stack_(stack),
      options_(options),
      work_(work),
      conclusions_(stack, options),
      region_at_(conclusions_.region_at()),
      void_at_(conclusions_.void_at()),
      refined_(stack),
      manifold_(1, "manifold", options.places),
      resampling_(2, "re-sampling", options.places),
      embedded_(3, "embedded", options.places),
      components_(conclusions_.numbers()) {}

ModelView SegmentCheck::show(const Segment& segment) const {
  const bool has_lower = segment.sections.first > 0;
  const bool has_upper = segment.sections.end < stack_.sections.size();
  const Model& model = segment.model;
  PartOfWhole part;
  part.scope = Scope::segment;
  part.vertex = segment.number;
  for (const VertexId v : model.points.ids()) {
    const SectionId s = model.section[v];
    const bool lower = has_lower && s.valid() && s.index() == segment.sections.first;
    const bool upper = has_upper && s.valid() && s.index() + 1 == segment.sections.end;
    part.seam.push_back(lower ? kLowerSeam : (upper ? kUpperSeam : std::uint8_t{0}));
  }
  for (std::size_t t = 0; t < model.tets.size(); ++t) part.tet.emplace_back(segment.first_tet + t);
  return look_at(model, stack_, std::move(part));
}

void SegmentCheck::add(Segment segment) {
  work_.go_on();
  const ModelView view = show(segment);
  const SurfaceComponents surface = surface_components(view.boundary);
  const SegmentNumbering numbering = check_view(segment, view, surface);
  if (segment.sections.first > 0) {
    check_seam(segment.sections.first, side_of(view, kLowerSeam, numbering), segment.name);
  }
  wind(view, view.boundary, numbering.boundary_patch);
  below_.reset();
  if (segment.sections.end < stack_.sections.size()) {
    below_ = side_of(view, kUpperSeam, numbering);
    name_below_ = segment.name;
  }
  add_tables(segment.model);
}

SegmentNumbering SegmentCheck::check_view(const Segment& segment, const ModelView& view,
                                          const SurfaceComponents& surface) {
  const SectionRange own = own_sections(segment.sections, stack_.sections.size());
  std::optional<Findings> manifold;
  std::optional<Findings> embedded;
  std::optional<Resampling> resampling;
  SlabParts parts;
  ViewFigures figures;
  constexpr std::size_t kParts = 5;
  parallel_for(kParts, options_.execution.threads, [&](std::size_t part) {
    work_.go_on();
    if (part == 0) embedded = check_tets_and_contacts(view, options_);
    if (part == 1) {
      resampling = check_resampling(view, stack_, conclusions_.numbers(), own, options_, refined_);
    }
    if (part == 2) manifold = check_manifold(view, options_);
    if (part == 3) figures = measure(segment.model, view, stack_, segment.sections);
    if (part == 4) parts = slab_parts(view);
  });
  const std::string in_front = segment.name + ": ";
  manifold_.add(*manifold, in_front);
  embedded_.add(*embedded, in_front);
  resampling_.add(resampling->findings, in_front);
  const OnContours& on = resampling->on_contours;
  figures_.add(figures);
  figures_.add(on);

  SegmentNumbering numbering;
  const std::uint32_t component = components_.add(view);
  for (const std::uint32_t c : view.component) numbering.component.push_back(component + c);
  components_.meet(view, on, numbering.component);
  const std::uint32_t patch = patches_.add(view, surface);
  for (const std::uint32_t c : surface.component) numbering.boundary_patch.push_back(patch + c);
  patches_.meet(view, on, numbering.boundary_patch, void_at_);
  const auto part = static_cast<std::uint32_t>(parts_.size());
  for (const std::uint32_t p : parts.part_of) {
    numbering.part.push_back(p == SlabParts::kNone ? p : part + p);
  }
  std::move(parts.parts.begin(), parts.parts.end(), std::back_inserter(parts_));
  add_regions(view, on, numbering.part, region_at_, parts_);
  return numbering;
}

void SegmentCheck::check_seam(std::size_t section, const SeamSide& upper, const std::string& name) {
  Seam seam;
  join_sides(*below_, upper, stack_, seam);
  const ModelView& view = seam.view;
  const Resampling resampling = check_resampling(view, stack_, conclusions_.numbers(),
                                                 {section, section + 1}, options_, refined_);
  const OnContours& on = resampling.on_contours;
  const std::string in_front = name_below_ + " and " + name + ": ";
  manifold_.add(check_manifold(view, options_), in_front);
  embedded_.add(check_contacts_at_seam(view, seam.first_upper, options_), in_front);
  resampling_.add(resampling.findings, in_front);
  figures_.add(on);

  std::vector<std::uint32_t> first(view.component_count, SeamSide::kNone);
  for (std::size_t t = 0; t < view.tets.size(); ++t) {
    std::uint32_t& of_component = first[view.component[t]];
    if (of_component == SeamSide::kNone) of_component = seam.component[t];
    components_.unite(of_component, seam.component[t]);
  }
  components_.meet(view, on, seam.component);
  add_regions(view, on, seam.part, region_at_, parts_);

  std::vector<TriangleVertices> in_seam;
  std::vector<std::uint32_t> patch_in_seam;
  for (std::size_t k = 0; k < view.boundary.size(); ++k) {
    if (!view.in_seam(view.boundary[k])) continue;
    seam.boundary_patch[k] = patches_.add(view, k);
    in_seam.push_back(view.boundary[k]);
    patch_in_seam.push_back(seam.boundary_patch[k]);
  }
  patches_.grow_together(view, seam.boundary_patch);
  patches_.meet(view, on, seam.boundary_patch, void_at_);
  wind(view, in_seam, patch_in_seam);
}

// Winding numbers need an embedded surface.
void SegmentCheck::wind(const ModelView& view, std::span<const TriangleVertices> triangles,
                        std::span<const std::uint32_t> patch) {
  if (embedded_.pass()) winding_.add(view.points, triangles, patch, patches_.sets());
}

void SegmentCheck::check_winding() {
  if (!embedded_.pass()) return;
  for (const Probe& probe : winding_.probes(patches_.sets())) {
    if (probe.winding == 0) continue;
    const TriangleVertices& face = patches_.first_triangle(probe.surface);
    fail_winding(embedded_, face_text({}, face));
  }
}

void SegmentCheck::add_tables(const Model& model) {
  const auto append = [](const auto& rows, auto& to) {
    to.insert(to.end(), rows.begin(), rows.end());
  };
  append(model.links, tables_.links);
  append(model.motions, tables_.motions);
  append(model.void_links, tables_.void_links);
  append(model.deviations, tables_.deviations);
}

Result<CheckReport> SegmentCheck::report() {
  work_.go_on();
  check_winding();
  // Links are defined by adjacency, which faces of three tets do not have.
  if (manifold_.failed(1) || manifold_.failed(2) || manifold_.failed(3)) manifold_.forget(4);
  const Result<void> decided = conclusions_.decide(components_, refined_, tables_, work_);
  if (!decided) return decided.error();
  work_.go_on();
  CheckReport report =
      conclusions_.report(manifold_.verdict(), resampling_.verdict(), embedded_.verdict(),
                          patches_.all(), std::move(parts_), tables_);
  figures_.tell(report);
  work_.step_done();
  return report;
}

}  // namespace tetloft::internal::checking
