// thin_stack IN.cnt OUT.cnt EVERY SHORTEST: keeps every EVERY-th section, and of it the
// contours at least SHORTEST long, with all that lies inside a shorter one left out.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <tetloft/io.hpp>
#include <tetloft/nesting.hpp>

namespace {

using namespace tetloft;

double length(const Contour& contour) {
  double sum = 0;
  for (std::size_t i = 0; i < contour.vertices.size(); ++i) {
    const Point2& p = contour.vertices[i];
    const Point2& q = contour.vertices[(i + 1) % contour.vertices.size()];
    sum += std::hypot(q.x - p.x, q.y - p.y);
  }
  return sum;
}

// A contour inside one that is left out would change sides.
bool is_kept(const Section& section, const Nesting& nesting, ContourId contour, double shortest) {
  for (ContourId c = contour; c.valid(); c = nesting.parent[c]) {
    if (length(section.contours[c]) < shortest) return false;
  }
  return true;
}

SectionStack thin(const SectionStack& stack, std::size_t every, double shortest) {
  SectionStack result;
  for (std::size_t s = 0; s < stack.sections.size(); s += every) {
    const Section& section = stack.sections[SectionId(s)];
    const Nesting nesting = nest(section);
    Section kept{section.z, {}};
    for (std::size_t c = 0; c < section.contours.size(); ++c) {
      if (is_kept(section, nesting, ContourId(c), shortest)) {
        kept.contours.push_back(section.contours[ContourId(c)]);
      }
    }
    result.sections.push_back(std::move(kept));
  }
  return result;
}

}  // namespace

int main(int argc, char** argv) {
  const long every = argc == 5 ? std::atol(argv[3]) : 0;
  if (every < 1) {
    std::fputs("usage: thin_stack IN.cnt OUT.cnt EVERY SHORTEST\n", stderr);
    return 2;
  }
  const Result<ReadStack> read = read_cnt(argv[1]);
  if (!read) {
    std::fprintf(stderr, "%s\n", to_string(read.error()).c_str());
    return 3;
  }
  const SectionStack thinned =
      thin(read->stack, static_cast<std::size_t>(every), std::strtod(argv[4], nullptr));
  return write_cnt(argv[2], thinned) ? 0 : 4;
}
