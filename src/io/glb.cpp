// Surfaces as .glb (Khronos Group, glTF 2.0, section 4: GLB): JSON, and the arrays that it names.
//
// Coordinates there are float32, in metres, y upwards. A component is a node: its translation, the
// middle of its box, takes what coordinates have in common, so that the float32 of its mesh have
// their digits for what is left. One node above all of them turns z upwards into y upwards and
// scales the model's unit to metres; coordinates below it are the model's.
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/little_endian.hpp"
#include "io/description_texts.hpp"
#include "io/float32.hpp"
#include "io/format.hpp"
#include "io/json_write.hpp"
#include "io/length_unit.hpp"
#include "model/component_colour.hpp"
#include "model/corner_normals.hpp"

namespace tetloft::internal::io {

namespace {

// Sections 3.6.2.2 (component types) and 5.11.5 (targets of buffer views).
constexpr int kFloat = 5126;
constexpr int kUnsignedInt = 5125;
constexpr int kArrayBuffer = 34962;
constexpr int kElementArrayBuffer = 34963;

// Section 4.4.
constexpr std::uint32_t kGlbMagic = 0x46546C67;
constexpr std::uint32_t kGlbVersion = 2;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinaryChunk = 0x004E4942;
constexpr std::uint64_t kGlbHeadBytes = 12;
constexpr std::uint64_t kChunkHeadBytes = 8;

constexpr std::uint64_t kVertexBytes = 3 * sizeof(float);
constexpr std::uint64_t kTriangleBytes = 3 * sizeof(std::uint32_t);

// The mesh of a component. A vertex is there once for each normal that it has: along creases twice
// or more.
struct GlbMesh {
  FloatPoint translation{};
  std::vector<FloatPoint> position;  // less the translation
  std::vector<FloatPoint> normal;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  FloatPoint low{}, high{};  // of the positions

  [[nodiscard]] std::uint64_t bytes() const {
    return position.size() * 2 * kVertexBytes + triangles.size() * kTriangleBytes;
  }
};

// Half of each side first: a sum could be beyond double.
FloatPoint middle_of(const std::vector<Point3>& points) {
  Point3 low = points.front();
  Point3 high = low;
  for (const Point3& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return float_point({low.x / 2 + high.x / 2, low.y / 2 + high.y / 2, low.z / 2 + high.z / 2});
}

std::vector<FloatPoint> moved_points(const std::vector<Point3>& points, const FloatPoint& origin) {
  std::vector<FloatPoint> moved;
  moved.reserve(points.size());
  for (const Point3& p : points) {
    moved.push_back(
        float_point({p.x - static_cast<double>(origin[0]), p.y - static_cast<double>(origin[1]),
                     p.z - static_cast<double>(origin[2])}));
  }
  return moved;
}

// Normals that differ by less than about this many of their length are one: they are sums of the
// same terms in different orders.
constexpr double kNormalSteps = 1024;

void add_corners(GlbMesh& made, const PartMesh& own, const std::vector<Point3>& points,
                 const std::vector<FloatPoint>& positions) {
  const auto normals = corner_normals(points, own.triangles);
  const auto step = [](double c) {
    return static_cast<std::int16_t>(std::lround(kNormalSteps * c));
  };
  using Key = std::pair<std::uint32_t, std::array<std::int16_t, 3>>;
  std::map<Key, std::uint32_t> number;
  for (std::size_t k = 0; k < own.triangles.size(); ++k) {
    auto& corners = made.triangles.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t v = own.triangles[k][i];
      const Point3& n = normals[k][i];
      const auto next = static_cast<std::uint32_t>(made.position.size());
      const auto [at, is_new] = number.try_emplace({v, {step(n.x), step(n.y), step(n.z)}}, next);
      corners[i] = at->second;
      if (!is_new) continue;
      made.position.push_back(positions[v]);
      made.normal.push_back(float_point(n));
    }
  }
}

GlbMesh glb_mesh(const SurfaceMesh& mesh, const SurfacePart& part, Float32Loss& loss) {
  const PartMesh own = part_mesh(mesh, part);
  std::vector<Point3> points;
  points.reserve(own.vertex.size());
  for (const std::uint32_t v : own.vertex) points.push_back(mesh.points[v]);
  GlbMesh made;
  made.translation = middle_of(points);
  const std::vector<FloatPoint> positions = moved_points(points, made.translation);
  loss.add(points, own.triangles, positions);
  add_corners(made, own, points, positions);
  made.low = made.high = made.position.front();
  for (const FloatPoint& p : made.position) {
    for (std::size_t i = 0; i < 3; ++i) {
      made.low[i] = std::min(made.low[i], p[i]);
      made.high[i] = std::max(made.high[i], p[i]);
    }
  }
  return made;
}

// Colours of files are sRGB's, factors of materials linear (IEC 61966-2-1). Digits that no eye
// needs are left out: powers may differ in their last ones between libraries.
double linear(std::uint8_t value) {
  const double c = value / 255.0;
  const double exact = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  return static_cast<double>(std::lround(exact * 1e4)) / 1e4;
}

void numbers(JsonWriter& json, const char* name, std::initializer_list<double> values) {
  json.key(name);
  json.begin_array();
  for (const double value : values) json.value(value);
  json.end_array();
}

void triple(JsonWriter& json, const char* name, const FloatPoint& p) {
  numbers(json, name,
          {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])});
}

