// Pictures of models: still ones as PNG and SVG, and a page with an interactive viewer that works
// from the file alone. Meant for eyes: colours and shades are computed in plain floating point.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include <tetloft/execution.hpp>
#include <tetloft/export.hpp>
#include <tetloft/model.hpp>
#include <tetloft/result.hpp>
#include <tetloft/section_stack.hpp>

namespace tetloft {

/// What the colour of a tet tells.
enum class ColourBy : std::uint8_t {
  component,
  slab,
  kind,      ///< TetKind
  dihedral,  ///< its smallest dihedral angle
  /// Evidence of the link that holds it: of those in its slab with a contour in its part, which is
  /// what hangs together there by faces, the first of least_sure_first() that was made.
  evidence,
};
inline constexpr int kColourings = 5;
[[nodiscard]] TETLOFT_API const char* name_of(ColourBy colour);

/// A plane x, y or z = position. Of the model the part away from the eye stays, and is shown cut
/// open; for z the lower part.
struct PictureCut {
  int axis = 2;  ///< 0 x, 1 y, 2 z
  double position = 0;
};

/// Pixels: samples of a picture of this side take half a gigabyte.
inline constexpr int kLargestPictureSide = 8192;

struct RenderOptions {
  ColourBy colour = ColourBy::component;
  /// Where the eye stands, in degrees: from +x towards +y, and above the sections' planes.
  double azimuth = -60;
  double elevation = 25;
  /// Pixels; of a page the viewer takes the window instead. 1 to kLargestPictureSide.
  int width = 1200;
  int height = 900;
  std::optional<PictureCut> cut = {};
  /// Slabs are moved apart by this many mean heights of a slab.
  double explode = 0;
  bool edges = false;    ///< draws the edges of tets
  bool contours = true;  ///< draws the contours of the sections
  double stretch = 1;    ///< z is drawn this many times as large
  bool white = false;    ///< white background instead of none
  /// Of the page, UTF-8; what is not, and control characters, as U+FFFD.
  std::string title = {};
  Execution execution = {};  ///< pictures are drawn on one thread
};

/// The picture of a model, as the bytes of a file. `contours`: the sections whose contours are
/// drawn; null: the outlines of the model in its section planes. Refused: cancelled if it was
/// stopped; usage for options out
/// of range, or a colour that the model has no data for; invalid_input for a model without tets,
/// with a face of more than two, ids out of range, arrays of a wrong length, and coordinates, of
/// contours too, that are not finite. A model and its multiple by a power of two have the same
/// picture.
[[nodiscard]] TETLOFT_API Result<std::string> render_png(const Model& model,
                                                         const SectionStack* contours,
                                                         const RenderOptions& options = {});
/// Only triangles that are seen are written.
[[nodiscard]] TETLOFT_API Result<std::string> render_svg(const Model& model,
                                                         const SectionStack* contours,
                                                         const RenderOptions& options = {});
/// One HTML file without references to others, that shows the model by WebGL 2, as it lies in the
/// space of its file: it can be turned, cut by any plane, measured, taken apart and coloured anew.
/// src/render/README.md.
[[nodiscard]] TETLOFT_API Result<std::string> render_html(const Model& model,
                                                          const SectionStack* contours,
                                                          const RenderOptions& options = {});

struct NamedModel {
  const Model* model = nullptr;
  std::string name = {};  ///< UTF-8; empty: that of its description, or its number
};

/// A page that shows several models, over each other or side by side, each where its file has it.
/// Heights of `contours` and of the cut are those of each, and of the first, model's stack. Unit
/// and orientation are those of the first that has any. Refused as above for each of the models,
/// which the message names, and usage where there is none, or null among them.
[[nodiscard]] TETLOFT_API Result<std::string> render_html(std::span<const NamedModel> models,
                                                          const SectionStack* contours,
                                                          const RenderOptions& options = {});

}  // namespace tetloft
