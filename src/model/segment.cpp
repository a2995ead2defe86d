#include "model/segment.hpp"

#include <algorithm>
#include <bit>
#include <string>
#include <utility>

#include "model/fields.hpp"
#include "model/tables.hpp"

namespace tetloft::internal {

namespace {

Error no_segment(const std::string& why) {
  return {ErrorCode::invalid_input, "it is no part of a solid: " + why, {}};
}

bool same_bits(const Point3& a, const Point3& b) {
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
  return bits(a.x) == bits(b.x) && bits(a.y) == bits(b.y) && bits(a.z) == bits(b.z);
}

// Where each section's vertices are, from `first` to `end`, and that those are in order, in front
// of all constructed ones.
Result<std::vector<IndexRange>> ranges_of_sections(const Model& model, const SlabRange& slabs) {
  std::vector<IndexRange> ranges(slabs.end - slabs.first + 1);
  std::size_t at = 0;
  const std::size_t points = model.points.size();
  while (at < points && model.section[VertexId(at)].valid()) {
    const SectionId s = model.section[VertexId(at)];
    const std::size_t begin = at;
    while (at < points && model.section[VertexId(at)] == s) ++at;
    if (at < points && model.section[VertexId(at)].valid() && !(model.section[VertexId(at)] > s)) {
      return no_segment("its vertices are not in order of sections");
    }
    if (s.index() >= slabs.first && s.index() <= slabs.end) {
      ranges[s.index() - slabs.first] = {begin, at};
    }
  }
  for (std::size_t v = at; v < points; ++v) {
    if (model.section[VertexId(v)].valid()) {
      return no_segment("a section's vertex comes behind one between sections");
    }
  }
  // Of empty sections too, so that all together are one range.
  std::size_t end = 0;
  for (const IndexRange& range : ranges) {
    if (range.size() != 0) {
      end = range.first;
      break;
    }
  }
  for (IndexRange& range : ranges) {
    if (range.size() == 0) range = {end, end};
    if (range.first != end) return no_segment("its vertices are not in order of sections");
    end = range.end;
  }
  return ranges;
}

Result<IndexRange> tets_of(const Model& model, const SlabRange& slabs) {
  IndexRange range;
  const auto& slab = model.slab;
  for (std::size_t t = 1; t < slab.size(); ++t) {
    if (slab[TetId(t)] < slab[TetId(t - 1)])
      return no_segment("its tets are not in order of slabs");
  }
  while (range.first < slab.size() && !slabs.holds(slab[TetId(range.first)])) ++range.first;
  range.end = range.first;
  while (range.end < slab.size() && slabs.holds(slab[TetId(range.end)])) ++range.end;
  return range;
}

}  // namespace

bool SegmentNumbers::fits_seam(const Model& model, const IndexRange& section) const {
  if (section.size() != seam_.size()) return false;
  for (std::size_t k = 0; k < seam_.size(); ++k) {
    const VertexId v(section.first + k);
    if (!same_bits(model.points[v], seam_[k].point) || model.contour[v] != seam_[k].contour ||
        model.origin[v] != seam_[k].origin) {
      return false;
    }
  }
  return true;
}

Result<AddedSegment> SegmentNumbers::add(const Model& model, const SlabRange& slabs) {
  const std::size_t points = model.points.size();
  if (model.section.size() != points || model.contour.size() != points ||
      model.origin.size() != points || model.slab.size() != model.tets.size() ||
      model.component.size() != model.tets.size() || model.kind.size() != model.tets.size()) {
    return no_segment("it lacks what tells where its vertices and tets come from");
  }
  if (slabs.first != slabs_) return no_segment("it does not begin where the one below ends");
  Result<std::vector<IndexRange>> sections = ranges_of_sections(model, slabs);
  if (!sections) return sections.error();
  Result<IndexRange> tets = tets_of(model, slabs);
  if (!tets) return tets.error();
  if (any_ && !fits_seam(model, sections->front())) {
    return no_segment("section " + std::to_string(slabs.first) + " is another one below it");
  }

  AddedSegment added;
  added.tets = *tets;
  added.number.assign(points, AddedSegment::kNone);
  std::size_t next = section_vertices_ - (any_ ? seam_.size() : 0);
  for (std::size_t v = sections->front().first; v < sections->back().end; ++v) {
    added.number[v] = static_cast<std::int64_t>(next++);
  }
  added.section_vertices = {any_ ? sections->front().end : sections->front().first,
                            sections->back().end};
  for (std::size_t t = tets->first; t < tets->end; ++t) {
    for (const VertexId v : model.tets[TetId(t)]) {
      if (v.index() >= points) return no_segment("a tet names a vertex that there is not");
      if (added.number[v.index()] != AddedSegment::kNone) continue;
      if (model.section[v].valid()) return no_segment("a tet has a vertex of another slab");
      added.number[v.index()] = 0;  // any, so far
      added.constructed.push_back(v);
    }
  }
  std::sort(added.constructed.begin(), added.constructed.end());
  for (const VertexId v : added.constructed) {
    added.number[v.index()] = -1 - static_cast<std::int64_t>(constructed_++);
  }
  section_vertices_ = next;
  tets_ += tets->size();
  slabs_ = slabs.end;
  seam_.clear();
  for (std::size_t v = sections->back().first; v < sections->back().end; ++v) {
    seam_.push_back(
        {model.points[VertexId(v)], model.contour[VertexId(v)], model.origin[VertexId(v)]});
  }
  any_ = true;
  return added;
}

void append_rows(const Model& model, const SlabRange& slabs, Model& whole) {
  for_each_table([&](const auto& table) {
    auto& rows = whole.*table.rows;
    for (const auto& row : model.*table.rows) {
      if (slabs.holds(row.slab)) rows.push_back(row);
    }
  });
}

Result<void> JoinedModel::add(const Model& model, const SlabRange& slabs) {
  const Result<AddedSegment> added = numbers_.add(model, slabs);
  if (!added) return added.error();
  if (whole_.tets.empty() && tets_.empty()) {
    whole_.component_count = model.component_count;
    whole_.frame = model.frame;
    whole_.about = model.about;
    whole_.component_names = model.component_names;
  }
  const auto append_vertex = [&](VertexId v, Model& to) {
    to.points.push_back(model.points[v]);
    to.section.push_back(model.section[v]);
    to.contour.push_back(model.contour[v]);
    to.origin.push_back(model.origin[v]);
  };
  for (std::size_t v = added->section_vertices.first; v < added->section_vertices.end; ++v) {
    append_vertex(VertexId(v), whole_);
  }
  for (const VertexId v : added->constructed) append_vertex(v, constructed_);
  for (std::size_t t = added->tets.first; t < added->tets.end; ++t) {
    const TetId id(t);
    std::array<std::int64_t, 4> numbers{};
    for (std::size_t i = 0; i < 4; ++i) numbers[i] = added->number[model.tets[id][i].index()];
    tets_.push_back(numbers);
    whole_.component.push_back(model.component[id]);
    whole_.slab.push_back(model.slab[id]);
    whole_.kind.push_back(model.kind[id]);
  }
  append_rows(model, slabs, whole_);
  return {};
}

Model JoinedModel::take() {
  for (const VertexId v : constructed_.points.ids()) {
    whole_.points.push_back(constructed_.points[v]);
    whole_.section.push_back(constructed_.section[v]);
    whole_.contour.push_back(constructed_.contour[v]);
    whole_.origin.push_back(constructed_.origin[v]);
  }
  whole_.tets.reserve(tets_.size());
  for (const std::array<std::int64_t, 4>& numbers : tets_) {
    TetVertices tet{};
    for (std::size_t i = 0; i < 4; ++i) tet[i] = VertexId(numbers_.vertex(numbers[i]));
    whole_.tets.push_back(tet);
  }
  return std::move(whole_);
}

}  // namespace tetloft::internal
