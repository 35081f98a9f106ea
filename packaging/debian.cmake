# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
# The Debian packages: their files beside those of `cmake --install`, their names and what they need.

# A window of ocean-preview opens a file of ours by a double click. The type shares its pattern with
# TOML and is told apart by its first lines, which works only beside the system's own types in /usr.
install(FILES ocean-preview.desktop DESTINATION share/applications COMPONENT preview EXCLUDE_FROM_ALL)
install(FILES ocean-preview.svg DESTINATION share/icons/hicolor/scalable/apps
        COMPONENT preview EXCLUDE_FROM_ALL)
install(FILES libocean.xml DESTINATION share/mime/packages COMPONENT preview EXCLUDE_FROM_ALL)

install(FILES ocean-bridge.service DESTINATION lib/systemd/system COMPONENT bridge EXCLUDE_FROM_ALL)
install(FILES ocean-bridge.default DESTINATION /etc/default RENAME ocean-bridge
        COMPONENT bridge EXCLUDE_FROM_ALL)
install(FILES ${PROJECT_SOURCE_DIR}/libocean/bridge/PROTOCOL.md DESTINATION share/doc/ocean-bridge
        COMPONENT bridge EXCLUDE_FROM_ALL)

set(python_folder lib/python3/dist-packages)
set(wrapper ${PROJECT_SOURCE_DIR}/libocean/python)
install(DIRECTORY ${wrapper}/libocean DESTINATION ${python_folder}
        COMPONENT python EXCLUDE_FROM_ALL
        FILES_MATCHING PATTERN "*.py" PATTERN "py.typed" PATTERN "__pycache__" EXCLUDE)
set(metadata libocean-${PROJECT_VERSION}.dist-info)
execute_process(COMMAND ${Python3_EXECUTABLE} -B -c "import make_wheel; print(make_wheel.metadata())"
  WORKING_DIRECTORY ${wrapper} OUTPUT_VARIABLE metadata_text COMMAND_ERROR_IS_FATAL ANY)
