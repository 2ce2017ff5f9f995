// Numbers of a variant's constants; C++ and GLSL include the same text.

#define SCATTER_NONE 0
#define SCATTER_FLAT 1
#define SCATTER_VOLUME 2

#define OVERLAY_NONE 0
#define OVERLAY_ELEVATION 1
#define OVERLAY_FLOOR 2
#define OVERLAY_ERROR 3

#define KIND_FLOOR 0
#define KIND_WALLS 1
#define KIND_DECK 2