// The document, by its lists; those of a file without components are left out, as the schema asks.
class GlbDocument {
 public:
  GlbDocument(const Description& about, const std::vector<SurfacePart>& parts,
              const std::vector<GlbMesh>& meshes)
      : about_(about), parts_(parts), meshes_(meshes) {}

  std::string text(std::uint64_t buffer_bytes) {
    json_.begin_object();
    json_.key("asset");
    json_.begin_object();
    json_.member("version", "2.0");
    json_.member("generator", "tetloft");
    json_.end_object();
    json_.member("scene", 0);
    json_.key("scenes");
    json_.begin_array();
    json_.begin_object();
    json_.key("nodes");
    json_.begin_array();
    json_.value(0);
    json_.end_array();
    json_.end_object();
    json_.end_array();
    nodes();
    if (!parts_.empty()) {
      list("meshes", [this](std::size_t k) { mesh(k); });
      list("materials", [this](std::size_t k) { material(k); });
      list("accessors", [this](std::size_t k) { accessors(k); });
      list("bufferViews", [this](std::size_t k) { views(k); });
      json_.key("buffers");
      json_.begin_array();
      json_.begin_object();
      json_.member("byteLength", buffer_bytes);
      json_.end_object();
      json_.end_array();
    }
    json_.end_object();
    return json_.text();
  }

 private:
  template <class Each>
  void list(const char* name, const Each& each) {
    json_.key(name);
    json_.begin_array();
    for (std::size_t k = 0; k < parts_.size(); ++k) each(k);
    json_.end_array();
  }

  // Node 0 above the others: a quarter turn about x, which is exact in no other form.
  void nodes() {
    json_.key("nodes");
    json_.begin_array();
    json_.begin_object();
    json_.member("name", about_.name.empty() ? std::string("model") : about_.name);
    const double half = std::sqrt(0.5);
    numbers(json_, "rotation", {-half, 0, 0, half});
    const double metres = metres_in(about_.unit).value_or(1);
    if (metres != 1) numbers(json_, "scale", {metres, metres, metres});
    if (!parts_.empty()) {
      json_.key("children");
      json_.begin_array();
      for (std::size_t k = 0; k < parts_.size(); ++k) json_.value(k + 1);
      json_.end_array();
    }
    extras();
    json_.end_object();
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      json_.begin_object();
      json_.member("name", parts_[k].name);
      json_.member("mesh", k);
      triple(json_, "translation", meshes_[k].translation);
      json_.end_object();
    }
    json_.end_array();
  }

  void extras() {
    if (about_ == Description()) return;
    json_.key("extras");
    json_.begin_object();
    for (const auto& [name, text] : kDescriptionTexts) {
      const std::string& value = about_.*text;
      if (!value.empty()) json_.member(name, value);
    }
    json_.end_object();
  }

  void mesh(std::size_t k) {
    json_.begin_object();
    json_.member("name", parts_[k].name);
    json_.key("primitives");
    json_.begin_array();
    json_.begin_object();
    json_.key("attributes");
    json_.begin_object();
    json_.member("POSITION", 3 * k);
    json_.member("NORMAL", 3 * k + 1);
    json_.end_object();
    json_.member("indices", 3 * k + 2);
    json_.member("material", k);
    json_.end_object();
    json_.end_array();
    json_.end_object();
  }

  void material(std::size_t k) {
    const Rgb colour = component_colour(parts_[k].component.index());
    json_.begin_object();
    json_.member("name", parts_[k].name);
    json_.key("pbrMetallicRoughness");
    json_.begin_object();
    numbers(json_, "baseColorFactor", {linear(colour.r), linear(colour.g), linear(colour.b), 1});
    json_.member("metallicFactor", 0);
    json_.member("roughnessFactor", 0.8);
    json_.end_object();
    json_.end_object();
  }

  void accessors(std::size_t k) {
    const GlbMesh& made = meshes_[k];
    accessor(3 * k, kFloat, "VEC3", made.position.size(), &made);
    accessor(3 * k + 1, kFloat, "VEC3", made.normal.size());
    accessor(3 * k + 2, kUnsignedInt, "SCALAR", 3 * made.triangles.size());
  }

  void accessor(std::size_t view, int component, const char* type, std::size_t count,
                const GlbMesh* bounded = nullptr) {
    json_.begin_object();
    json_.member("bufferView", view);
    json_.member("componentType", component);
    json_.member("type", type);
    json_.member("count", count);
    if (bounded != nullptr) {
      triple(json_, "min", bounded->low);
      triple(json_, "max", bounded->high);
    }
    json_.end_object();
  }

  void views(std::size_t k) {
    view(meshes_[k].position.size() * kVertexBytes, kArrayBuffer);
    view(meshes_[k].normal.size() * kVertexBytes, kArrayBuffer);
    view(meshes_[k].triangles.size() * kTriangleBytes, kElementArrayBuffer);
  }

  void view(std::uint64_t bytes, int target) {
    json_.begin_object();
    json_.member("buffer", 0);
    json_.member("byteOffset", offset_);
    json_.member("byteLength", bytes);
    json_.member("target", target);
    json_.end_object();
    offset_ += bytes;
  }

  const Description& about_;
  const std::vector<SurfacePart>& parts_;
  const std::vector<GlbMesh>& meshes_;
  JsonWriter json_;
  std::uint64_t offset_ = 0;
};

