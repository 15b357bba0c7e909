// SPDX-License-Identifier: MIT
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "mesh/mesh_check.h"
#include "mesh/obj.h"
#include "mesh/ply.h"

// Any bytes are refused by InputError or give a mesh whose indices exist and that can be mended and
// written. What begins as a PLY file does is read as one, the rest as OBJ.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace edaha;
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const bool is_ply = bytes.starts_with("ply");
    const LoadMaterials no_materials;
    try {
        const MeshInput input =
            is_ply ? read_ply(bytes, "") : read_obj(bytes, "", {}, no_materials);
        if (input.mesh.triangles.empty()) std::abort();
        const MeshReport report = validate(input.mesh);
        if (report.missing_points + report.shared_points > 0) std::abort();
        const Mesh mended = mend(input.mesh);
        if (validate(mended).broken_points > 0) std::abort();
        if (mended.triangles.empty()) return 0;
        if (read_ply(write_ply(mended), "").mesh.triangles.size() != mended.triangles.size())
            std::abort();
        if (read_obj(write_obj(mended, "").obj, "").mesh.triangles.size() !=
            mended.triangles.size())
            std::abort();
    } catch (const InputError& error) {
        if (error.problems().empty()) std::abort();
    }
    return 0;
}
