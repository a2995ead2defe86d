// What is not the solid belongs together, too: links of voids, and the topology that follows from
// the links of regions and voids. Decided in src/correspondence, made in src/completion; recomputed
// independently by check (guarantee 5).
//
// The rule, in full. A *void* of a section is a hole, its islands taken out, named by its contour;
// or the *exterior*, what lies outside all contours, named by none. r, d, and "moved on" are those
// of correspondence.hpp, of voids in place of regions; the area of an exterior is infinite, so that
// the ratio of a hole with it is the share of the hole that lies in it. In each slab:
//
// V0. A VV face lies *between* two regions iff they alone have contours at its border, one region
// of
//     either section, they are linked and have no point in common, the face has one hole, and its
//     voids are not holes of linked regions: a ring over a disc, or around a smaller ring, but no
//     pore over an island. A wall belongs there. Two voids that have such faces in common and no
//     others are no candidate of V1 to V3.
// V1. The two exteriors are linked. Two other voids are a candidate iff r > kVoidOverlap. There is
//     no guard: weak links between well-connected voids are mostly real openings.
// V2. Chains. A hole without candidate of V1 in a slab is single there. Two single holes with
//     d ≤ kVoidChainReach are a candidate iff either of them, moved on as rule 2 of
//     correspondence.hpp has it, has a ratio > kChainOverlap with the other; the reach of that rule
//     is kVoidChainReach here, its candidates are those of V1, and the exterior is no origin.
// V3. Rim. A hole without candidate of V1 and V2 in a slab is linked with the exterior across if
// its
//     d < kRimReach; by `near K` with the void of least d (then of lowest number) if that d < K.
// V4. Decisions of the user on two voids: a parted pair is no candidate, a joined one is.
// V5. Labels of holes, as rules 5 to 7 there: the same label, the same void; different labels,
//     different voids, the exterior's included. Without labels all candidates are accepted.
//
// The voids of a slab united by its accepted links are its *void classes*; over the stack they are
// the cavities, and the outside.
//
// What follows (FACES). The contours of both sections, laid over each other, part the plane into
// faces: SS, SV, VS or VV, by what lies below and above. Solid classes are those of the links of
// regions. A VV face is open iff its two voids are of one void class; else it is closed by a plate.
// Then the Euler characteristic of what the slab holds of a solid class C is
//
//     chi(C) = sum of chi(region), over its regions − sum of chi(face), over SS faces of two
//              regions of C + sum of chi(face), over the closed VV faces at C − bars − tunnels,
//
// chi of a region or face being 1 − its holes; bars the number of pieces of C that its SS faces
// alone leave apart, less 1; tunnels, the same of each void class, at the solid class around it. A
// closed face with more than one solid class at its border, or a tunnel between holes of two, makes
// these one group, whose sum counts. chi of the stack is the sum over slabs less that over inner
// sections; and genus = components + cavities − chi.
//
// Regions also *touch*: in a point, or along an edge that has one of them on either side, as on
// pixel grids they often do; or two SS faces, in a point. So do voids. A touch is small enough to
// be seen as solid or as void, and either is right: as solid it counts as a face of its Euler
// characteristic, joins pieces, and parts voids. So chi(C) is a range, from what it is where those
// touches are solid that make it less, to where those are that make it more.
//
// V6. Where no wall can stand between two voids of different classes, however contours are divided,
//     they count as one, and are reported (`forced`); a link that the slab's tetrahedra cannot open
//     is no link, and is reported (`unrealisable`). Where chi of a group is out of its range after
//     all, that is reported (Deviation). By `strict` each of the three is refused.
#pragma once

#include <cstdint>
#include <vector>

#include <tetloft/correspondence.hpp>
#include <tetloft/ids.hpp>

namespace tetloft {

/// The threshold of V1, a choice of the same size as kDefaultOverlap.
inline constexpr double kVoidOverlap = 0.02;
/// How far chains of holes reach, in gaps, and rims.
inline constexpr double kVoidChainReach = 1.0;
inline constexpr double kRimReach = 0.25;

/// Where the two voids of a link lie. The values are stored in files.
enum class VoidPlanes : std::uint8_t {
  across = 0,  ///< one in either section of the slab
  lower = 1,   ///< both in the lower one: V6 alone joins such
  upper = 2,
};
inline constexpr int kVoidPlanes = 3;

/// A link between two voids of neighbouring sections, made or nearly, and how surely: `lower` and
/// `upper` are the contours of holes, invalid for the exterior. The links of exteriors with each
/// other, which are certain, are left out. `moved` is r, but of chains; `lead` is over other pairs
/// of the link's holes.
struct VoidLink : RegionLink {
  VoidPlanes planes = VoidPlanes::across;
};

/// Where the solid of a slab has not the topology that the links imply (guarantee 5).
struct Deviation {
  SlabId slab;
  bool upper = false;  ///< the region is one of the upper section
  /// The outer contour of a region of the group: the lowest by (section, region).
  ContourId contour;
  std::int32_t least = 0, most = 0;  ///< what chi of the group may be
  std::int32_t got = 0;              ///< what it is
};

}  // namespace tetloft