file(CONFIGURE OUTPUT METADATA CONTENT "@metadata_text@" @ONLY)
# The list of the files, which pip shows. Their hashes are those of the package, which dpkg checks.
file(GLOB recorded RELATIVE ${wrapper} CONFIGURE_DEPENDS
     ${wrapper}/libocean/*.py ${wrapper}/libocean/py.typed)
list(APPEND recorded ${metadata}/METADATA ${metadata}/RECORD)
list(JOIN recorded ",,\n" record_text)
file(CONFIGURE OUTPUT RECORD CONTENT "@record_text@,,\n" @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/METADATA ${CMAKE_CURRENT_BINARY_DIR}/RECORD
        DESTINATION ${python_folder}/${metadata} COMPONENT python EXCLUDE_FROM_ALL)

set(macros ${PROJECT_SOURCE_DIR}/povray_macros)
install(DIRECTORY ${PROJECT_BINARY_DIR}/povray_macros/
        DESTINATION share/povray-3.7/include COMPONENT povray EXCLUDE_FROM_ALL)
install(DIRECTORY ${macros}/examples DESTINATION share/doc/povray-ocean
        COMPONENT povray EXCLUDE_FROM_ALL)
set(coast ${PROJECT_SOURCE_DIR}/renders/coast)
install(FILES ${coast}/beach.toml ${coast}/bay.toml DESTINATION share/doc/povray-ocean/examples
        COMPONENT povray EXCLUDE_FROM_ALL)
install(FILES ${macros}/README.md DESTINATION share/doc/povray-ocean
        COMPONENT povray EXCLUDE_FROM_ALL)

# The guides: all of them beside the command, and those of a host in its own package.
function(ocean_guides package component)
  list(TRANSFORM ARGN PREPEND ${PROJECT_SOURCE_DIR}/docs/)
  install(FILES ${ARGN} DESTINATION share/doc/${package}/guides
          COMPONENT ${component} EXCLUDE_FROM_ALL)
endfunction()
file(GLOB guides CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/docs ${PROJECT_SOURCE_DIR}/docs/*.md)
set(sea_guides sea_file.md parameters.md measured_seas.md)
ocean_guides(ocean-tools tools ${guides})
ocean_guides(ocean-preview preview preview.md ${sea_guides})
ocean_guides(ocean-bridge bridge bridge.md)
ocean_guides(povray-ocean povray povray.md)
ocean_guides(blender-ocean blender blender.md ${sea_guides})
ocean_guides(python3-libocean python python.md ${sea_guides})
ocean_guides(libocean-dev library c.md ${sea_guides})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/tests/package/c ${PROJECT_SOURCE_DIR}/tests/package/cpp
        DESTINATION share/doc/libocean-dev/examples COMPONENT library EXCLUDE_FROM_ALL)

set(addon ${PROJECT_SOURCE_DIR}/blender_addon)
install(DIRECTORY ${addon}/libocean_addon DESTINATION share/blender/scripts/addons
        COMPONENT blender EXCLUDE_FROM_ALL
        FILES_MATCHING PATTERN "*.py" PATTERN "*.po" PATTERN "*.json" PATTERN "*.jpg" PATTERN "__pycache__" EXCLUDE)
install(FILES ${addon}/examples/scene.py DESTINATION share/doc/blender-ocean/examples
        COMPONENT blender EXCLUDE_FROM_ALL)
install(FILES ${addon}/README.md DESTINATION share/blender/scripts/addons/libocean_addon
        COMPONENT blender EXCLUDE_FROM_ALL)

# The day of the change log is that of SOURCE_DATE_EPOCH, which scripts/packages takes from the commit.
set(OCEAN_MAINTAINER "The libocean authors <libocean@example.org>" CACHE STRING
    "Who answers for the Debian packages, NAME <ADDRESS>: set it for packages that others get")
set(CPACK_DEBIAN_PACKAGE_MAINTAINER ${OCEAN_MAINTAINER})
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
string(TIMESTAMP day "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(CONFIGURE OUTPUT changelog.Debian CONTENT
"libocean (@PROJECT_VERSION@-@CPACK_DEBIAN_PACKAGE_RELEASE@) unstable; urgency=medium

  * Release @PROJECT_VERSION@; CHANGELOG.md of the sources has its changes.

 -- @CPACK_DEBIAN_PACKAGE_MAINTAINER@  @day@
" @ONLY)
execute_process(COMMAND gzip -9nkf changelog.Debian
  WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR} COMMAND_ERROR_IS_FATAL ANY)

# debian_package(NAME COMPONENT SUMMARY TEXT [VARIABLE value]...): a package of a component or group.
# Its scripts and other files of control lie in maintainer/NAME.
function(debian_package name component summary text)
  string(TOUPPER ${component} upper)
  set(prefix CPACK_DEBIAN_${upper}_PACKAGE)
  set(${prefix}_NAME ${name} PARENT_SCOPE)
  set(CPACK_COMPONENT_${upper}_DESCRIPTION "${summary}\n${text}" PARENT_SCOPE)
  set(CPACK_COMPONENT_GROUP_${upper}_DESCRIPTION "${summary}\n${text}" PARENT_SCOPE)
  file(GLOB control CONFIGURE_DEPENDS maintainer/${name}/*)
  set(${prefix}_CONTROL_EXTRA "${control}" PARENT_SCOPE)
  while(ARGN)
    list(POP_FRONT ARGN variable value)
    set(${prefix}_${variable} "${value}" PARENT_SCOPE)
  endwhile()
  set(first_component ${component})
  if(component STREQUAL "dev")
    set(first_component library)
  endif()
  install(FILES copyright ${CMAKE_CURRENT_BINARY_DIR}/changelog.Debian.gz
          DESTINATION share/doc/${name} COMPONENT ${first_component} EXCLUDE_FROM_ALL)
endfunction()

set(same "(= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})")
debian_package(libocean1 runtime "statistical ocean in real units, shared library"
"From a wind, a sea state or a measured spectrum to the heights, normals, foam
and velocities of the water, on land and coasts too. This is the library with
its C interface, which programs and the Python package use."
  SECTION libs SHLIBDEPS ON)
debian_package(libocean-dev dev "statistical ocean in real units, development files"
"Headers of C and C++, static libraries of C++ and a CMake package. The C
interface is stable; that of C++ may change until version 1.0."
  SECTION libdevel DEPENDS "libocean1 ${same}, zlib1g-dev"
  RECOMMENDS "cmake, pkg-config, libepoxy-dev, libopenexr-dev, libpng-dev, libssl-dev, libtiff-dev"
  SUGGESTS "ocean-tools")
debian_package(python3-libocean python "statistical ocean in real units as NumPy arrays"
"Seas, terrains and coasts by their parameters, as arrays of height,
displacement, normal, foam and velocity, at any time and any point."
  SECTION python ARCHITECTURE all
  DEPENDS "python3 (>= 3.10), python3:any, python3-numpy, libocean1 ${same}")
debian_package(ocean-tools tools "command line of the statistical ocean"
"The command ocean bakes a sea or a terrain into OpenEXR, OpenVDB, USD, PLY,
OBJ, GeoTIFF and PNG files, writes folders for POV-Ray, reads the spectra that
buoys measured and prints spectra, gauges and statistics."
  SECTION graphics SHLIBDEPS ON DEPENDS "libegl1"
  RECOMMENDS "libgl1-mesa-dri, ocean-terrain" SUGGESTS "povray-ocean, ocean-preview, blender-ocean")
if(OCEAN_BUILD_GDAL)
  debian_package(ocean-terrain terrain "reader of elevation models for the statistical ocean"
"With it the command ocean imports the rasters of geographers, GeoTIFF above
all, as land and as the beds of coasts. It reads them by GDAL in a process of
its own, without network."
    SECTION graphics SHLIBDEPS ON DEPENDS "ocean-tools ${same}")
endif()
debian_package(ocean-preview preview "window on the statistical ocean"
"Shows a sea, a terrain or a coast to its horizon in a window, with all of its
parameters as sliders, or writes pictures without one. Needs OpenGL 4.1."
  SECTION graphics SHLIBDEPS ON DEPENDS "libegl1, libgl1"
  RECOMMENDS "libgl1-mesa-dri" SUGGESTS "ocean-bridge, zenity")
debian_package(ocean-bridge bridge "knobs of boards set the statistical ocean"
"Reads Velleman K8055 and Firmata boards, MIDI controllers and OSC, and hands
their values to all programs that show the sea. It has a service for systemd,
which is not started by itself, and a rule of udev for the boards."
  SECTION graphics SHLIBDEPS ON SUGGESTS "ocean-preview")
debian_package(povray-ocean povray "statistical ocean for POV-Ray"
"Macros for the seas, terrains and coasts that the command ocean writes: meshes,
water, foam, skies and floating bodies, found by every scene."
  SECTION graphics ARCHITECTURE all DEPENDS "povray (>= 1:3.7)"
  RECOMMENDS "ocean-tools")
debian_package(blender-ocean blender "statistical ocean for Blender"
"An add-on for the Blender of Debian: a sea, a terrain or a coast as an object,
the same as in all other programs of libocean. Enable it in the preferences."
  SECTION graphics ARCHITECTURE all
  DEPENDS "blender (>= 3.4), python3-numpy, python3-libocean ${same}"
  RECOMMENDS "ocean-tools")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME libocean)
set(CPACK_PACKAGE_VENDOR "The libocean authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # or it would be the first line of all descriptions
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_COMPONENTS_ALL runtime library development python tools preview bridge povray blender)
if(OCEAN_BUILD_GDAL)
  list(APPEND CPACK_COMPONENTS_ALL terrain)
endif()
include(CPack)
cpack_add_component_group(dev)
cpack_add_component(library GROUP dev)
cpack_add_component(development GROUP dev)
