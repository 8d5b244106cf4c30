# What `cmake --install` lays out: lib/, include/sectile/, lib/cmake/Sectile/ and bin/.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/Sectile)

install(TARGETS sectile_core EXPORT SectileTargets)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/core/include/sectile
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")
install(EXPORT SectileTargets NAMESPACE sectile:: DESTINATION ${config_folder})

configure_package_config_file(
  ${CMAKE_CURRENT_LIST_DIR}/SectileConfig.cmake.in ${PROJECT_BINARY_DIR}/SectileConfig.cmake
  INSTALL_DESTINATION ${config_folder})
write_basic_package_version_file(
  ${PROJECT_BINARY_DIR}/SectileConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/SectileConfig.cmake
              ${PROJECT_BINARY_DIR}/SectileConfigVersion.cmake
              ${CMAKE_CURRENT_LIST_DIR}/FindLib3MF.cmake
        DESTINATION ${config_folder})

if(TARGET sectile_cli)
  install(TARGETS sectile_cli)
endif()
set(documents ${CMAKE_INSTALL_DATADIR}/doc/sectile)
install(FILES ${PROJECT_SOURCE_DIR}/README.md DESTINATION ${documents})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${documents} RENAME copyright)

set(CPACK_PACKAGE_NAME sectile)
set(CPACK_PACKAGE_VENDOR "The Sectile authors")
set(CPACK_PACKAGE_CONTACT "The Sectile authors <sectile@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# The library's header files and archive are of use only with these.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libtbb-dev, libtinyobjloader-dev, lib3mf-dev, libzip-dev")
include(CPack)
