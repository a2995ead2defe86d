// The figures of Nonato et al. (2000), by their method and by Geiger's: pictures, pages to turn the
// models in, and a table.
//
//   tetloft_figures FOLDER [--data DATA] [--only WORD]
//
// Writes FOLDER/figures.md and for each figure and method a .png and an .html.
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <tetloft/tetloft.hpp>

#include "comparison/metrics.hpp"
#include "comparison/section_cut.hpp"
#include "words.hpp"

namespace {

using namespace tetloft;
using namespace tetloft::bench;

struct Figure {
  std::string number;   ///< of the paper
  std::string subject;  ///< what it shows
  std::string stack;    ///< below data/
  RenderOptions view;
  std::vector<Label> labels;
};

RenderOptions seen_from(double azimuth, double elevation) {
  RenderOptions view;
  view.azimuth = azimuth;
  view.elevation = elevation;
  view.width = 560;
  view.height = 420;
  return view;
}

RenderOptions cut_open(RenderOptions view, int axis, double position) {
  view.cut = PictureCut{axis, position};
  return view;
}

RenderOptions stretched(RenderOptions view, double times) {
  view.stretch = times;
  return view;
}

std::vector<Figure> all_figures() {
  const auto label = [](std::size_t section, std::size_t contour) {
    return Label{SectionId(section), ContourId(contour), 1};
  };
  return {
      {"1",
       "which contours belong together",
       "figures/fig01_correspondence",
       seen_from(-70, 35),
       {}},
      {"6", "crossing skeletons, reverse tets", "figures/fig06_reverse", seen_from(-60, 35), {}},
      {"9", "one contour below three", "figures/fig09_subdivision", seen_from(-60, 40), {}},
      {"11a", "ring on legs, with handles", "figures/fig11a_complex", seen_from(-65, 25), {}},
      {"11b", "terrain", "terrain", stretched(seen_from(-60, 40), 3), {}},
      {"11c", "vertebra", "figures/fig11c_vertebra", seen_from(-125, 35), {}},
      {"11d",
       "lungs with airway, cut open",
       "figures/fig11d_lungs",
       cut_open(seen_from(-75, 20), 1, -0.05),
       {}},
      {"15", "bifurcation", "figures/fig15_bifurcation", seen_from(-60, 40), {}},
      {"16", "bifurcation on both sides", "figures/fig16_double_sided", seen_from(-65, 50), {}},
      {"17", "branches of branches", "figures/fig17_branches", seen_from(-60, 30), {}},
      {"18", "a branch drifts: little overlap", "figures/fig18_drifting", seen_from(-60, 40), {}},
      {"18", "a branch has drifted: none", "figures/fig19_drifted", seen_from(-60, 40), {}},
      {"19",
       "labels bring it back",
       "figures/fig19_drifted",
       seen_from(-60, 40),
       {label(0, 0), label(1, 0), label(1, 1)}},
      {"20", "isolated contour", "figures/fig20_isolated", seen_from(-60, 30), {}},
      {"21", "tooth with its pulp, cut open", "tooth", cut_open(seen_from(-60, 20), 1, 0.05), {}},
      {"22",
       "thorax: wall, lungs, heart, cut open",
       "figures/fig22_thorax",
       cut_open(seen_from(-70, 30), 1, -0.3),
       {}},
  };
}

Method with_labels(const std::vector<Label>& labels) {
  CorrespondenceOptions correspondence;
  correspondence.labels = labels;
  return tetloft_by("tetloft", correspondence);
}

// Sections that the solid's cut differs from by more than rounding.
std::size_t violated_sections(const bench::TriangleMesh& surface, const SectionStack& stack) {
  constexpr double kRounding = 1e-9;
  std::size_t violated = 0;
  for (const Section& section : stack.sections) {
    SectionStack one;
    one.sections.push_back(section);
    if (section_deviation(surface, one) > kRounding) ++violated;
  }
  return violated;
}

class Book {
 public:
  Book(std::filesystem::path data, std::filesystem::path folder)
      : data_(std::move(data)), folder_(std::move(folder)) {}

  // False where a file cannot be read or written.
  bool add(const Figure& figure) {
    const auto path = (data_ / (figure.stack + ".cnt")).string();
    const auto input = read_cnt(path);
    if (!input) return complain(to_string(input.error()));
    text_ += "\n## Figure " + figure.number + ": " + figure.subject + "\n\n`" + figure.stack +
             ".cnt`, " + std::to_string(input->stack.sections.size()) + " sections, " +
             std::to_string(input->stack.contour_count()) + " contours\n\n";
    ++count_;
    std::string pictures;
    for (const Method& method : {with_labels(figure.labels), geiger()}) {
      if (!draw(figure, method, input->stack, pictures)) return false;
    }
    text_ += pictures + '\n';
    return true;
  }

