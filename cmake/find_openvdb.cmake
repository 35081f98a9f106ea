# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
# OpenVDB::openvdb, where OpenVDB is. Its module lies in a folder with others that would stand
# before CMake's own, and says what it looks for even if it is told to be quiet. It ends CMake where
# Boost's iostreams are missing, which OpenVDB's own package does not bring.
find_path(OCEAN_OPENVDB_MODULE FindOpenVDB.cmake PATH_SUFFIXES
  lib/${CMAKE_LIBRARY_ARCHITECTURE}/cmake/OpenVDB lib/cmake/OpenVDB lib64/cmake/OpenVDB)
mark_as_advanced(OCEAN_OPENVDB_MODULE)
find_package(Boost QUIET COMPONENTS iostreams)
if(OCEAN_OPENVDB_MODULE AND Boost_FOUND)
  list(APPEND CMAKE_MODULE_PATH ${OCEAN_OPENVDB_MODULE})
  set(libocean_log_level ${CMAKE_MESSAGE_LOG_LEVEL})
  set(CMAKE_MESSAGE_LOG_LEVEL WARNING)
  find_package(OpenVDB 9 QUIET COMPONENTS openvdb)
  set(CMAKE_MESSAGE_LOG_LEVEL ${libocean_log_level})
  list(REMOVE_ITEM CMAKE_MODULE_PATH ${OCEAN_OPENVDB_MODULE})
endif()
