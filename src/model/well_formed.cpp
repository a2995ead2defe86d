#include "model/well_formed.hpp"

#include <string>
#include <type_traits>

#include "model/fields.hpp"
#include "model/tables.hpp"

namespace tetloft::internal {

namespace {

Error refusal(std::string message) { return {ErrorCode::invalid_input, std::move(message), {}}; }

template <class Field>
Result<void> check_size(const Model& model, const Field& field) {
  const std::size_t size = (model.*field.values).size();
  const std::size_t due = Field::due(model);
  if (size == 0 || size == due) return {};
  return refusal("the model's array " + std::string(field.name) + " has " + std::to_string(size) +
                 " values where " + std::to_string(due) + " are due");
}

// The first value that is none.
template <class Field>
Result<void> check_values(const Model& model, const Field& field) {
  const auto& values = (model.*field.values).raw();
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (Field::Stored::legal(values[i])) continue;
    return refusal((Field::kOfPoints ? "vertex " : "tet ") + std::to_string(i) + " has the " +
                   std::string(field.name) + ' ' +
                   std::to_string(static_cast<int>(Field::Stored::store(values[i]))) +
                   ", which there is not");
  }
  return {};
}

template <class Table>
Result<void> check_rows(const Model& model, const Table& table) {
  const auto& rows = model.*table.rows;
  Result<void> fine;
  for_each_column(table, [&](const auto& column) {
    using Stored = typename std::remove_cvref_t<decltype(column)>::Stored;
    for (std::size_t i = 0; i < rows.size() && fine; ++i) {
      if (Stored::legal(column.get(rows[i]))) continue;
      fine = refusal("the model's " + std::string(table.row) + ' ' + std::to_string(i) +
                     " has a value in " + std::string(column.name) + " that there is not");
    }
  });
  return fine;
}

}  // namespace

Result<void> check_tets(std::size_t vertex_count, std::span<const TetVertices> tets) {
  if (tets.size() >= kMostModelTets) return refusal("2^30 tets or more");
  for (std::size_t t = 0; t < tets.size(); ++t) {
    for (const VertexId v : tets[t]) {
      if (v.index() < vertex_count) continue;
      return refusal("tet " + std::to_string(t) + " names vertex " + std::to_string(v.value()) +
                     " of " + std::to_string(vertex_count));
    }
  }
  return {};
}

Result<void> check_well_formed(const Model& model) {
  Result<void> fine = check_tets(model.points.size(), model.tets.raw());
  for_each_field([&](const auto& field) {
    if (fine) fine = check_size(model, field);
  });
  for_each_field([&](const auto& field) {
    if (fine) fine = check_values(model, field);
  });
  for_each_table([&](const auto& table) {
    if (fine) fine = check_rows(model, table);
  });
  return fine;
}

}  // namespace tetloft::internal
