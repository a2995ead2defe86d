// Sizes, kinds, directions.
#include "io/volume/nrrd_axes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "core/text.hpp"
#include "io/numbers.hpp"
#include "io/volume/file_volume.hpp"
#include "io/volume/header_text.hpp"
#include "io/volume/placement.hpp"

namespace tetloft::internal::io {

namespace {

using Vector = std::array<double, 3>;

struct NrrdAxis {
  std::uint64_t size = 0;
  bool spatial = false;
  std::optional<Vector> direction;
  std::size_t number = 0;  ///< in the file
};

Result<double> number_of(const NrrdHeader& nrrd, const std::string& field, std::string_view word) {
  const ParsedNumber number = parse_number(word);
  if (number.ok()) return number.value;
  return nrrd.complain(field, complaint(word, number.status));
}

Result<std::vector<NrrdAxis>> axes_of(const NrrdHeader& nrrd) {
  const auto dimension =
      parse_integer(nrrd.find("dimension") == nullptr ? std::string_view()
                                                      : trimmed(nrrd.find("dimension")->value));
  if (!dimension || *dimension < 1 || *dimension > 16) {
    return nrrd.complain("dimension", "the header has no dimension from 1 to 16");
  }
  const std::vector<std::string> words = nrrd.words("sizes");
  if (words.size() != static_cast<std::size_t>(*dimension)) {
    return nrrd.complain("sizes", "the header has no sizes, one for each dimension");
  }
  std::vector<NrrdAxis> axes;
  for (const std::string& word : words) {
    const auto size = parse_integer(word);
    if (!size || *size < 1)
      return nrrd.complain("sizes", in_quotes(word) + " is no size of an axis");
    NrrdAxis axis;
    axis.size = static_cast<std::uint64_t>(*size);
    axis.number = axes.size();
    axes.push_back(axis);
  }
  return axes;
}

// Its short name, and its dimension; 0 where it is unknown.
struct NrrdSpace {
  std::string name;
  std::size_t dimension = 0;
};
NrrdSpace space_of(const std::string& value) {
  struct KnownSpace {
    const char* names[2];
    const char* space;
  };
  constexpr std::array<KnownSpace, 6> kKnown{{{{"right-anterior-superior", "ras"}, "RAS"},
                                              {{"left-anterior-superior", "las"}, "LAS"},
                                              {{"left-posterior-superior", "lps"}, "LPS"},
                                              {{"scanner-xyz", "scannerxyz"}, "scanner-xyz"},
                                              {{"3d-right-handed", "3dr"}, "3D-right-handed"},
                                              {{"3d-left-handed", "3dl"}, "3D-left-handed"}}};
  const std::string lower = lower_case(trimmed(value));
  for (const KnownSpace& known : kKnown) {
    for (const char* name : known.names) {
      if (lower == name) return {known.space, 3};
      if (lower == std::string(name) + "-time" || lower == std::string(name) + "t") {
        return {known.space, 4};
      }
    }
  }
  return {};
}

// "(x,y,z)"; of four dimensions the fourth is time, of two there is no z.
Result<std::optional<Vector>> vector_of(const NrrdHeader& nrrd, const std::string& field,
                                        const std::string& word, std::size_t dimension) {
  if (word == "none") return std::optional<Vector>();
  std::string inner = word;
  std::replace(inner.begin(), inner.end(), ',', ' ');
  const bool whole = inner.size() >= 2 && inner.front() == '(' && inner.back() == ')';
  const std::vector<std::string> words =
      whole ? words_of(inner.substr(1, inner.size() - 2)) : std::vector<std::string>();
  if (words.size() != dimension) {
    return nrrd.complain(
        field, in_quotes(word) + " is no vector of " + std::to_string(dimension) + " numbers");
  }
  Vector vector{};
  for (std::size_t i = 0; i < words.size(); ++i) {
    // Axes of no space may have vectors of "nan".
    if (lower_case(words[i]) == "nan") return std::optional<Vector>();
    const Result<double> number = number_of(nrrd, field, words[i]);
    if (!number) return number.error();
    if (i < 3) vector[i] = *number;
  }
  return std::optional<Vector>(vector);
}

Result<void> read_directions(const NrrdHeader& nrrd, std::size_t dimension,
                             std::vector<NrrdAxis>& axes) {
  const std::string field = "spacedirections";
  const std::vector<std::string> words = nrrd.words(field);
  if (words.size() != axes.size()) {
    return nrrd.complain(field, "there are " + std::to_string(words.size()) +
                                    " space directions of " + std::to_string(axes.size()) +
                                    " axes");
  }
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const Result<std::optional<Vector>> vector = vector_of(nrrd, field, words[i], dimension);
    if (!vector) return vector.error();
    axes[i].direction = *vector;
    axes[i].spatial = *vector && **vector != Vector{};
    if (*vector && !axes[i].spatial && dimension < 4) {
      return nrrd.complain(field, "space directions is singular: a direction is zero");
    }
  }
  return {};
}

// Without directions the kinds tell; without kinds the first three axes are those of space.
void find_spatial_axes(const NrrdHeader& nrrd, std::vector<NrrdAxis>& axes) {
  const std::vector<std::string> kinds = nrrd.words("kinds");
  std::size_t spatial = 0;
  for (NrrdAxis& axis : axes) {
    const std::string kind = axis.number < kinds.size() ? lower_case(kinds[axis.number]) : "???";
    axis.spatial =
        spatial < 3 && (kind == "domain" || kind == "space" || kind == "???" || kind == "none");
    spatial += axis.spatial ? 1 : 0;
  }
}

// A word of a list with one for each axis, as a number; nothing where there is none, or "nan".
Result<std::optional<double>> axis_number(const NrrdHeader& nrrd, const std::string& field,
                                          std::size_t axis) {
  const std::vector<std::string> words = nrrd.words(field);
  if (axis >= words.size() || lower_case(words[axis]) == "nan") return std::optional<double>();
  const Result<double> number = number_of(nrrd, field, words[axis]);
  if (!number) return number.error();
  return std::optional<double>(*number);
}

// The step along an axis and its first sample, from spacings, axis mins and maxs: samples of cells
// are in their middles, and without a word they are of cells.
struct AxisPlace {
  double step = 1;
  double origin = 0;
};
Result<AxisPlace> place_of_axis(const NrrdHeader& nrrd, const NrrdAxis& axis) {
  const auto spacing = axis_number(nrrd, "spacings", axis.number);
  const auto min = axis_number(nrrd, "axismins", axis.number);
  const auto max = axis_number(nrrd, "axismaxs", axis.number);
  for (const auto* read : {&spacing, &min, &max}) {
    if (!*read) return read->error();
  }
  const std::vector<std::string> centers = nrrd.words("centers");
  const bool node = axis.number < centers.size() && lower_case(centers[axis.number]) == "node";
  AxisPlace place;
  if (*spacing) {
    place.step = **spacing;
  } else if (*min && *max && (!node || axis.size > 1)) {
    const auto parts = static_cast<double>(node ? axis.size - 1 : axis.size);
    place.step = (**max - **min) / parts;
  }
  if (*min) place.origin = node ? **min : **min + place.step / 2;
  return place;
}

Result<void> set_places(const NrrdHeader& nrrd, const std::vector<NrrdAxis>& spatial,
                        VolumeHeader& header) {
  for (std::size_t i = 0; i < spatial.size(); ++i) {
    const Result<AxisPlace> place = place_of_axis(nrrd, spatial[i]);
    if (!place) return place.error();
    header.matrix[i][i] = place->step;
    header.matrix[i][3] = place->origin;
    header.spacing[i] = std::abs(place->step);
  }
  for (std::size_t i = spatial.size(); i < 3; ++i) header.matrix[i][i] = header.spacing[i] = 1;
  return check_matrix(header, "the spacings, or axis mins", nrrd.name);
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Axes across those that there are, of unit length.
void complete(std::vector<Vector>& axes) {
  while (axes.size() < 3) {
    Vector next{};
    if (axes.size() == 1) {
      const Vector& a = axes[0];
      next = cross(a, std::abs(a[0]) > std::abs(a[1]) ? Vector{0, 1, 0} : Vector{1, 0, 0});
    } else {
      next = cross(axes[0], axes[1]);
    }
    const double length = std::sqrt(next[0] * next[0] + next[1] * next[1] + next[2] * next[2]);
    axes.push_back({next[0] / length, next[1] / length, next[2] / length});
  }
}

Result<void> set_directions(const NrrdHeader& nrrd, const std::vector<NrrdAxis>& spatial,
                            std::size_t dimension, VolumeHeader& header) {
  std::vector<Vector> axes;
  for (const NrrdAxis& axis : spatial) axes.push_back(axis.direction.value_or(Vector{}));
  complete(axes);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t row = 0; row < 3; ++row) header.matrix[row][i] = axes[i][row];
    const Vector& a = axes[i];
    header.spacing[i] = std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
  }
  if (const std::vector<std::string> origin = nrrd.words("spaceorigin"); !origin.empty()) {
    const auto vector = vector_of(nrrd, "spaceorigin", origin[0], dimension);
    if (!vector) return vector.error();
    for (std::size_t row = 0; row < 3 && *vector; ++row) header.matrix[row][3] = (**vector)[row];
  }
  return check_matrix(header, "space directions, or space origin,", nrrd.name);
}

