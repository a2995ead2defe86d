// tetloft: solids from planar cross sections. This header includes the whole API; each
// part can be included alone.
#pragma once

#include <tetloft/between.hpp>
#include <tetloft/check.hpp>
#include <tetloft/correspondence.hpp>
#include <tetloft/delaunay.hpp>
#include <tetloft/delaunay_triangulation2.hpp>
#include <tetloft/delaunay_triangulation3.hpp>
#include <tetloft/delaunay_vertex.hpp>
#include <tetloft/execution.hpp>
#include <tetloft/export.hpp>
#include <tetloft/formats.hpp>
#include <tetloft/frame.hpp>
#include <tetloft/geiger.hpp>
#include <tetloft/ids.hpp>
#include <tetloft/inspect.hpp>
#include <tetloft/io.hpp>
#include <tetloft/links.hpp>
#include <tetloft/live_range.hpp>
#include <tetloft/location_kind.hpp>
#include <tetloft/model.hpp>
#include <tetloft/periodic.hpp>
#include <tetloft/pieces.hpp>
#include <tetloft/point.hpp>
#include <tetloft/predicates.hpp>
#include <tetloft/reconstruct.hpp>
#include <tetloft/render.hpp>
#include <tetloft/report.hpp>
#include <tetloft/report_page.hpp>
#include <tetloft/result.hpp>
#include <tetloft/sections.hpp>
#include <tetloft/tet_mesh.hpp>
#include <tetloft/version.hpp>
#include <tetloft/voids.hpp>
#include <tetloft/voronoi.hpp>
#include <tetloft/voronoi2.hpp>
