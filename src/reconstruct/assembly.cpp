#include "reconstruct/assembly.hpp"

#include <algorithm>
#include <utility>

#include "core/check.hpp"
#include "core/cpu_clock.hpp"

namespace tetloft {

Assembly::Assembly(const IdVector<SectionId, ConformingSection>& sections,
                   const Correspondence& correspondence)
    : sections_(sections), correspondence_(correspondence) {
  add_section_vertices();
}

void Assembly::add(std::size_t place, Part part) {
  const std::scoped_lock lock(mutex_);
  waiting_.emplace(place, std::move(part));
  const WorkStopwatch watch;
  while (!waiting_.empty() && waiting_.begin()->first == next_) {
    // Taken out first: should memory end amid gluing, no other thread tries again.
    const auto part_at = waiting_.extract(waiting_.begin());
    glue(part_at.mapped());
    ++next_;
  }
  tally_.seconds[static_cast<std::size_t>(Step::assembly)] += watch.seconds();
}

Model Assembly::take() {
  TETLOFT_CHECK(waiting_.empty());
  return std::move(model_);
}

void Assembly::add_section_vertices() {
  for (std::size_t s = 0; s < sections_.size(); ++s) {
    const ConformingSection& section = sections_[SectionId(s)];
    first_vertex_.push_back(model_.points.size());
    for (std::size_t k = 0; k < section.vertex_count(); ++k) {
      const VertexId v(k);
      const bool input = section.input_vertex[v] != ConformingSection::kNotInput;
      add_point(section.point3(v), SectionId(s), section.contour[v],
                input ? PointOrigin::input : PointOrigin::contour_split);
    }
  }
  for (const auto& section : correspondence_.component) {
    for (const ComponentId c : section) {
      model_.component_count = std::max(model_.component_count, c.index() + 1);
    }
  }
}

VertexId Assembly::add_point(const Point3& p, SectionId section, ContourId contour,
                             PointOrigin origin) {
  model_.section.push_back(section);
  model_.contour.push_back(contour);
  model_.origin.push_back(origin);
  return model_.points.push_back(p);
}

ComponentId Assembly::component_of(const Part& part, SlabRegionId region) const {
  const std::size_t lows = part.lower.valid() ? correspondence_.component[part.lower].size() : 0;
  if (region.index() < lows) return correspondence_.component[part.lower][RegionId(region.index())];
  return correspondence_.component[part.upper][RegionId(region.index() - lows)];
}

void Assembly::glue(const Part& part) {
  const SlabSolid& solid = part.solid;
  for (std::size_t r = 0; r < kRules; ++r) tally_.rules[r] += solid.rules[r];
  for (std::size_t s = 0; s < kSteps; ++s) tally_.seconds[s] += solid.seconds[s];
  tally_.work += solid.work;
  tally_.smallest_lift = std::min(tally_.smallest_lift, solid.smallest_lift);

  const std::size_t lows = part.lower.valid() ? sections_[part.lower].vertex_count() : 0;
  // Model ids of constructed nodes. Those that a piece uses are marked first (with any
  // valid id), then numbered in order.
  std::vector<VertexId> constructed(solid.constructed.size());
  for (const Piece& piece : solid.pieces) {
    for (const VertexId v : piece.node) {
      if (v.index() >= solid.section_vertices) {
        constructed[v.index() - solid.section_vertices] = VertexId(0);
      }
    }
  }
  for (std::size_t k = 0; k < constructed.size(); ++k) {
    if (!constructed[k].valid()) continue;
    constructed[k] = add_point(solid.constructed[k], {}, {}, solid.origin[k]);
  }
  const auto model_id = [&](VertexId v) {
    if (v.index() >= solid.section_vertices) {
      return constructed[v.index() - solid.section_vertices];
    }
    if (v.index() < lows) return VertexId(first_vertex_[part.lower.index()] + v.index());
    return VertexId(first_vertex_[part.upper.index()] + v.index() - lows);
  };
  for (const Piece& piece : solid.pieces) {
    TetVertices tet;
    for (std::size_t i = 0; i < 4; ++i) tet[i] = model_id(piece.node[i]);
    model_.tets.push_back(tet);
    model_.component.push_back(component_of(part, piece.region));
    model_.slab.push_back(part.slab);
    model_.kind.push_back(piece.kind);
  }
}

}  // namespace tetloft
