#include "reconstruct/glue.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "core/pages.hpp"
#include "core/parallel.hpp"

namespace tetloft::internal {

namespace {

class Gluing {
 public:
  Gluing(const IdVector<SectionId, ConformingSection>& sections, const RegionComponents& component)
      : sections_(sections), component_(component) {
    for (const auto& section : component) {
      for (const ComponentId c : section) {
        model_.component_count = std::max(model_.component_count, c.index() + 1);
      }
    }
  }

  Model run(std::vector<Part> parts, unsigned threads) {
    reserve(parts);
    for (const SectionId s : sections_.ids()) add_section(s, sections_[s]);
    // A batch, whose tets are new memory, is given up before the next one.
    for (std::size_t first = 0; first < parts.size(); first += kBatch) {
      add(std::span(parts).subspan(first, std::min(kBatch, parts.size() - first)), threads);
    }
    return std::move(model_);
  }

 private:
  void add_section(SectionId s, const ConformingSection& section) {
    vertices_.add_section(section.vertex_count());
    for (const PlaneVertexId v : section.contour.ids()) {
      const bool input = section.input_vertex[v] != ConformingSection::kNotInput;
      add_point(section.point3(v), s, section.contour[v],
                input ? PointOrigin::input : PointOrigin::contour_split);
    }
  }

  static constexpr std::size_t kBatch = 16;  // parts: enough for some threads, few beside a stack

  void reserve(const std::vector<Part>& parts) {
    std::size_t tets = 0;
    std::size_t points = 0;
    for (const ConformingSection& section : sections_) points += section.vertex_count();
    for (const Part& part : parts) {
      tets += part.solid.pieces.size();
      points += part.solid.constructed.size();
    }
    model_.tets.reserve(tets);
    model_.component.reserve(tets);
    model_.slab.reserve(tets);
    model_.kind.reserve(tets);
    model_.points.reserve(points);
    model_.section.reserve(points);
    model_.contour.reserve(points);
    model_.origin.reserve(points);
  }

  void add(std::span<Part> batch, unsigned threads) {
    std::vector<IdVector<ConstructedId, VertexId>> constructed;
    std::vector<std::size_t> first_tet;
    std::size_t tets = model_.tets.size();
    for (const Part& part : batch) {
      constructed.push_back(add_constructed(part.solid));
      first_tet.push_back(tets);
      tets += part.solid.pieces.size();
    }
    model_.tets.resize(tets);
    model_.component.resize(tets);
    model_.slab.resize(tets);
    model_.kind.resize(tets);
    parallel_for(batch.size(), threads, [&](std::size_t k) {
      set_tets(batch[k], constructed[k], TetId(first_tet[k]));
      core::release(batch[k].solid.pieces);
      batch[k].solid = SlabSolid();
    });
  }

  VertexId add_point(const Point3& p, SectionId section, ContourId contour, PointOrigin origin) {
    model_.section.raw().push_back(section);
    model_.contour.raw().push_back(contour);
    model_.origin.raw().push_back(origin);
    return model_.points.push_back(p);
  }

  [[nodiscard]] ComponentId component_of(const Part& part, SlabRegionId r) const {
    const SlabRegions& regions = part.solid.regions;
    return component_[regions.is_upper(r) ? part.upper : part.lower][regions.in_section(r)];
  }

  // From t on.
  void set_tets(const Part& part, const IdVector<ConstructedId, VertexId>& constructed, TetId t) {
    const SlabSolid& solid = part.solid;
    const Nodes nodes = solid.nodes();
    const auto model_vertex = [&](NodeId n) {
      if (nodes.is_constructed(n)) return constructed[nodes.constructed(n)];
      const SlabVertexId v = Nodes::slab_vertex(n);
      return vertices_.of(solid.vertices.is_upper(v) ? part.upper : part.lower,
                          solid.vertices.in_section(v));
    };
    for (const Piece& piece : solid.pieces) {
      const auto& [a, b, c, d] = piece.node;
      model_.tets[t] = {model_vertex(a), model_vertex(b), model_vertex(c), model_vertex(d)};
      model_.component[t] = component_of(part, piece.region);
      model_.slab[t] = part.slab;
      model_.kind[t] = piece.kind;
      t = TetId(t.value() + 1);
    }
  }

  // Those that a piece uses are marked first (with any valid id), then numbered in order.
  IdVector<ConstructedId, VertexId> add_constructed(const SlabSolid& solid) {
    const Nodes nodes = solid.nodes();
    IdVector<ConstructedId, VertexId> vertex(solid.constructed.size());
    for (const Piece& piece : solid.pieces) {
      for (const NodeId n : piece.node) {
        if (nodes.is_constructed(n)) vertex[nodes.constructed(n)] = VertexId(0);
      }
    }
    for (const ConstructedId k : vertex.ids()) {
      if (!vertex[k].valid()) continue;
      vertex[k] = add_point(solid.constructed[k], {}, {}, solid.origin[k]);
    }
    return vertex;
  }

  const IdVector<SectionId, ConformingSection>& sections_;
  const RegionComponents& component_;
  StackVertices vertices_;
  Model model_;
};

}  // namespace

Model glue(const IdVector<SectionId, ConformingSection>& sections,
           const RegionComponents& component, std::vector<Part> parts, unsigned threads) {
  return Gluing(sections, component).run(std::move(parts), threads);
}

}  // namespace tetloft::internal
