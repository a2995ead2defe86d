// Solids as Gmsh writes them since 2019 (.msh, version 4.1; "Gmsh", Geuzaine and Remacle, reference
// manual, section "MSH file format").
//
// Each component is a volume and its boundary a surface, both discrete, in physical groups of its
// number and name. Every node belongs to one of these entities: to the surface that it lies on,
// else to its volume.
#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "io/format.hpp"
#include "io/msh_read.hpp"
#include "io/msh_write.hpp"

namespace tetloft::internal::io {

namespace {

struct MshBox {
  Point3 low{0, 0, 0};
  Point3 high{0, 0, 0};
  bool empty = true;

  void add(const Point3& p) {
    if (empty) low = high = p;
    empty = false;
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
};

class Msh4Sections {
 public:
  Msh4Sections(MshWriter& out, const Model& model, const std::vector<MshGroup>& groups)
      : out_(out), model_(model), groups_(groups) {}

  void append() {
    append_entities();
    append_nodes();
    append_elements();
  }

 private:
  // Surfaces first, then volumes; all entities of one kind in the order of the groups.
  void append_entities() {
    const auto surfaces = std::count_if(groups_.begin(), groups_.end(), has_surface);
    out_.line("$Entities");
    out_.size(0);
    out_.size(0);
    out_.size(static_cast<std::uint64_t>(surfaces));
    out_.size(groups_.size());
    out_.end_row();
    for (const MshGroup& g : groups_) {
      if (!has_surface(g)) continue;
      MshBox box;
      for (const TriangleVertices& triangle : g.group.triangles) {
        for (const VertexId v : triangle) box.add(model_.points[v]);
      }
      append_entity(g, box);
      out_.size(0);  // curves around it
      out_.end_row();
    }
    for (const MshGroup& g : groups_) {
      MshBox box;
      for (const TetId tet : g.group.tets) {
        for (const VertexId v : model_.tets[tet]) box.add(model_.points[v]);
      }
      append_entity(g, box);
      out_.size(has_surface(g) ? 1 : 0);
      if (has_surface(g)) out_.integer(g.entity);
      out_.end_row();
    }
    out_.end_section("Entities");
  }

  static bool has_surface(const MshGroup& g) { return !g.group.triangles.empty(); }

  void append_entity(const MshGroup& g, const MshBox& box) {
    out_.integer(g.entity);
    out_.point(box.low);
    out_.point(box.high);
    out_.size(g.group.tag() != 0 ? 1 : 0);
    if (g.group.tag() != 0) out_.integer(g.group.tag());
  }

  // The nodes of each entity: index 2 i + 1 is the volume of group i, 2 i its surface.
  [[nodiscard]] std::vector<std::vector<VertexId>> nodes_of_entities() const {
    constexpr std::uint32_t kNone = 0xFFFFFFFF;
    IdVector<VertexId, std::uint32_t> entity(model_.points.size(), kNone);
    const auto claim = [&](std::span<const VertexId> vertices, std::size_t number) {
      for (const VertexId v : vertices) {
        if (entity[v] == kNone) entity[v] = static_cast<std::uint32_t>(number);
      }
    };
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      for (const TriangleVertices& triangle : groups_[i].group.triangles) claim(triangle, 2 * i);
    }
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      for (const TetId tet : groups_[i].group.tets) claim(model_.tets[tet], 2 * i + 1);
    }
    std::vector<std::vector<VertexId>> nodes(2 * groups_.size());
    for (const VertexId v : model_.points.ids()) {
      // Those of no tet to the first volume.
      nodes[entity[v] == kNone ? 1 : entity[v]].push_back(v);
    }
    return nodes;
  }

  // A block of an entity's nodes, or of its elements.
  void begin_block(std::size_t dimension, const MshGroup& g, std::int64_t kind, std::size_t size) {
    out_.integer(static_cast<std::int64_t>(dimension));
    out_.integer(g.entity);
    out_.integer(kind);
    out_.size(size);
    out_.end_row();
  }

  void begin_blocks(std::size_t blocks, std::size_t count) {
    out_.size(blocks);
    out_.size(count);
    out_.size(count == 0 ? 0 : 1);
    out_.size(count);
    out_.end_row();
  }

  void append_nodes() {
    const std::vector<std::vector<VertexId>> nodes = nodes_of_entities();
    const auto blocks = std::count_if(nodes.begin(), nodes.end(),
                                      [](const auto& of_one) { return !of_one.empty(); });
    out_.line("$Nodes");
    begin_blocks(static_cast<std::size_t>(blocks), model_.points.size());
    for (std::size_t entity = 0; entity < nodes.size(); ++entity) {
      if (nodes[entity].empty()) continue;
      constexpr std::int64_t kNotParametric = 0;
      begin_block(2 + entity % 2, groups_[entity / 2], kNotParametric, nodes[entity].size());
      for (const VertexId v : nodes[entity]) {
        out_.size(v.index() + 1);
        out_.end_row();
      }
      for (const VertexId v : nodes[entity]) {
        out_.point(model_.points[v]);
        out_.end_row();
      }
    }
    out_.end_section("Nodes");
  }

  // Tets have the numbers of the model, by which their order can be had back; triangles follow.
  void append_elements() {
    std::size_t blocks = 0;
    for (const MshGroup& g : groups_) {
      blocks += (has_surface(g) ? 1U : 0U) + (g.group.tets.empty() ? 0U : 1U);
    }
    out_.line("$Elements");
    begin_blocks(blocks, count_elements(model_, groups_));
    std::size_t next = model_.tets.size() + 1;
    for (const MshGroup& g : groups_) {
      if (!has_surface(g)) continue;
      begin_block(2, g, kMshTriangle, g.group.triangles.size());
      for (const TriangleVertices& triangle : g.group.triangles) append_element(next++, triangle);
    }
    for (const MshGroup& g : groups_) {
      if (g.group.tets.empty()) continue;
      begin_block(3, g, kMshTet, g.group.tets.size());
      for (const TetId tet : g.group.tets) append_element(tet.index() + 1, model_.tets[tet]);
    }
    out_.end_section("Elements");
  }

  void append_element(std::size_t number, std::span<const VertexId> corners) {
    out_.size(number);
    for (const VertexId v : corners) out_.size(v.index() + 1);
    out_.end_row();
  }

  MshWriter& out_;
  const Model& model_;
  const std::vector<MshGroup>& groups_;
};

Written write_msh4(Sink& sink, const Model& model, const Target& target) {
  const Result<std::vector<MshGroup>> groups = msh_groups(model);
  if (!groups) return groups.error();
  return append_msh<Msh4Sections>(sink, target.options.encoding, "4.1", model, *groups);
}

}  // namespace

extern constinit const Format msh_format{.name = "msh",
                                         .summary = "Gmsh 4.1",
                                         .extensions = {".msh"},
                                         .recognise = is_msh,
                                         .read_model = read_msh,
                                         .write_model = write_msh4};

}  // namespace tetloft::internal::io
