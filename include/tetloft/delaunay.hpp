// Delaunay triangulations in the plane and in space; each part can be included alone.
#pragma once

#include <tetloft/delaunay2.hpp>
#include <tetloft/delaunay3.hpp>
