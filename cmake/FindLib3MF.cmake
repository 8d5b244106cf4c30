# lib3mf 1.8, the interface of Debian 12 and 13, and the libzip it is built on: Lib3MF::Lib3MF.
# Debian's own files do not serve: lib3MF.pc asks for libraries that its package does not bring, and
# libzip's targets for programs of another package.
find_path(Lib3MF_INCLUDE_DIR Model/COM/NMR_DLLInterfaces.h PATH_SUFFIXES lib3mf)
find_library(Lib3MF_LIBRARY 3MF)
find_path(Lib3MF_ZIP_INCLUDE_DIR zip.h)
find_library(Lib3MF_ZIP_LIBRARY zip)
mark_as_advanced(Lib3MF_INCLUDE_DIR Lib3MF_LIBRARY Lib3MF_ZIP_INCLUDE_DIR Lib3MF_ZIP_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Lib3MF REQUIRED_VARS
  Lib3MF_LIBRARY Lib3MF_INCLUDE_DIR Lib3MF_ZIP_LIBRARY Lib3MF_ZIP_INCLUDE_DIR)

if(Lib3MF_FOUND AND NOT TARGET Lib3MF::Lib3MF)
  add_library(Lib3MF::Lib3MF UNKNOWN IMPORTED)
  set_target_properties(Lib3MF::Lib3MF PROPERTIES
    IMPORTED_LOCATION "${Lib3MF_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${Lib3MF_INCLUDE_DIR};${Lib3MF_ZIP_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES "${Lib3MF_ZIP_LIBRARY}")
endif()
