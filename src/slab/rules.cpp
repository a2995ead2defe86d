// Names of rules and steps.
#include "slab/rules.hpp"

namespace tetloft {

const char* name_of(Rule rule) {
  switch (rule) {
    case Rule::run_at_contour_edge: return "run_at_contour_edge";
    case Rule::run_at_external_edge: return "run_at_external_edge";
    case Rule::run_at_cross_edge: return "run_at_cross_edge";
    case Rule::gap_at_cross_edge: return "gap_at_cross_edge";
    case Rule::hole_in_link: return "hole_in_link";
    case Rule::detached_sheet: return "detached_sheet";
    case Rule::merge_sheets: return "merge_sheets";
    case Rule::connect_parts: return "connect_parts";
    case Rule::triangular_hole: return "triangular_hole";
    case Rule::two_class_tet: return "two_class_tet";
    case Rule::halved_lift: return "halved_lift";
    case Rule::moved_cut: return "moved_cut";
    case Rule::prism: return "prism";
    case Rule::gluing: return "gluing";
    case Rule::gabriel_refinement: return "gabriel_refinement";
    case Rule::opened_pit: return "opened_pit";
    case Rule::closed_passage: return "closed_passage";
    case Rule::united_voids: return "united_voids";
    case Rule::filled_handle: return "filled_handle";
    case Rule::bridged_face: return "bridged_face";
    case Rule::opened_face: return "opened_face";
  }
  return "unknown";
}

const char* name_of(Step step) {
  switch (step) {
    case Step::sections: return "sections";
    case Step::delaunay: return "delaunay";
    case Step::correspondence: return "correspondence";
    case Step::between: return "between";
    case Step::complex: return "complex";
    case Step::subdivision: return "subdivision";
    case Step::contact: return "contact";
    case Step::assembly: return "assembly";
  }
  return "unknown";
}

}  // namespace tetloft
