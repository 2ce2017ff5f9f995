find_package(VTK 9.1 REQUIRED COMPONENTS CommonCore CommonDataModel IOImage IOXML)
find_package(PkgConfig REQUIRED)
pkg_check_modules(OPENEXR REQUIRED IMPORTED_TARGET OpenEXR)

waterlight_test(test_export_files SOURCES unit/export_files.cpp LIBRARIES waterlight::export)
waterlight_test(test_export_queue SOURCES unit/export_queue.cpp LIBRARIES waterlight::export)
waterlight_test(test_export_series SOURCES unit/export_series.cpp unit/export_kill.cpp
    LIBRARIES waterlight::export waterlight::sim_files VTK::CommonDataModel VTK::IOXML)
waterlight_test(test_export_pictures SOURCES unit/export_pictures.cpp unit/export_exr.cpp
    LIBRARIES waterlight::export VTK::CommonCore VTK::CommonDataModel VTK::IOImage PkgConfig::OPENEXR)
# OpenEXR wants -pthread, for which the others' headers are not compiled.
set_target_properties(test_export_pictures PROPERTIES DISABLE_PRECOMPILE_HEADERS ON)
waterlight_test(test_vti_reader SOURCES unit/export_reader.cpp
    LIBRARIES waterlight::export waterlight::sim_files fmt::fmt VTK::CommonDataModel VTK::IOXML)

# A series written here is read back by VTK's Python, and compared with raw dumps of what went in.
add_executable(export_dump unit/export_dump.cpp)
target_link_libraries(export_dump PRIVATE waterlight_flags waterlight::export fmt::fmt)
set(dump ${CMAKE_CURRENT_BINARY_DIR}/export_dump.out)
add_test(NAME export_dump COMMAND export_dump ${dump})
add_test(NAME export_read_back COMMAND /usr/bin/python3 ${CMAKE_CURRENT_LIST_DIR}/support/read_back.py ${dump})
set_tests_properties(export_dump PROPERTIES FIXTURES_SETUP export_dump)
set_tests_properties(export_read_back PROPERTIES FIXTURES_REQUIRED export_dump TIMEOUT 120)
