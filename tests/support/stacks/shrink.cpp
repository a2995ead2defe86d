#include "support/stacks/shrink.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include <tetloft/io.hpp>

namespace tetloft::testing {
namespace {

GeneratedStack without_section(const GeneratedStack& from, SectionId removed) {
  GeneratedStack result = from;
  auto& sections = result.stack.sections.raw();
  sections.erase(sections.begin() + static_cast<std::ptrdiff_t>(removed.index()));
  std::vector<Label> labels;
  for (Label label : result.correspondence.labels) {
    if (label.section == removed) continue;
    if (label.section > removed) label.section = SectionId(label.section.value() - 1);
    labels.push_back(label);
  }
  result.correspondence.labels = std::move(labels);
  return result;
}

GeneratedStack without_contour(const GeneratedStack& from, SectionId section, ContourId removed) {
  GeneratedStack result = from;
  auto& contours = result.stack.sections[section].contours.raw();
  contours.erase(contours.begin() + static_cast<std::ptrdiff_t>(removed.index()));
  std::vector<Label> labels;
  for (Label label : result.correspondence.labels) {
    if (label.section == section) {
      if (label.contour == removed) continue;
      if (label.contour > removed) label.contour = ContourId(label.contour.value() - 1);
    }
    labels.push_back(label);
  }
  result.correspondence.labels = std::move(labels);
  return result;
}

double largest_coordinate(const SectionStack& stack) {
  double largest = 0;
  for (const Section& section : stack.sections) {
    for (const Contour& contour : section.contours) {
      for (const Point2& p : contour.vertices) {
        largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
      }
    }
  }
  return largest;
}

class Shrinker {
 public:
  Shrinker(const GeneratedStack& failing,
           const std::function<bool(const GeneratedStack&)>& still_fails, ShrinkLimits limits)
      : best_(failing), still_fails_(still_fails), trials_left_(limits.trials) {}

  GeneratedStack run() {
    do {
      changed_ = false;
      remove_sections();
      remove_contours();
      remove_labels();
      remove_vertices();
      tidy_heights();
      round_all();
      round_each();
    } while (changed_ && trials_left_ > 0);
    return std::move(best_);
  }

 private:
  // Keeps the candidate if it is valid and fails like the one before.
  bool accept(GeneratedStack candidate) {
    if (trials_left_ == 0 || !validate(candidate.stack)) return false;
    --trials_left_;
    if (!still_fails_(candidate)) return false;
    best_ = std::move(candidate);
    changed_ = true;
    return true;
  }

  void remove_sections() {
    for (std::size_t i = best_.stack.sections.size(); i-- > 0;) {
      if (best_.stack.sections.size() > 1) accept(without_section(best_, SectionId(i)));
    }
  }

  void remove_contours() {
    for (std::size_t s = 0; s < best_.stack.sections.size(); ++s) {
      for (std::size_t c = best_.stack.sections[SectionId(s)].contours.size(); c-- > 0;) {
        accept(without_contour(best_, SectionId(s), ContourId(c)));
      }
    }
  }

  void remove_labels() {
    for (std::size_t i = best_.correspondence.labels.size(); i-- > 0;) {
      GeneratedStack candidate = best_;
      auto& labels = candidate.correspondence.labels;
      labels.erase(labels.begin() + static_cast<std::ptrdiff_t>(i));
      accept(std::move(candidate));
    }
  }

  // Runs of half the contour first, single vertices last.
  void remove_vertices() {
    for (std::size_t s = 0; s < best_.stack.sections.size(); ++s) {
      for (std::size_t c = 0; c < best_.stack.sections[SectionId(s)].contours.size(); ++c) {
        for (std::size_t run = vertices(best_, s, c).size() / 2; run > 0; run /= 2) {
          remove_runs(s, c, run);
        }
      }
    }
  }

  void remove_runs(std::size_t s, std::size_t c, std::size_t run) {
    for (std::size_t first = 0; first + run <= vertices(best_, s, c).size();) {
      if (vertices(best_, s, c).size() < run + 3) return;
      GeneratedStack candidate = best_;
      auto& from = vertices(candidate, s, c);
      const auto begin = from.begin() + static_cast<std::ptrdiff_t>(first);
      from.erase(begin, begin + static_cast<std::ptrdiff_t>(run));
      if (!accept(std::move(candidate))) first += run;
    }
  }

