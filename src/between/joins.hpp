// Parts of a class that hang together both below and above a layer are joined in it.
#pragma once

#include <cstddef>
#include <vector>

#include "between/class_shape.hpp"
#include "between/competition.hpp"
#include "between/layer_graph.hpp"

namespace tetloft::internal::between {

/// Joins the parts of each group in a layer between by cheapest paths: a step costs 0.1 and the
/// square of how far outside the sample is, none leads over foreign samples or beside another
/// part. `labels`: of the layer's solids. Paths become inside in `shape`. False if nothing changed.
bool join_parts(const std::vector<DoublyConnected>& groups, ForeignSamples& foreign,
                std::size_t layer, ClassShape& shape, const LayerLabels& labels);

}  // namespace tetloft::internal::between
