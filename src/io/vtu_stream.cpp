#include "io/vtu_stream.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <type_traits>
#include <utility>

#include <tetloft/frame.hpp>

#include "core/unit_of_length.hpp"
#include "io/arguments.hpp"
#include "io/vtk_text.hpp"
#include "model/fields.hpp"
#include "model/tables.hpp"

namespace tetloft::internal::io {

namespace {

// Of fields of points, or of tets: visit(field, its number among those).
template <class Visit>
void for_each_stored(bool of_points, Visit&& visit) {
  std::size_t k = 0;
  for_each_field([&](const auto& field) {
    if (std::remove_cvref_t<decltype(field)>::kOfPoints == of_points) visit(field, k++);
  });
}

template <class Field>
using StoredType = typename std::remove_cvref_t<Field>::Stored::Type;

template <class Columns, class Id>
void append_fields(const Model& model, Id id, bool of_points, Columns& columns) {
  for_each_stored(of_points, [&](const auto& field, std::size_t k) {
    using Field = std::remove_cvref_t<decltype(field)>;
    if constexpr (Field::kOfPoints == std::is_same_v<Id, VertexId>) {
      std::get<ScratchColumn<StoredType<Field>>>(columns.fields[k])
          .push_back(Field::Stored::store((model.*field.values)[id]));
    }
  });
}

template <class Columns>
void make_fields(const std::string& path, bool of_points, Columns& columns) {
  for_each_stored(of_points, [&](const auto& field, std::size_t) {
    columns.fields.emplace_back(std::in_place_type<ScratchColumn<StoredType<decltype(field)>>>,
                                path);
  });
}

// Of columns one behind the other. Their bytes are those of the file.
template <class T>
VtkArray stored_array(std::string name, std::size_t components,
                      const std::vector<ScratchColumn<T>*>& columns) {
  const auto values = std::make_shared<ScratchSequence<T>>(columns);
  VtkArray array = vtk_array<T>(std::move(name), components, values->size(),
                                [values](std::size_t i) { return values->at(i); });
  array.append_bytes = [columns](Sink& sink) {
    for (ScratchColumn<T>* column : columns) column->append_to(sink);
  };
  return array;
}

// As the fields of a model in memory, whose order the columns have. `parts`: one behind the other.
template <class Columns>
VtkGroup stored_fields(const char* element, bool of_points, const std::vector<Columns*>& parts) {
  VtkGroup group{element, {}};
  for_each_stored(of_points, [&](const auto& field, std::size_t k) {
    using Stored = StoredType<decltype(field)>;
    std::vector<ScratchColumn<Stored>*> columns;
    for (Columns* part : parts) {
      columns.push_back(&std::get<ScratchColumn<Stored>>(part->fields[k]));
    }
    VtkArray array = stored_array<Stored>(std::string(field.name), 1, columns);
    if (array.tuples > 0) group.arrays.push_back(std::move(array));
  });
  return group;
}

double largest_of(const Point3& p) {
  return std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
}

// So many are kept for going back; what lies farther back is made again from the start.
constexpr std::size_t kMarks = 64;

}  // namespace

VtuStream::Vertices::Vertices(const std::string& path) : points(path) {
  make_fields(path, true, *this);
}
VtuStream::Tets::Tets(const std::string& path) : corners(path) { make_fields(path, false, *this); }

void VtuStream::Columns::cut(std::size_t size) {
  for (Column& column : fields) std::visit([&](auto& values) { values.cut(size); }, column);
}

VtuStream::VtuStream(const std::string& path)
    : path_(path), sections_(path), constructed_(path), tets_(path) {}

std::array<std::size_t, 4> VtuStream::rows() const {
  std::array<std::size_t, 4> counts{};
  std::size_t k = 0;
  for_each_table([&](const auto& table) { counts[k++] = (rest_.*table.rows).size(); });
  return counts;
}

void VtuStream::append_vertex(const Model& model, VertexId v, Vertices& to, Segment& segment) {
  const Point3& p = model.points[v];
  for (const double x : {p.x, p.y, p.z}) to.points.push_back(x);
  append_fields(model, v, true, to);
  if (model.origin[v] == PointOrigin::input) ++segment.input_vertices;
  if (model.origin[v] == PointOrigin::contour_split) ++segment.split_vertices;
}

void VtuStream::append_tet(const Model& model, TetId t, const AddedSegment& added) {
  for (const VertexId v : model.tets[t]) tets_.corners.push_back(added.number[v.index()]);
  append_fields(model, t, false, tets_);
}

Result<void> VtuStream::add(const Model& model, const SlabRange& slabs) {
  Mark mark{segments_.size(), numbers_};
  Segment segment;
  segment.rows = rows();
  segment.constructed.first = numbers_.constructed();
  segment.tets.first = numbers_.tets();
  const Result<AddedSegment> added = numbers_.add(model, slabs);
  if (!added) return added.error();
  if (segments_.empty()) {
    rest_.component_count = model.component_count;
    rest_.frame = model.frame;
    rest_.about = model.about;
    rest_.component_names = model.component_names;
  }
  const IndexRange& fresh = added->section_vertices;
  for (std::size_t v = fresh.first; v < fresh.end; ++v) {
    append_vertex(model, VertexId(v), sections_, segment);
  }
  for (const VertexId v : added->constructed) append_vertex(model, v, constructed_, segment);
  std::int64_t lowest = static_cast<std::int64_t>(numbers_.section_vertices());
  for (std::size_t t = added->tets.first; t < added->tets.end; ++t) {
    append_tet(model, TetId(t), *added);
    for (const VertexId v : model.tets[TetId(t)]) {
      const std::int64_t number = added->number[v.index()];
      if (number >= 0) lowest = std::min(lowest, number);
      segment.largest = std::max(segment.largest, largest_of(model.points[v]));
    }
  }
  segment.section_vertices = {static_cast<std::size_t>(lowest), numbers_.section_vertices()};
  segment.constructed.end = numbers_.constructed();
  segment.tets.end = numbers_.tets();
  append_rows(model, slabs, rest_);
  segments_.push_back(segment);
  marks_.push_back(std::move(mark));
  if (marks_.size() > kMarks) marks_.erase(marks_.begin() + 1);
  if (const auto failed = failure()) return *failed;
  return {};
}

std::size_t VtuStream::back_to(std::size_t slab) {
  while (!marks_.empty() && numbers_.slabs() > slab) {
    const Mark& mark = marks_.back();
    const Segment& segment = segments_[mark.segment];
    std::size_t k = 0;
    for_each_table([&](const auto& table) { (rest_.*table.rows).resize(segment.rows[k++]); });
    numbers_ = mark.numbers;
    segments_.resize(mark.segment);
    marks_.pop_back();
  }
  sections_.cut(numbers_.section_vertices());
  sections_.points.cut(3 * numbers_.section_vertices());
  constructed_.cut(numbers_.constructed());
  constructed_.points.cut(3 * numbers_.constructed());
  tets_.cut(numbers_.tets());
  tets_.corners.cut(4 * numbers_.tets());
  return numbers_.slabs();
}

void VtuStream::add_volumes(const Segment& segment, int exponent, CompensatedSum& sum) {
  const auto points_of = [](Vertices& vertices, const IndexRange& range) {
    return vertices.points.values(3 * range.first, 3 * range.end);
  };
  const std::vector<double> sections = points_of(sections_, segment.section_vertices);
  const std::vector<double> constructed = points_of(constructed_, segment.constructed);
  const auto point_of = [&](std::int64_t number) {
    const bool of_section = number >= 0;
    const std::size_t k = of_section
                              ? static_cast<std::size_t>(number) - segment.section_vertices.first
                              : static_cast<std::size_t>(-1 - number) - segment.constructed.first;
    const double* const x = (of_section ? sections : constructed).data() + 3 * k;
    return Point3{x[0], x[1], x[2]};
  };
  const std::vector<std::int64_t> corners =
      tets_.corners.values(4 * segment.tets.first, 4 * segment.tets.end);
  if (failure()) return;  // zeros are no numbers of vertices
  for (std::size_t i = 0; i < corners.size(); i += 4) {
    sum.add(scaled_volume({point_of(corners[i]), point_of(corners[i + 1]), point_of(corners[i + 2]),
                           point_of(corners[i + 3])},
                          exponent));
  }
}

Result<VtuStream::Figures> VtuStream::figures() {
  Figures figures;
  figures.vertices = numbers_.vertices();
  figures.tets = numbers_.tets();
  UnitOfLength unit;
  for (const Segment& segment : segments_) {
    figures.input_vertices += segment.input_vertices;
    figures.split_vertices += segment.split_vertices;
    unit.include(segment.largest);
  }
  const int exponent = unit.largest_to_one();
  CompensatedSum sum;
  for (const Segment& segment : segments_) add_volumes(segment, exponent, sum);
  figures.volume = std::ldexp(sum.value(), -3 * exponent) * volume_factor(rest_.frame);
  if (const auto failed = failure()) return *failed;
  return figures;
}

VtuGrid VtuStream::grid() {
  VtuGrid grid;
  grid.tables = vtu_tables(rest_);
  add_texts(rest_, grid.tables);
  grid.fields = {stored_fields<Vertices>("PointData", true, {&sections_, &constructed_}),
                 stored_fields<Tets>("CellData", false, {&tets_})};
  grid.points.element = "Points";
  grid.points.arrays.push_back(
      stored_array<double>("Points", 3, {&sections_.points, &constructed_.points}));
  const auto corners = std::make_shared<ScratchSequence<std::int64_t>>(
      std::vector<ScratchColumn<std::int64_t>*>{&tets_.corners});
  grid.cells = vtu_cells(
      numbers_.tets(), [this, corners](std::size_t i) { return numbers_.vertex(corners->at(i)); });
  return grid;
}

Result<Staged> VtuStream::stage(Encoding encoding, TemporaryWatcher* watcher) {
  if (Result<void> known = check_encoding(encoding); !known) return known.error();
  return io::stage(path_, watcher, [&](Sink& sink) -> Written {
    std::vector<Warning> warnings = append_vtu(sink, grid(), encoding);
    for (Warning& warning : warnings) warning.where.file = path_;
    if (const auto failed = failure()) return *failed;
    return warnings;
  });
}

std::optional<Error> VtuStream::failure() const {
  const auto of_columns = [](const Columns& columns) -> std::optional<Error> {
    for (const Column& column : columns.fields) {
      if (auto failed = std::visit([](const auto& values) { return values.failure(); }, column)) {
        return failed;
      }
    }
    return std::nullopt;
  };
  for (const std::optional<Error>& failed :
       {sections_.points.failure(), constructed_.points.failure(), tets_.corners.failure(),
        of_columns(sections_), of_columns(constructed_), of_columns(tets_)}) {
    if (failed) return failed;
  }
  return std::nullopt;
}

}  // namespace tetloft::internal::io