// The unit of the axes of space, if it is the same of all.
std::string unit_in(const NrrdHeader& nrrd, const std::vector<NrrdAxis>& spatial) {
  const bool of_space = nrrd.find("spaceunits") != nullptr;
  const std::vector<std::string> words = nrrd.words(of_space ? "spaceunits" : "units");
  std::string unit;
  for (std::size_t i = 0; i < spatial.size(); ++i) {
    const std::size_t at = of_space ? i : spatial[i].number;
    if (at >= words.size()) return {};
    std::string word = words[at];
    word.erase(std::remove(word.begin(), word.end(), '"'), word.end());
    if (word == "???" || (i > 0 && word != unit)) return {};
    unit = word;
  }
  return unit;
}

// How many samples stand before the first of the next layer: axes of space before the others.
Result<std::uint64_t> block_of(const NrrdHeader& nrrd, const std::vector<NrrdAxis>& axes) {
  std::uint64_t block = 1;
  int changes = 0;
  bool in_layers = false;
  bool any_layers = false;
  for (const NrrdAxis& axis : axes) {
    if (axis.size == 1) continue;
    if (axis.spatial == in_layers) ++changes;
    in_layers = !axis.spatial;
    any_layers = any_layers || in_layers;
    if (axis.spatial && !any_layers) block *= axis.size;
  }
  if (changes <= 2) return block;
  return nrrd.complain("sizes", "axes that are not of space stand apart from each other");
}

