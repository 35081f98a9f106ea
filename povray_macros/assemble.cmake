# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
# Assembles the includes of POV-Ray's scenes. Sets ocean_inc, terrain_inc and coast_inc, their texts,
# and writes them as files into povray_macros/ of the build folder, from where packages take them.
#
# Each stays one flat file: POV-Ray 3.7 loses its place in a file whose macros include others. The
# order of the parts of ocean.inc is that of their @names@ in ocean/ocean.inc.in.
set(macros ${CMAKE_CURRENT_LIST_DIR})
file(GLOB parts CONFIGURE_DEPENDS ${macros}/ocean/*.inc)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS
  ${parts} ${macros}/ocean/ocean.inc.in ${macros}/terrain.inc.in ${macros}/coast.inc)

# Puts `text` in the place of the line @name@ in the file's text, which the named variable holds.
function(put_in file name text)
  string(FIND "${${file}}" "\n@${name}@\n" at)
  if(at EQUAL -1)
    message(FATAL_ERROR "${file}: no line @${name}@ says where this part goes")
  endif()
  string(REPLACE "\n@${name}@\n" "\n${text}" ${file} "${${file}}")
  set(${file} "${${file}}" PARENT_SCOPE)
endfunction()
function(require_whole file)
  if("${${file}}" MATCHES "\n(@[a-z_]+@)\n")
    message(FATAL_ERROR "${file}: there is no part ${CMAKE_MATCH_1}")
  endif()
endfunction()

# A part opens with a comment of its own, which ends at the first empty line and stays behind.
file(READ ${macros}/ocean/ocean.inc.in ocean_inc)
foreach(part IN LISTS parts)
  cmake_path(GET part STEM name)
  file(READ ${part} text)
  string(FIND "${text}" "\n\n" end)
  if(NOT text MATCHES "^// SPDX" OR end EQUAL -1)
    message(FATAL_ERROR "${part} does not open with a comment and an empty line")
  endif()
  math(EXPR begin "${end} + 2")
  string(SUBSTRING "${text}" ${begin} -1 text)
  put_in(ocean_inc ${name} "${text}")
endforeach()
require_whole(ocean_inc)

# A terrain has the sky and the haze of ocean.inc under names of its own. Their comments speak of the
# sea and stay there.
function(read_section first end variable)
  string(FIND "${ocean_inc}" "${first}" from)
  string(FIND "${ocean_inc}" "${end}" to)
  if(from EQUAL -1 OR to LESS from)
    message(FATAL_ERROR "ocean.inc has no section '${first}' before '${end}'")
  endif()
  math(EXPR length "${to} - ${from}")
  string(SUBSTRING "${ocean_inc}" ${from} ${length} section)
  string(REGEX REPLACE "(\n *//[^\n]*)+" "" section "\n${section}")
  string(REGEX REPLACE " *//[^\n]*" "" section "${section}")
  string(REPLACE ", Ocean_View\"" "\"" section "${section}")
  string(REPLACE " an Ocean_" " a Ocean_" section "${section}")
  string(REPLACE "Ocean_" "Terrain_" section "${section}")
  string(REPLACE "ocean.inc" "terrain.inc" section "${section}")
  set(${variable} "${section}" PARENT_SCOPE)
endfunction()
set(sea_horizon "    #ifdef(Terrain_Eye_) #local Eye_Height_ = max(0, Terrain_Eye_.y); #end\n")
read_section("// ---- Light ---" "// ---- Water ---" light)
read_section("// The share of the air in what is seen" "// ---- Layers of the water" haze)
# The sky of a sea ends at its horizon; that of a terrain goes on below, behind the end of the land.
string(FIND "${light}" "${sea_horizon}" horizon)
if(horizon EQUAL -1)
  message(FATAL_ERROR "Ocean_Sky of ocean.inc has another line for the height of the eye")
endif()
string(REPLACE "${sea_horizon}" "" light "${light}")
string(REPLACE "Eye_Height_ = 20000;" "Eye_Height_ = 200000;" light "${light}")
# Its view has the picture's sides, strips and faces of the fan of Ocean_View.
read_section("    #local Forward_ = vnormalize(Look_);" "    // To where the highest crests sink"
  planes)
read_section("    #local First_ = array[Rows_ + 1];" "    #declare Ocean_View_Vertices = Vertices_;"
  strips)
read_section("        face_indices {\n            Faces_ +"
  "        inside_vector <0.0131, 1, 0.0073>\n    }\n#end\n\n// Writes the positions of a fan"
  faces)
# Each mask of a land without a unit has a function; the rows are those of the library.
set(rows ${PROJECT_SOURCE_DIR}/libocean/include/ocean/land_mask.hpp)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${rows})
file(READ ${rows} rows)
string(REPLACE ";" "," rows "${rows}")
string(REGEX MATCH "enum class LandMask {([a-z_, \n]+)}" enumerators "${rows}")
string(REGEX MATCHALL "[a-z_]+" enumerators "${CMAKE_MATCH_1}")
string(REGEX MATCH "kSignedMasks = ([^,]+)," signed "${rows}")
string(REGEX MATCHALL "detail::mask\\([a-z_]+, \"[^)]+\\)" rows "${rows}")
list(LENGTH enumerators expected)
list(LENGTH rows found)
if(NOT found OR NOT found EQUAL expected)
  message(FATAL_ERROR "land_mask.hpp: ${expected} masks, but ${found} rows that are read here")
endif()
set(masks "")
foreach(row IN LISTS rows)
  string(REGEX MATCH "\\(([a-z_]+), \"([^\"]*)\"" head "${row}")
  set(mask ${CMAKE_MATCH_1})
  if(NOT "${CMAKE_MATCH_2}" STREQUAL "" OR row MATCHES "kSeaKind")
    continue()
  endif()
  string(SUBSTRING ${mask} 0 1 first)
  string(SUBSTRING ${mask} 1 -1 rest)
  string(TOUPPER ${first} first)
  set(name Terrain_${first}${rest})
  set(macro Terrain_Mask_At_)
  if(signed MATCHES "LandMask::${mask}[^a-z_]")
    set(macro Terrain_Signed_Mask_At_)
  endif()
  string(APPEND masks
    "    #ifdef(${name}) #undef ${name} #end\n"
    "    #declare ${name} = function(x, z) { #if (Has_Map) ${macro}(${name}_Slice_) #else 0 #end }\n")
endforeach()

file(READ ${macros}/terrain.inc.in terrain_inc)
put_in(terrain_inc terrain_masks "${masks}")
put_in(terrain_inc terrain_sky "${light}${haze}")
put_in(terrain_inc terrain_view_planes "${planes}")
put_in(terrain_inc terrain_view_strips "${strips}")
put_in(terrain_inc terrain_view_faces "${faces}")
require_whole(terrain_inc)

file(READ ${macros}/coast.inc coast_inc)
foreach(file ocean terrain coast)
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/povray_macros/${file}.inc CONTENT "@${file}_inc@" @ONLY)
endforeach()
