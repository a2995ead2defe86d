// write_solids FOLDER STACK: writes a few solids in every format of models, in every encoding, and
// what is in them as FOLDER/solids.json, for check_solids.py. Volumes and areas are computed here,
// tet by tet, without the library.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <tetloft/formats.hpp>
#include <tetloft/reconstruct.hpp>

namespace {

using namespace tetloft;

struct NamedSolid {
  std::string name;
  Model model;
};

// A box of cells, each of six tets around its diagonal, of one component.
void add_box(Model& model, ComponentId component, const Point3& corner, std::array<int, 3> cells) {
  const std::size_t first = model.points.size();
  for (int z = 0; z <= cells[2]; ++z) {
    for (int y = 0; y <= cells[1]; ++y) {
      for (int x = 0; x <= cells[0]; ++x) {
        model.points.push_back({corner.x + x, corner.y + 0.5 * y, corner.z + 0.25 * z});
        model.section.push_back(z % 2 == 0 ? SectionId(z / 2) : SectionId());
      }
    }
  }
  const auto vertex = [&](int x, int y, int z) {
    return VertexId(first +
                    static_cast<std::size_t>((z * (cells[1] + 1) + y) * (cells[0] + 1) + x));
  };
  constexpr std::array<std::array<int, 3>, 6> kOrders{
      {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
  for (int z = 0; z < cells[2]; ++z) {
    for (int y = 0; y < cells[1]; ++y) {
      for (int x = 0; x < cells[0]; ++x) {
        for (std::size_t i = 0; i < kOrders.size(); ++i) {
          std::array<int, 3> at{x, y, z};
          TetVertices tet;
          tet[0] = vertex(x, y, z);
          for (std::size_t k = 0; k < 3; ++k) {
            ++at[static_cast<std::size_t>(kOrders[i][k])];
            tet[k + 1] = vertex(at[0], at[1], at[2]);
          }
          if (i >= 3) std::swap(tet[2], tet[3]);  // an odd order
          model.tets.push_back(tet);
          model.component.push_back(component);
          model.slab.push_back(SlabId(z / 2));
          model.kind.push_back(static_cast<TetKind>(i));
        }
      }
    }
  }
}

Model two_boxes() {
  Model model;
  add_box(model, ComponentId(0), {0, 0, 0}, {3, 4, 5});
  add_box(model, ComponentId(1), {10, -1, 0.125}, {3, 3, 4});
  model.component_count = 2;
  model.component_names.push_back("left \"lung\", a/b");
  model.component_names.push_back("Gr\xC3\xBCnes Herz");
  model.about = {"thorax", "mm", "LPS"};
  return model;
}

// Half a turn about an axis that is none of the three, to another place.
Model placed_boxes() {
  Model model = two_boxes();
  model.frame = {{Point3{1.0 / 3, 2.0 / 3, 2.0 / 3}, Point3{2.0 / 3, 1.0 / 3, -2.0 / 3},
                  Point3{-2.0 / 3, 2.0 / 3, -1.0 / 3}},
                 {100, -20, 3}};
  return model;
}

double determinant(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const Point3 u{b.x - a.x, b.y - a.y, b.z - a.z};
  const Point3 v{c.x - a.x, c.y - a.y, c.z - a.z};
  const Point3 w{d.x - a.x, d.y - a.y, d.z - a.z};
  return u.x * (v.y * w.z - v.z * w.y) - u.y * (v.x * w.z - v.z * w.x) +
         u.z * (v.x * w.y - v.y * w.x);
}

double area(const Point3& a, const Point3& b, const Point3& c) {
  const Point3 u{b.x - a.x, b.y - a.y, b.z - a.z};
  const Point3 v{c.x - a.x, c.y - a.y, c.z - a.z};
  return std::hypot(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x) / 2;
}

struct Figures {
  std::size_t tets = 0;
  double volume = 0;
  std::size_t triangles = 0;
  double area = 0;
};

std::map<std::size_t, Figures> figures_of(const Model& model) {
  const auto at = [&](VertexId v) { return place(model.frame, model.points[v]); };
  std::map<std::size_t, Figures> figures;
  std::map<std::array<VertexId, 3>, std::vector<std::size_t>> owners;
  for (const TetId t : model.tets.ids()) {
    const TetVertices& tet = model.tets[t];
    Figures& of_component = figures[model.component[t].index()];
    ++of_component.tets;
    of_component.volume += determinant(at(tet[0]), at(tet[1]), at(tet[2]), at(tet[3])) / 6;
    for (std::size_t i = 0; i < 4; ++i) {
      std::array<VertexId, 3> face{tet[(i + 1) % 4], tet[(i + 2) % 4], tet[(i + 3) % 4]};
      std::sort(face.begin(), face.end());
      owners[face].push_back(model.component[t].index());
    }
  }
  for (const auto& [face, components] : owners) {
    if (components.size() != 1) continue;
    Figures& of_component = figures[components[0]];
    ++of_component.triangles;
    of_component.area += area(at(face[0]), at(face[1]), at(face[2]));
  }
  return figures;
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}

std::string number(double value) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.17g", value);
  return text.data();
}

std::string to_json(const Model& model) {
  Point3 low = place(model.frame, model.points[VertexId(0)]);
  Point3 high = low;
  for (const Point3& point : model.points) {
    const Point3 p = place(model.frame, point);
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  std::string text = "\"points\": " + std::to_string(model.points.size()) +
                     ", \"tets\": " + std::to_string(model.tets.size()) + ", \"box\": [";
  for (const double x : {low.x, low.y, low.z, high.x, high.y, high.z}) text += number(x) + ", ";
  text.resize(text.size() - 2);
  text += "], \"name\": " + quoted(model.about.name) + ", \"unit\": " + quoted(model.about.unit) +
          ", \"components\": [";
  for (const auto& [component, figures] : figures_of(model)) {
    text += "{\"name\": " + quoted(component_name(model, ComponentId(component))) +
            ", \"tets\": " + std::to_string(figures.tets) +
            ", \"volume\": " + number(figures.volume) +
            ", \"triangles\": " + std::to_string(figures.triangles) +
            ", \"area\": " + number(figures.area) + "}, ";
  }
  text.resize(text.size() - 2);
  return text + ']';
}

int fail(const std::string& message) {
  std::fputs((message + '\n').c_str(), stderr);
  return 1;
}

const char* name_of_encoding(Encoding encoding) {
  return encoding == Encoding::binary ? "binary" : encoding == Encoding::ascii ? "ascii" : "packed";
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return fail("usage: write_solids FOLDER STACK");
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  const auto stack = read_stack(argv[2]);
  if (!stack) return fail(to_string(stack.error()));
  const auto reconstruction = reconstruct(stack->stack, {});
  if (!reconstruction) return fail(to_string(reconstruction.error()));

  std::string json = "[\n";
  for (const NamedSolid& solid :
       {NamedSolid{"boxes", two_boxes()}, NamedSolid{"placed", placed_boxes()},
        NamedSolid{"reconstructed", reconstruction->model}}) {
    for (const FormatInfo& format : formats()) {
      if (!format.writes.has(Contents::model)) continue;
      for (const Encoding encoding : {Encoding::binary, Encoding::ascii, Encoding::compressed}) {
        const std::string file =
            solid.name + '_' + name_of_encoding(encoding) + std::string(format.extensions.front());
        const auto written = write_model((folder / file).string(), solid.model,
                                         {encoding, std::string(format.name)});
        if (!written) return fail(to_string(written.error()));
        json += "{\"file\": " + quoted((folder / file).string()) +
                ", \"format\": " + quoted(std::string(format.name)) + ", " + to_json(solid.model) +
                "},\n";
      }
    }
  }
  json.resize(json.size() - 2);
  const auto told = write_file((folder / "solids.json").string(), json + "\n]\n");
  return told ? 0 : fail(to_string(told.error()));
}