Result<void> set_space(const NrrdHeader& nrrd, const std::vector<NrrdAxis>& spatial,
                       std::size_t dimension, VolumeHeader& header) {
  for (std::size_t i = 0; i < spatial.size(); ++i) {
    header.size[i] = static_cast<std::size_t>(spatial[i].size);
  }
  header.unit = unit_in(nrrd, spatial);
  header.matrix[3][3] = 1;
  if (nrrd.find("spacedirections") == nullptr) return set_places(nrrd, spatial, header);
  return set_directions(nrrd, spatial, dimension, header);
}

// Of the space that the file names, or says the dimension of; 0 if neither.
Result<std::size_t> space_dimension(const NrrdHeader& nrrd, VolumeHeader& header) {
  if (const NrrdField* const space = nrrd.find("space")) {
    const NrrdSpace known = space_of(space->value);
    if (known.dimension == 0) {
      return nrrd.complain("space", in_quotes(space->value) + " is no space that is known");
    }
    header.space = known.name;
    return known.dimension;
  }
  const NrrdField* const field = nrrd.find("spacedimension");
  if (field == nullptr) return std::size_t{0};
  const auto dimension = parse_integer(trimmed(field->value));
  if (dimension && *dimension >= 1 && *dimension <= 4) return static_cast<std::size_t>(*dimension);
  return nrrd.complain("spacedimension", "a space of 1 to 4 dimensions is read");
}

}  // namespace

Result<std::uint64_t> set_nrrd_axes(const NrrdHeader& nrrd, VolumeHeader& header) {
  Result<std::vector<NrrdAxis>> axes = axes_of(nrrd);
  if (!axes) return axes.error();
  const Result<std::size_t> dimension = space_dimension(nrrd, header);
  if (!dimension) return dimension.error();
  find_spatial_axes(nrrd, *axes);
  if (nrrd.find("spacedirections") != nullptr) {
    if (*dimension == 0) {
      return nrrd.complain("spacedirections", "there are space directions, and no space");
    }
    if (Result<void> read = read_directions(nrrd, *dimension, *axes); !read) return read.error();
  }
  std::vector<NrrdAxis> spatial;
  std::vector<std::uint64_t> sizes;
  for (const NrrdAxis& axis : *axes) {
    sizes.push_back(axis.size);
    if (axis.spatial) spatial.push_back(axis);
  }
  if (!product_up_to(sizes, kMostSamples)) {
    return nrrd.complain("sizes", "the sizes announce too many voxels");
  }
  if (spatial.empty() || spatial.size() > 3) {
    return nrrd.complain(
        "kinds", "a volume has one to three axes of space, not " + std::to_string(spatial.size()));
  }
  for (const NrrdAxis& axis : *axes) {
    header.sizes.push_back(static_cast<std::size_t>(axis.size));
    if (!axis.spatial) header.layers *= static_cast<std::size_t>(axis.size);
  }
  header.size = {1, 1, 1};
  if (Result<void> set = set_space(nrrd, spatial, *dimension, header); !set) return set.error();
  return block_of(nrrd, *axes);
}

}  // namespace tetloft::internal::io
