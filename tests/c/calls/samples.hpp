// Small inputs of each kind.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace tetloft::c_test {

/// Two sections: a square with a hole below, a square above.
inline constexpr std::string_view kStackText =
    "S 2\nv 8 z 0\n{\n0 0\n4 0\n4 4\n0 4\n}\n{\n1 1\n3 1\n3 3\n1 3\n}\n"
    "v 4 z 1\n{\n0 0\n5 0\n5 5\n0 5\n}\n";
/// A vertex is repeated at the end: mended, with a warning.
inline constexpr std::string_view kMendedText =
    "S 2\nv 4 z 0\n{\n0 0\n4 0\n4 4\n0 0\n}\nv 3 z 1\n{\n0 0\n4 0\n4 4\n}\n";
inline constexpr std::string_view kLabelText = "0 0 1\n1 0 1\n";
inline constexpr std::string_view kPointText = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";

/// Two tets with a face in common.
inline const std::vector<double> kTetPoints{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1};
inline const std::vector<std::uint32_t> kTets{0, 1, 2, 3, 4, 1, 3, 2};

/// Within them, and beside.
inline const std::vector<double> kInnerPoint{0.25, 0.25, 0.125};
inline const std::vector<double> kQueries{0.1, 0.1, 0.1, 0.5, 0.5, 0, 9, 9, 9};

/// What cells are clipped to, and a periodic box.
inline const std::vector<double> kClippingBox{-1, -1, -1, 2, 2, 2};
inline const std::vector<double> kBoxVectors{3, 0, 0, 1, 3, 0, 0, 1, 3};

/// The two tets as a file, which tells that they are one component.
inline constexpr std::string_view kModelText =
    "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\">"
    "<UnstructuredGrid><Piece NumberOfPoints=\"5\" NumberOfCells=\"2\">"
    "<CellData><DataArray type=\"Int32\" Name=\"component\" format=\"ascii\">0 "
    "0</DataArray></CellData>"
    "<Points><DataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\" format=\"ascii\">"
    "0 0 0 1 0 0 0 1 0 0 0 1 1 1 1</DataArray></Points>"
    "<Cells><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1 2 3 4 1 3 2"
    "</DataArray><DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">4 8</DataArray>"
    "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">10 10</DataArray></Cells>"
    "</Piece></UnstructuredGrid></VTKFile>\n";

/// A square with a segment along a diagonal.
inline const std::vector<double> kPlanePoints{0, 0, 2, 0, 2, 2, 0, 2, 1, 0.5};
inline const std::vector<std::uint32_t> kSegments{0, 2};
/// Its sides.
inline const std::vector<std::uint64_t> kOutline{0, 1, 1, 2, 2, 3, 3, 0};

}  // namespace tetloft::c_test
