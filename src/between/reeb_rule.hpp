// The Reeb rule: no handle, no cavity and no bar opens and closes within one slab. The name is that
// of the graph of level sets of a height (Reeb, 1946): here, of the layers of a slab.
#pragma once

#include <vector>

#include "between/competition.hpp"
#include "between/inner_sections.hpp"
#include "between/layer_graph.hpp"

namespace tetloft::internal::between {

/// The shapes of a slab's classes while they are repaired; after compete().
struct SlabFields {
  const SlabShape& slab;
  ClassShapes& shapes;
  const std::vector<MeetingWindows>& meetings;
};

enum class ApartParts { stay, bridged };

/// Repairs the layers between of class c, and returns the graph of its solids then: of the regions
/// slab.classes[c].lower, as they are numbered there, of the parts in each layer between, and of
/// the regions slab.classes[c].upper. No part between is connected to no region. Parts that the
/// layers between do not connect stay so, or are bridged (bridges.hpp).
LayerGraph apply_reeb_rule(const SlabFields& fields, ClassId c, ApartParts parts);

}  // namespace tetloft::internal::between
