# Meshes from files: the one part of caustics that needs VTK.
find_package(VTK 9.1 REQUIRED COMPONENTS CommonCore CommonDataModel CommonExecutionModel FiltersCore)

waterlight_library(caustics_files objects/mesh_file.cpp objects/obj_file.cpp objects/ply_file.cpp
    objects/stl_file.cpp)
target_link_libraries(waterlight_caustics_files PUBLIC glm::glm
    PRIVATE fmt::fmt VTK::CommonCore VTK::CommonDataModel VTK::CommonExecutionModel VTK::FiltersCore)
