// Solids as Gmsh wrote them before (version 2.2), which many programs read that know no later one.
// As in msh.cpp each component is a volume and a surface, in physical groups of its number and
// name.
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "io/format.hpp"
#include "io/msh_read.hpp"
#include "io/msh_write.hpp"

namespace tetloft::internal::io {

namespace {

class Msh2Sections {
 public:
  Msh2Sections(MshWriter& out, const Model& model, const std::vector<MshGroup>& groups)
      : out_(out), model_(model), groups_(groups) {}

  void append() {
    out_.line("$Nodes");
    out_.line(std::to_string(model_.points.size()));
    for (const VertexId v : model_.points.ids()) {
      out_.integer(v.value() + std::int64_t{1});
      out_.point(model_.points[v]);
      out_.end_row();
    }
    out_.end_section("Nodes");
    append_elements();
  }

 private:
  void append_elements() {
    out_.line("$Elements");
    out_.line(std::to_string(count_elements(model_, groups_)));
    std::size_t next = model_.tets.size() + 1;
    for (const MshGroup& g : groups_) {
      begin_elements(kMshTriangle, g.group.triangles.size());
      for (const TriangleVertices& triangle : g.group.triangles) {
        append_element(kMshTriangle, next++, g, triangle);
      }
    }
    for (const MshGroup& g : groups_) {
      begin_elements(kMshTet, g.group.tets.size());
      for (const TetId tet : g.group.tets) {
        append_element(kMshTet, tet.index() + 1, g, model_.tets[tet]);
      }
    }
    out_.end_section("Elements");
  }

  // In binary files the kind stands before all of a row of elements, as text in each.
  void begin_elements(std::int64_t kind, std::size_t count) {
    if (out_.ascii() || count == 0) return;
    out_.integer(kind);
    out_.integer(static_cast<std::int64_t>(count));
    out_.integer(kTags);
  }

  void append_element(std::int64_t kind, std::size_t number, const MshGroup& g,
                      std::span<const VertexId> corners) {
    out_.integer(static_cast<std::int64_t>(number));
    if (out_.ascii()) {
      out_.integer(kind);
      out_.integer(kTags);
    }
    out_.integer(g.group.tag());
    out_.integer(g.entity);
    for (const VertexId v : corners) out_.integer(v.value() + std::int64_t{1});
    out_.end_row();
  }

  static constexpr std::int64_t kTags = 2;  // physical group and entity

  MshWriter& out_;
  const Model& model_;
  const std::vector<MshGroup>& groups_;
};

Written write_msh2(Sink& sink, const Model& model, const Target& target) {
  const Result<std::vector<MshGroup>> groups = msh_groups(model);
  if (!groups) return groups.error();
  constexpr auto kMost = static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max());
  if (model.points.size() > kMost || count_elements(model, *groups) > kMost) {
    return Error{ErrorCode::invalid_input, "Gmsh 2.2 holds less points and tets: msh", {}};
  }
  return append_msh<Msh2Sections>(sink, target.options.encoding, "2.2", model, *groups);
}

}  // namespace

extern constinit const Format msh2_format{.name = "msh2",
                                          .summary = "Gmsh 2.2",
                                          .extensions = {".msh2"},
                                          .read_model = read_msh,
                                          .write_model = write_msh2};

}  // namespace tetloft::internal::io
