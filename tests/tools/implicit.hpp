// Stacks of implicit solids, for the programs that make the files of data/.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <tetloft/sections.hpp>

#include "support/stacks/shapes.hpp"

namespace tetloft::testing {

/// Positive inside.
using Field = std::function<double(Point2 p)>;

/// Rounded to thousandths: that keeps files short, and the same whatever the last bits of a
/// mathematical library are.
[[nodiscard]] double rounded(double x);

/// The outlines of field > 0 in [−size, size]², traced on a grid of the given step.
[[nodiscard]] Layer level_set(const Field& field, double size, double step);

/// A disc of a cross section. Radius 0: absent.
struct Lobe {
  Point2 centre;
  double radius = 0;
};

/// Union of discs, blended: positive inside, about the distance in radii.
[[nodiscard]] double blended(const std::vector<Lobe>& lobes, Point2 p);
[[nodiscard]] Layer sections_of(const std::vector<Lobe>& lobes, double size, double step);

/// Smooth from 0 at `from` to 1 at `to`.
[[nodiscard]] double ramp(double z, double from, double to);
/// The radius of a rounded end: 0 at `tip`, 1 from `tip` + `length` on.
[[nodiscard]] double rounded_end(double z, double tip, double length);

[[nodiscard]] Point2 on_circle(double radius, double degrees);

/// Validates and writes FOLDER/NAME; says on standard error why not.
[[nodiscard]] bool write_sample(const std::string& folder, const char* name,
                                const SectionStack& stack);

}  // namespace tetloft::testing
