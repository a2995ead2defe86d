#include "check/seam.hpp"

#include <algorithm>

#include "core/guard.hpp"

namespace tetloft::internal::checking {

namespace {

// Appends points and tets of a side, the seam's vertices being there.
void append_side(const SeamSide& side, Model& model, PartOfWhole& part) {
  std::vector<VertexId> at;
  for (std::size_t v = 0; v < side.points.size(); ++v) {
    if (v < side.seam_vertices) {
      at.push_back(VertexId(v));
      continue;
    }
    at.push_back(model.points.push_back(side.points[v]));
    part.vertex.push_back(side.number[v]);
    part.seam.push_back(0);
  }
  for (std::size_t t = 0; t < side.tets.size(); ++t) {
    TetVertices tet = side.tets[t];
    for (VertexId& v : tet) v = at[v.index()];
    model.tets.push_back(tet);
    part.tet.push_back(side.id[t]);
  }
}

}  // namespace

SeamSide side_of(const ModelView& segment, std::uint8_t seam, const SegmentNumbering& numbering) {
  SeamSide side;
  std::vector<VertexId> at(segment.points.size());
  const auto take = [&](VertexId v) {
    if (!at[v.index()].valid()) {
      at[v.index()] = VertexId(side.points.size());
      side.points.push_back(segment.points[v.index()]);
      side.number.push_back(segment.number(v));
    }
    return at[v.index()];
  };
  const auto lies_in = [&](VertexId v) { return segment.part.seam[v.index()] == seam; };
  for (std::size_t v = 0; v < segment.points.size(); ++v) {
    if (lies_in(VertexId(v))) take(VertexId(v));
  }
  side.seam_vertices = side.points.size();
  std::vector<std::uint32_t> place(segment.tets.size(), SeamSide::kNone);
  for (std::size_t t = 0; t < segment.tets.size(); ++t) {
    TetVertices tet = segment.tets[t];
    if (std::none_of(tet.begin(), tet.end(), lies_in)) continue;
    place[t] = static_cast<std::uint32_t>(side.tets.size());
    for (VertexId& v : tet) v = take(v);
    side.tets.push_back(tet);
    side.id.push_back(segment.id[t]);
    side.component.push_back(numbering.component[t]);
    side.part.push_back(numbering.part[t]);
  }
  side.patch.assign(side.tets.size(),
                    {SeamSide::kNone, SeamSide::kNone, SeamSide::kNone, SeamSide::kNone});
  for (std::size_t k = 0; k < segment.boundary_face.size(); ++k) {
    const std::size_t h = segment.boundary_face[k].index();
    if (place[h / 4] == SeamSide::kNone) continue;
    side.patch[place[h / 4]][h % 4] = numbering.boundary_patch[k];
  }
  return side;
}

void join_sides(const SeamSide& lower, const SeamSide& upper, const SectionStack& stack,
                Seam& seam) {
  TETLOFT_CHECK(lower.seam_vertices == upper.seam_vertices);
  PartOfWhole part;
  part.scope = Scope::seam;
  for (std::size_t v = 0; v < lower.seam_vertices; ++v) {
    TETLOFT_CHECK(lower.number[v] == upper.number[v]);
    seam.model.points.push_back(lower.points[v]);
    part.vertex.push_back(lower.number[v]);
    part.seam.push_back(1);
  }
  append_side(lower, seam.model, part);
  append_side(upper, seam.model, part);
  seam.view = look_at(seam.model, stack, std::move(part));
  seam.first_upper = lower.tets.size();
  for (const SeamSide* const side : {&lower, &upper}) {
    seam.component.insert(seam.component.end(), side->component.begin(), side->component.end());
    seam.part.insert(seam.part.end(), side->part.begin(), side->part.end());
  }
  for (const HalfFaceId face : seam.view.boundary_face) {
    const std::size_t t = face.index() / 4;
    const bool is_upper = t >= seam.first_upper;
    const SeamSide& side = is_upper ? upper : lower;
    seam.boundary_patch.push_back(
        side.patch[t - (is_upper ? seam.first_upper : 0)][face.index() % 4]);
  }
}

}  // namespace tetloft::internal::checking