template <class T>
void append_triples(Pieces& pieces, const std::vector<std::array<T, 3>>& triples) {
  for (const auto& all : triples) {
    for (const T value : all) append_little(pieces.text(), value);
    pieces.next();
  }
}

void append_chunk_head(std::string& text, std::uint64_t bytes, std::uint32_t type) {
  append_little(text, static_cast<std::uint32_t>(bytes));
  append_little(text, type);
}

void append_glb(Sink& sink, const std::string& document, const std::vector<GlbMesh>& meshes,
                std::uint64_t buffer_bytes, std::uint64_t file_bytes) {
  Pieces pieces(sink);
  std::string& text = pieces.text();
  append_little(text, kGlbMagic);
  append_little(text, kGlbVersion);
  append_little(text, static_cast<std::uint32_t>(file_bytes));
  append_chunk_head(text, document.size(), kJsonChunk);
  text += document;
  if (!meshes.empty()) append_chunk_head(text, buffer_bytes, kBinaryChunk);
  for (const GlbMesh& made : meshes) {
    append_triples(pieces, made.position);
    append_triples(pieces, made.normal);
    append_triples(pieces, made.triangles);
  }
  pieces.finish();
}

Result<void> check_glb_bytes(std::uint64_t bytes) {
  if (bytes <= std::numeric_limits<std::uint32_t>::max()) return {};
  return Error{ErrorCode::invalid_input, "a binary glTF file of 4 GiB or more", {}};
}

Written write_glb(Sink& sink, const SurfaceMesh& mesh, const Model& model,
                  const Target& /*target*/) {
  if (const auto error = beyond_float32(mesh.points, "glTF")) return *error;
  if (Result<void> fits = check_glb_bytes(mesh.triangles.size() * kTriangleBytes); !fits) {
    return fits.error();
  }
  const std::vector<SurfacePart> parts = surface_parts(mesh, model);
  Float32Loss loss("glTF");
  std::vector<GlbMesh> meshes;
  std::uint64_t buffer_bytes = 0;
  for (const SurfacePart& part : parts) {
    meshes.push_back(glb_mesh(mesh, part, loss));
    buffer_bytes += meshes.back().bytes();
  }
  std::string document = GlbDocument(model.about, parts, meshes).text(buffer_bytes);
  document.resize((document.size() + 3) / 4 * 4, ' ');  // chunks are of whole words
  const std::uint64_t file_bytes = kGlbHeadBytes + kChunkHeadBytes + document.size() +
                                   (parts.empty() ? 0 : kChunkHeadBytes + buffer_bytes);
  if (Result<void> fits = check_glb_bytes(file_bytes); !fits) return fits.error();
  append_glb(sink, document, meshes, buffer_bytes, file_bytes);
  return loss.warnings();
}

}  // namespace

extern constinit const Format glb_format{.name = "glb",
                                         .summary = "binary glTF, float32",
                                         .extensions = {".glb"},
                                         .write_surface = write_glb};

}  // namespace tetloft::internal::io