  // Heights 0, 1, 2, ….
  void tidy_heights() {
    GeneratedStack candidate = best_;
    double z = 0;
    bool tidy = true;
    for (Section& section : candidate.stack.sections) {
      tidy = tidy && section.z == z;
      section.z = z++;
    }
    if (!tidy) accept(std::move(candidate));
  }

  // All coordinates to one lattice, the coarsest that still fails.
  void round_all() {
    const double largest = largest_coordinate(best_.stack);
    if (largest == 0) return;
    const int exponent = std::ilogb(largest);
    for (int bits = 1; bits <= 24; ++bits) {
      const double lattice = std::ldexp(1, exponent - bits);
      GeneratedStack candidate = best_;
      bool moved = false;
      for (Section& section : candidate.stack.sections) {
        for (Contour& contour : section.contours) {
          for (Point2& p : contour.vertices) moved = round_to(p, lattice) || moved;
        }
      }
      if (!moved || accept(std::move(candidate))) return;
    }
  }

  // Each vertex to the coarsest lattice on which it still fails.
  void round_each() {
    const double largest = largest_coordinate(best_.stack);
    if (largest == 0) return;
    const int exponent = std::ilogb(largest);
    for (std::size_t s = 0; s < best_.stack.sections.size(); ++s) {
      for (std::size_t c = 0; c < best_.stack.sections[SectionId(s)].contours.size(); ++c) {
        for (std::size_t v = 0; v < vertices(best_, s, c).size(); ++v) {
          for (const int bits : kVertexBits) {
            GeneratedStack candidate = best_;
            const double lattice = std::ldexp(1, exponent - bits);
            if (!round_to(vertices(candidate, s, c)[v], lattice)) break;
            if (accept(std::move(candidate))) break;
          }
        }
      }
    }
  }

  static bool round_to(Point2& p, double lattice) {
    const Point2 rounded{std::round(p.x / lattice) * lattice, std::round(p.y / lattice) * lattice};
    if (!std::isfinite(rounded.x) || !std::isfinite(rounded.y) || rounded == p) return false;
    p = rounded;
    return true;
  }

  static std::vector<Point2>& vertices(GeneratedStack& stack, std::size_t s, std::size_t c) {
    return stack.stack.sections[SectionId(s)].contours[ContourId(c)].vertices;
  }

  static constexpr std::array<int, 4> kVertexBits{3, 6, 12, 20};

  GeneratedStack best_;
  const std::function<bool(const GeneratedStack&)>& still_fails_;
  std::size_t trials_left_;
  bool changed_ = false;
};

}  // namespace

GeneratedStack shrink(const GeneratedStack& failing,
                      const std::function<bool(const GeneratedStack&)>& still_fails,
                      ShrinkLimits limits) {
  return Shrinker(failing, still_fails, limits).run();
}

SectionStack shrink(const SectionStack& failing,
                    const std::function<bool(const SectionStack&)>& still_fails,
                    ShrinkLimits limits) {
  GeneratedStack generated;
  generated.stack = failing;
  return shrink(
             generated, [&](const GeneratedStack& g) { return still_fails(g.stack); }, limits)
      .stack;
}

Result<void> write_stack(const std::string& folder, const std::string& name,
                         const GeneratedStack& generated) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) {
    Error error{ErrorCode::io, failed.message(), {}};
    error.where.file = folder;
    return error;
  }
  const std::string path = folder + "/" + name;
  const Result<void> written = write_cnt(path + ".cnt", generated.stack);
  if (!written || generated.correspondence.labels.empty()) return written;
  std::string text = "# section contour label\n";
  for (const Label& label : generated.correspondence.labels) {
    text += std::to_string(label.section.value()) + " " + std::to_string(label.contour.value()) +
            " " + std::to_string(label.label) + "\n";
  }
  return write_file(path + ".labels", text);
}

}  // namespace tetloft::testing
