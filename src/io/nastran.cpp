// Solids as bulk data of Nastran (NX and MSC Nastran quick reference guides): GRID* in large
// fields, CTETRA in small ones, a PSOLID for each component. Loads, supports and materials are
// left to the user: PSOLID n asks for MAT1 n.
//
// A real has a point, and 16 characters at most; so has one in free fields.
#include <cstdint>
#include <string>

#include "core/text.hpp"
#include "io/fitted_number.hpp"
#include "io/format.hpp"
#include "io/group_number.hpp"
#include "io/numbers.hpp"
#include "io/solid_comments.hpp"

namespace tetloft::internal::io {

namespace {

constexpr std::size_t kSmallBulkField = 8;
constexpr std::size_t kLargeBulkField = 16;
// Of points, of tets and of components: as many as a small field holds.
constexpr std::size_t kMostNastranIds = 99'999'999;

void append_bulk_field(std::string& text, const std::string& field, std::size_t width) {
  text += field;
  text.append(width - field.size(), ' ');
}

// The last fields of a line may be left out, as may what marks that it goes on.
void append_bulk_grid(std::string& text, VertexId v, const Point3& p,
                      FittedCoordinates& coordinates) {
  append_bulk_field(text, "GRID*", kSmallBulkField);
  append_bulk_field(text, std::to_string(v.index() + 1), kLargeBulkField);
  text.append(kLargeBulkField, ' ');  // of the usual coordinates
  append_bulk_field(text, coordinates.text_of(p.x), kLargeBulkField);
  append_bulk_field(text, coordinates.text_of(p.y), kLargeBulkField);
  text += "*\n";
  append_bulk_field(text, "*", kSmallBulkField);
  text += coordinates.text_of(p.z) + '\n';
}

void append_ctetra(std::string& text, TetId t, std::int64_t property, const TetVertices& corners) {
  append_bulk_field(text, "CTETRA", kSmallBulkField);
  append_bulk_field(text, std::to_string(t.index() + 1), kSmallBulkField);
  append_bulk_field(text, std::to_string(property), kSmallBulkField);
  for (const VertexId v : corners) {
    append_bulk_field(text, std::to_string(v.index() + 1), kSmallBulkField);
  }
  text += '\n';
}

Written write_nastran(Sink& sink, const Model& model, const Target& /*target*/) {
  const std::vector<ComponentGroup> groups = component_groups(model);
  const std::int64_t of_none = free_number(groups);
  if (std::max(model.points.size(), model.tets.size()) > kMostNastranIds ||
      of_none > std::int64_t{kMostNastranIds}) {
    return Error{ErrorCode::invalid_input,
                 "Nastran numbers points, tets and components up to 99999999; this model has more",
                 {}};
  }
  Pieces pieces(sink);
  std::string& text = pieces.text();
  text = "$ Mesh by tetloft\n";
  append_comments(text, "$", model, {});
  text += "BEGIN BULK\n";
  for (const ComponentGroup& group : groups) {
    const std::string property = std::to_string(group.component.valid() ? group.tag() : of_none);
    text += "$ PSOLID " + property + " is " + printable(group.name) + "; it asks for MAT1 " +
            property + '\n';
    append_bulk_field(text, "PSOLID", kSmallBulkField);
    append_bulk_field(text, property, kSmallBulkField);
    text += property + '\n';
    pieces.next();
  }
  FittedCoordinates coordinates(kLargeBulkField);
  for (const VertexId v : model.points.ids()) {
    append_bulk_grid(text, v, model.points[v], coordinates);
    pieces.next();
  }
  for (const TetId t : model.tets.ids()) {
    append_ctetra(text, t, group_number(model, t, of_none), model.tets[t]);
    pieces.next();
  }
  text += "ENDDATA\n";
  pieces.finish();
  return coordinates.warnings();
}

}  // namespace

extern constinit const Format nastran_format{.name = "nastran",
                                             .summary = "Nastran bulk data",
                                             .extensions = {".bdf", ".nas"},
                                             .write_model = write_nastran};

}  // namespace tetloft::internal::io
