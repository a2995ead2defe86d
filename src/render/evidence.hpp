// What holds the parts of a model together: for each tet the evidence of a link.
#pragma once

#include <cstdint>
#include <vector>

#include <tetloft/model.hpp>
#include <tetloft/tet_mesh.hpp>

#include "render/subject.hpp"

namespace tetloft::internal::render {

/// Whether a model has what evidence_by_tet() looks at.
[[nodiscard]] bool tells_evidence(const Model& model);

/// By tet of the subject: of its part, which are the tets of a slab that hang together by faces,
/// end prisms aside, the least sure link that was made (sureness(); of equals the first). A link
/// is of a part where one of its contours is. kNoEvidence where there is none, and of end prisms.
/// `mesh` is that of the subject's tets. Requires tells_evidence().
[[nodiscard]] std::vector<std::uint8_t> evidence_by_tet(const Model& model, const TetMesh& mesh,
                                                        const Subject& subject);

}  // namespace tetloft::internal::render
