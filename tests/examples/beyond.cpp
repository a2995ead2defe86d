// A solid larger than memory, of sections that are made as they are asked for: in one go, and in
// pieces, which any machines may build.
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include <tetloft/tetloft.hpp>

namespace {

constexpr std::size_t kSections = 301;

class Tube : public tetloft::SectionStream {
 public:
  tetloft::Result<std::optional<tetloft::Section>> next() override {
    if (made_ == kSections) return std::optional<tetloft::Section>();
    const auto z = static_cast<double>(made_++);
    tetloft::Contour contour;
    for (int k = 0; k < 60; ++k) {
      const double angle = k * std::acos(-1.0) / 30;
      contour.vertices.push_back(
          {4 * std::sin(z / 9) + 10 * std::cos(angle), 10 * std::sin(angle)});
    }
    tetloft::Section section{z, {}};
    section.contours.push_back(contour);
    return std::optional(section);
  }

 private:
  std::size_t made_ = 0;
};

int failed(const tetloft::Error& error) {
  std::fprintf(stderr, "%s\n", to_string(error).c_str());
  return 5;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string folder = argc > 1 ? argv[1] : ".";
  Tube streamed;
  const auto whole = tetloft::write_streamed(folder + "/whole.vtu", streamed);
  if (!whole) return failed(whole.error());

  const std::string plan = folder + "/tube.plan";
  Tube planned;
  const auto written = tetloft::write_plan(plan, planned);
  if (!written) return failed(written.error());
  std::vector<std::string> pieces;
  for (std::size_t slab = 0; slab + 1 < kSections; slab += 100) {
    pieces.push_back(folder + "/from_" + std::to_string(slab) + ".vtu");
    const auto piece = tetloft::write_piece(pieces.back(), plan, slab, slab + 100);
    if (!piece) return failed(piece.error());
  }
  const auto joined = tetloft::write_joined(folder + "/joined.vtu", pieces, {.plan = plan});
  if (!joined) return failed(joined.error());
  const bool same = whole->report.tets == joined->report.tets;
  std::printf("%zu tets, %s from %zu pieces\n", whole->report.tets, same ? "as many" : "others",
              pieces.size());
  return same ? 0 : 1;
}
