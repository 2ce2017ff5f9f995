# Meshes from files.
waterlight_test(mesh_file_test
    SOURCES unit/mesh_file_test.cpp
    LIBRARIES waterlight::caustics waterlight::caustics_files fmt::fmt)
