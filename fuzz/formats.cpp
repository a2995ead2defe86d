// Every reader of the table, and the choice between them: any bytes give values or a clean error
// under each name of a format and under each extension; what was read survives writing.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <tetloft/formats.hpp>
#include <tetloft/slice.hpp>

#include "fuzz/target.hpp"

namespace {

using namespace tetloft;
using namespace tetloft::fuzz;

void try_stack(std::string_view bytes, const std::string& name, const ReadOptions& options) {
  const auto read = parse_stack(bytes, name, options);
  if (!fine(read)) return;
  require(validate(read->stack).ok(), "a reader hands out a stack that is not valid");
  for (const FormatInfo& format : formats()) {
    if (!format.reads.has(Contents::stack) || !format.writes.has(Contents::stack)) continue;
    const std::string own(format.name);
    const auto once = format_stack(read->stack, {.format = own});
    require(once.ok(), "a stack that was read cannot be written");
    // Planes in other directions are turned, which rounds.
    if (read->stack.frame != Frame()) continue;
    const auto again = parse_stack(once->bytes, "again", {.format = own});
    require(again.ok(), "a stack that was written cannot be read");
    require(format_stack(again->stack, {.format = own})->bytes == once->bytes,
            "a stack does not survive writing");
  }
}

// Whichever way round: readers turn negative tets over.
std::vector<TetVertices> sorted_tets(const Model& model) {
  std::vector<TetVertices> tets = model.tets.raw();
  for (TetVertices& tet : tets) std::sort(tet.begin(), tet.end());
  std::sort(tets.begin(), tets.end());
  return tets;
}

void try_model(std::string_view bytes, const std::string& name, const ReadOptions& options) {
  const auto read = parse_model(bytes, name, options);
  if (!fine(read)) return;
  for (const FormatInfo& format : formats()) {
    if (!format.reads.has(Contents::model) || !format.writes.has(Contents::model)) continue;
    for (const Encoding encoding : {Encoding::binary, Encoding::ascii, Encoding::compressed}) {
      const auto once = format_model(read->model, {encoding, std::string(format.name)});
      // Numbers of components may be larger than a format's.
      if (!once) {
        require_clean(once.error());
        continue;
      }
      const auto again = parse_model(once->bytes, "again");
      require(again.ok() && again->model.points == read->model.points &&
                  sorted_tets(again->model) == sorted_tets(read->model),
              "a model does not survive writing");
    }
  }
}

void try_points(std::string_view bytes, const std::string& name, const ReadOptions& options) {
  const auto read = parse_points(bytes, name, options);
  if (!fine(read)) return;
  for (const char* own : {"xyz", "bin"}) {
    const auto once = format_points(read->points, {.format = own});
    require(once.ok(), "points that were read cannot be written");
    const auto again = parse_points(once->bytes, "again", {.format = own});
    require(again.ok() && format_points(again->points, {.format = own})->bytes == once->bytes,
            "points do not survive writing");
  }
}

// Whatever a surface holds, slicing gives a valid stack or a clean error.
void try_triangles(std::string_view bytes, const std::string& name, const ReadOptions& options) {
  const auto read = parse_triangles(bytes, name, options);
  if (!fine(read)) return;
  const TriangleMesh& mesh = read->mesh;
  require(!mesh.triangles.empty(), "a surface without triangles");
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t v : triangle) require(v < mesh.points.size(), "a corner is no point");
  }
  for (const Point3& p : mesh.points) {
    require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z), "not finite");
  }
  SliceOptions slicing;
  slicing.planes = 1 + bytes.size() % 4;
  slicing.axis = static_cast<int>(bytes.size() % 3);
  slicing.execution.threads = 1;
  const auto sliced = slice(mesh, slicing);
  if (!sliced) return require_clean(sliced.error());
  require(validate(sliced->stack).ok(), "a mesh is sliced to a stack that is not valid");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view bytes = text_of(data + 1, size - 1);
  const FormatInfo& format = formats()[data[0] / 2 % formats().size()];
  // By name, or by what the contents and the extension tell.
  const bool named = data[0] % 2 == 0;
  const ReadOptions options{.format = named ? std::string(format.name) : std::string()};
  const std::string name = "fuzz" + std::string(format.extensions.front());
  if (!named || format.reads.has(Contents::stack)) try_stack(bytes, name, options);
  if (!named || format.reads.has(Contents::model)) try_model(bytes, name, options);
  if (!named || format.reads.has(Contents::points)) try_points(bytes, name, options);
  if (!named || format.reads.has(Contents::surface)) try_triangles(bytes, name, options);
  return 0;
}
