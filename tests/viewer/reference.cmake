# Pictures beside the kept ones in reference/.
sectile_test(reference_test
  SOURCES reference_test.cpp interface_reference_test.cpp reference_pictures.cpp app_driver.cpp
          leaks.cpp
  LIBRARIES sectile_viewer_program sectile_viewer_app)
target_compile_definitions(reference_test PRIVATE
  SECTILE_REFERENCE_FOLDER="${CMAKE_CURRENT_SOURCE_DIR}/reference"
  SECTILE_NEW_PICTURES_FOLDER="${CMAKE_CURRENT_BINARY_DIR}/pictures")