  bool write() {
    const std::string head =
        "# The figures of the paper\n\n"
        "| Fig. | subject | method | guarantees 1 2 3 4 5 | singular vertices, edges | sections "
        "violated | components | genus | contours lost | tets | ms |\n"
        "|---|---|---|---|---|---|---|---|---|---|---|\n";
    const auto written = write_file((folder_ / "figures.md").string(), head + table_ + text_);
    return written ? true : complain(to_string(written.error()));
  }

 private:
  static bool complain(const std::string& what) {
    std::fprintf(stderr, "error: %s\n", what.c_str());
    return false;
  }

  bool draw(const Figure& figure, const Method& method, const SectionStack& stack,
            std::string& pictures) {
    Subject subject;
    subject.stack = stack;
    const Run run = measure_run(method, subject, Reference(Truth{}), 0);
    const std::string start = "| " + figure.number + " | " + figure.subject + " | " + method.name;
    if (!run.refusal.empty()) {
      table_ += start + " | refused: " + run.refusal + " |||||||||\n";
      return true;
    }
    const Outcome outcome = method.run(stack);
    const Model& model = *outcome.model;
    const auto mesh = TetMesh::from_tets(model.points.size(), model.tets.raw());
    if (!mesh) return complain(to_string(mesh.error()));
    const auto verdict = [&](std::size_t k) { return run.guarantees && (*run.guarantees)[k]; };
    table_ += start + " |";
    for (std::size_t k = 0; k < 5; ++k) table_ += verdict(k) ? " ✓" : " ✗";
    char rest[160];
    std::snprintf(rest, sizeof rest, " | %zu, %zu | %zu | %ld | %ld | %zu | %zu | %.1f |\n",
                  run.singular_vertices, run.singular_edges,
                  violated_sections(boundary_of(*mesh, model.points), stack),
                  run.topology.components, run.topology.genus, run.lost, model.tets.size(),
                  1000 * run.seconds);
    table_ += rest;

    RenderOptions view = figure.view;
    view.white = true;
    view.title = "Figure " + figure.number + ", " + method.name;
    char name[64];
    std::snprintf(name, sizeof name, "%02zu_fig%s_%s", count_, figure.number.c_str(),
                  method.name.c_str());
    const auto png = render_png(model, &stack, view);
    if (view.cut && view.cut->axis != 2) view.cut.reset();
    const auto page = render_html(model, &stack, view);
    if (!png || !page) return complain(to_string((png ? page : png).error()));
    for (const auto& [extension, bytes] : {std::pair{".png", &*png}, std::pair{".html", &*page}}) {
      const auto written = write_file((folder_ / (name + std::string(extension))).string(), *bytes);
      if (!written) return complain(to_string(written.error()));
    }
    pictures += "[![" + method.name + "](" + name + ".png)](" + name + ".html)\n";
    return true;
  }

  std::filesystem::path data_, folder_;
  std::size_t count_ = 0;
  std::string table_, text_;
};

constexpr const char* kUsage = "usage: tetloft_figures FOLDER [--data DATA] [--only WORD]\n";

}  // namespace

int main(int argc, char** argv) {
  std::string data = TETLOFT_DATA_DIR;
  std::string only;
  std::string folder;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--data" && i + 1 < argc) {
      data = argv[++i];
    } else if (word == "--only" && i + 1 < argc) {
      only = argv[++i];
    } else if (folder.empty() && !word.starts_with("--")) {
      folder = word;
    } else {
      return usage_failure("no use for " + word, kUsage);
    }
  }
  if (folder.empty()) return usage_failure("missing FOLDER", kUsage);
  const std::vector<Figure> figures = all_figures();
  std::vector<std::string> stacks;
  for (const Figure& figure : figures) stacks.push_back(figure.stack);
  if (!any_has(stacks, only)) return usage_failure(no_such("--only", only, stacks), kUsage);
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  Book book(data, folder);
  for (const Figure& figure : figures) {
    if (figure.stack.find(only) == std::string::npos) continue;
    std::fprintf(stderr, "figure %s\n", figure.number.c_str());
    if (!book.add(figure)) return 4;
  }
  return book.write() ? 0 : 4;
}
