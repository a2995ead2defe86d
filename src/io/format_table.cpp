#include <algorithm>
#include <array>

#include "io/formats.hpp"

// The table: a line for each format, in the order in which contents are looked at and help lists
// them. NAME stands for the value io::NAME_format.
#define TETLOFT_FORMAT_TABLE(FORMAT) \
  FORMAT(rtstruct)                   \
  FORMAT(cxt)                        \
  FORMAT(csl)                        \
  FORMAT(slc)                        \
  FORMAT(imod)                       \
  FORMAT(nifti)                      \
  FORMAT(nrrd)                       \
  FORMAT(metaimage)                  \
  FORMAT(cnt)                        \
  FORMAT(vtu)                        \
  FORMAT(vtk)                        \
  FORMAT(msh)                        \
  FORMAT(msh2)                       \
  FORMAT(medit)                      \
  FORMAT(tetgen)                     \
  FORMAT(abaqus)                     \
  FORMAT(nastran)                    \
  FORMAT(netgen)                     \
  FORMAT(obj)                        \
  FORMAT(ply)                        \
  FORMAT(vtp)                        \
  FORMAT(stl)                        \
  FORMAT(off)                        \
  FORMAT(threemf)                    \
  FORMAT(glb)                        \
  FORMAT(geojson)                    \
  FORMAT(svg)                        \
  FORMAT(dxf)                        \
  FORMAT(csv)                        \
  FORMAT(xyz)                        \
  FORMAT(node)                       \
  FORMAT(bin)                        \
  FORMAT(labels)

namespace tetloft::internal::io {

#define TETLOFT_DECLARE_FORMAT(NAME) extern const Format NAME##_format;
TETLOFT_FORMAT_TABLE(TETLOFT_DECLARE_FORMAT)
#undef TETLOFT_DECLARE_FORMAT

namespace {

#define TETLOFT_LIST_FORMAT(NAME) &NAME##_format,
constexpr std::array kFormats{TETLOFT_FORMAT_TABLE(TETLOFT_LIST_FORMAT)};
#undef TETLOFT_LIST_FORMAT
#undef TETLOFT_FORMAT_TABLE

}  // namespace

FormatTable format_table() { return kFormats; }

}  // namespace tetloft::internal::io

namespace tetloft {

using namespace internal;

const char* name_of(Contents contents) {
  switch (contents) {
    case Contents::stack: return "stack";
    case Contents::model: return "model";
    case Contents::surface: return "surface";
    case Contents::points: return "points";
    case Contents::labels: return "labels";
    case Contents::lines: return "lines";
  }
  return "unknown";
}

std::span<const FormatInfo> formats() {
  static const auto infos = [] {
    std::array<FormatInfo, io::kFormats.size()> all;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const io::Format& format = *io::kFormats[i];
      const auto end = std::find(format.extensions.begin(), format.extensions.end(), "");
      all[i] = {format.name, format.summary, {format.extensions.begin(), end}, {}, {}};
      for (int k = 0; k < kContents; ++k) {
        const auto contents = static_cast<Contents>(k);
        if (io::reads(format, contents)) all[i].reads.add(contents);
        if (io::writes(format, contents)) all[i].writes.add(contents);
      }
    }
    return all;
  }();
  return infos;
}

}  // namespace tetloft
