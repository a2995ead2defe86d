// Contours of volumes: slices are traced one by one, and put where they lie.
#include "io/volume/stack_of_volume.hpp"

#include <algorithm>

#include <tetloft/valid_stack.hpp>

#include "core/watched_work.hpp"
#include "io/arguments.hpp"
#include "io/volume/placement.hpp"
#include "io/volume/region_choice.hpp"
#include "io/volume/slices.hpp"
#include "io/volume/trace.hpp"
#include "io/volume/volume_error.hpp"

namespace tetloft::internal::io {

namespace {

// More slices, larger ones, or more vertices are refused: what they would take of memory does not
// depend on the file's size where it is compressed.
constexpr std::size_t kMostSlices = std::size_t{1} << 16;
constexpr std::size_t kMostPixels = std::size_t{1} << 28;
constexpr std::size_t kMostVertices = std::size_t{1} << 27;

Error too_large(const std::string& name, const std::string& what, std::size_t most) {
  return volume_error(name, what + " than the " + std::to_string(most) + " that are read");
}

class StackBuilder {
 public:
  StackBuilder(const SlicePlacement& placed, std::size_t slices, VolumeContours way)
      : placed_(placed), way_(way) {
    stack_.sections.resize(slices);
    for (std::size_t i = 0; i < slices; ++i) {
      section(i).z = placed.height.at(static_cast<double>(i));
    }
  }

  // Of slices that were not added the section is empty.
  void add(std::size_t index, Slice& slice) {
    Section& to = section(index);
    trace_contours(slice, way_, [&](const std::vector<PixelPoint>& loop) {
      Contour contour;
      contour.vertices.reserve(loop.size());
      for (const PixelPoint& p : loop) {
        const double column = placed_.column.at(p.column);
        const double row = placed_.row.at(p.row);
        contour.vertices.push_back(placed_.column_is_x ? Point2{column, row} : Point2{row, column});
      }
      vertices_ += loop.size();
      to.contours.push_back(std::move(contour));
    });
  }
  [[nodiscard]] std::size_t vertices() const { return vertices_; }

  // Without the empty sections at both ends.
  SectionStack finished() && {
    const auto holds = [](const Section& s) { return !s.contours.empty(); };
    auto& all = stack_.sections;
    const auto first = std::find_if(all.begin(), all.end(), holds);
    const auto last = std::find_if(std::make_reverse_iterator(all.end()),
                                   std::make_reverse_iterator(first), holds);
    SectionStack trimmed;
    for (auto s = first; s != last.base(); ++s) trimmed.sections.push_back(std::move(*s));
    return trimmed;
  }

 private:
  // Ascending by z, whichever way the indices go.
  Section& section(std::size_t index) {
    const std::size_t last = stack_.sections.size() - 1;
    return stack_.sections[SectionId(placed_.height.step > 0 ? index : last - index)];
  }

  const SlicePlacement& placed_;
  VolumeContours way_;
  SectionStack stack_;
  std::size_t vertices_ = 0;
};

// "RAS", "LPS", "LAS" and the like, of what formats call spaces.
bool is_of_body(const std::string& space) {
  return space.size() == 3 && (space[0] == 'L' || space[0] == 'R');
}

Result<void> check_size(const VolumeHeader& header, const SlicePlacement& placed,
                        const std::string& name) {
  if (header.size[placed.across] > kMostSlices) {
    return too_large(name, "the volume has more slices", kMostSlices);
  }
  if (header.size[placed.column_axis] > kMostPixels / header.size[placed.row_axis]) {
    return too_large(name, "a slice of the volume has more pixels", kMostPixels);
  }
  return {};
}

}  // namespace

Result<StackOfFile> stack_of_volume(Volume& volume, const std::string& name,
                                    const ReadOptions& options) {
  const VolumeHeader& header = volume.header();
  const auto across = static_cast<std::size_t>(options.axis.value_or(2));
  const Result<SlicePlacement> placed = place_slices(header, across, name);
  if (!placed) return placed.error();
  if (Result<void> fits = check_size(header, *placed, name); !fits) return fits.error();
  const std::size_t slices = header.size[across];
  WatchedWork work(options.execution, slices + layers_to_count(header, options) * header.size[2]);
  const Result<ChosenRegion> region = choose_region(volume, name, options, work);
  if (!region) return region.error();

  StackBuilder builder(*placed, slices, options.contours);
  const Result<void> traced =
      for_each_slice(volume, region->layer, *placed, region->rule, work,
                     [&](std::size_t index, Slice& slice) -> Result<void> {
                       builder.add(index, slice);
                       if (builder.vertices() <= kMostVertices) return {};
                       return too_large(name, "the contours have more vertices", kMostVertices);
                     });
  if (!traced) return traced.error();
  ReadStack read;
  read.stack = std::move(builder).finished();
  if (read.stack.sections.empty()) return empty_region(volume, name, options, *region);
  read.warnings = header.warnings;
  read.stack.frame = placed->frame;
  read.stack.about = {region->name, header.unit,
                      is_of_body(header.space) ? header.space : std::string()};
  IdVector<SectionId, Nesting> nestings;
  if (options.validity == Validity::required) {
    auto nested = nest_if_valid(read.stack, untold(options.execution));
    if (!nested) return at_file(name, nested.error());
    nestings = *std::move(nested);
  }
  return StackOfFile{std::move(read), std::move(nestings)};
}

}  // namespace tetloft::internal::io
