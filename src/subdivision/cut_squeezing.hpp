// Squeezing of cuts: positions for the cuts of pieces that are not positive, since their
// children are about as thin as the spacing of doubles.
//
// The pieces of a class are what is left of the children after splitting their cut edges one
// after another, in descending order of the cuts: the diagonals that a split leaves then start
// at the lowest vertex, like the pieces' own (Truncation, split_prism). A point of an edge
// splits positive tets into positive tets, so that each split has room of its own, however
// thin the tets; squeezing finds a double there if there is one.
#pragma once

#include <span>
#include <vector>

#include "slab/classes.hpp"
#include "subdivision/squeeze.hpp"
#include "subdivision/subdivision.hpp"
#include "subdivision/truncation.hpp"

namespace tetloft::internal {

/// Moves cuts of the pieces `bad` (indices into truncation.pieces), and of the children they
/// lie in, to where the children split by them are positive. `heights` are the doubles between the
/// planes. Nothing is promised: test the pieces again.
void squeeze_cuts(IdVector<NodeId, Point3>& points, const SlabClasses& classes,
                  const Subdivision& subdivision, const Truncation& truncation,
                  std::span<const std::size_t> bad, DoubleRange heights);

}  // namespace tetloft::internal
