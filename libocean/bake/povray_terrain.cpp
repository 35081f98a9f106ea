// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The folder of a terrain for POV-Ray; see povray_folder.hpp.
#include "ocean/error.hpp"
#include "ocean/internal/bake/povray_folder.hpp"
#include "ocean/internal/io/mesh2.hpp"
#include "ocean/internal/io/povray_declarations.hpp"
#include "ocean/io/mesh.hpp"
#include "ocean/terrainfile.hpp"
#include "povray_macros.hpp"

namespace ocean {
namespace {

constexpr std::string_view kSettings =
    "; The terrain of this folder: povray terrain.ini\n"
    "; Another size: povray terrain.ini +W640 +H360\n"
    "Input_File_Name=scene.pov\n"
    "Library_Path=.\n";

}  // namespace

std::vector<FolderFile> povray_terrain_files(const BakePlan& plan, const TerrainState& state,
                                             std::string_view format) {
    const TerrainModel* const terrain = find_terrain(*plan.subject);
    if (terrain == nullptr) throw Error(ErrorKind::unsupported, "this folder needs a terrain");
    const Domain domain = plan.domain();
    std::vector<FolderFile> files = {
        {"terrain.inc", std::string(kTerrainInc)},
        {"terrain_parameters.inc", io::povray_declarations(io::PovrayTerrain{
                                       *terrain, state, format, domain, plan.subject_id})},
        {"terrain.ini", std::string(kSettings) + std::string(kPovrayPicture)},
        {"terrain.toml", "# The terrain of this folder, by `ocean povray`.\n" + plan.subject_text},
        {"scene.pov", std::string(kTerrainScenePov), true}};
    // The text of more faces would be 220 MB; for these, the macros make them. terrain.inc has the
    // same limit.
    constexpr std::size_t kMaxFaces = 1024 * 1024;
    if (format == "df3" && domain.count() <= kMaxFaces) {
        files.push_back({"faces.inc", io::povray_faces(io::patch_triangles(domain))});
    }
    return files;
}

}  // namespace ocean
