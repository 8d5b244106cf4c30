// Pictograms of Font Awesome 4.7, and some of our own (set_signs.h), as UTF-8, to be put into texts
// of the interface.
#pragma once

namespace sectile::viewer::icons {

inline constexpr const char* venn_union = "\ue001";
inline constexpr const char* venn_intersection = "\ue002";
inline constexpr const char* venn_difference = "\ue003";

inline constexpr const char* filter = "\uf0b0";
inline constexpr const char* file = "\uf15b";
inline constexpr const char* folder_open = "\uf07c";
inline constexpr const char* save = "\uf0c7";
inline constexpr const char* download = "\uf019";
inline constexpr const char* upload = "\uf093";
inline constexpr const char* picture = "\uf03e";
inline constexpr const char* undo = "\uf0e2";
inline constexpr const char* redo = "\uf01e";
inline constexpr const char* copy = "\uf0c5";
inline constexpr const char* trash = "\uf1f8";
inline constexpr const char* pencil = "\uf040";
inline constexpr const char* plus = "\uf067";
inline constexpr const char* minus = "\uf068";
inline constexpr const char* cross = "\uf00d";
inline constexpr const char* check = "\uf00c";
inline constexpr const char* cube = "\uf1b2";
inline constexpr const char* cubes = "\uf1b3";
inline constexpr const char* group = "\uf247";
inline constexpr const char* ungroup = "\uf248";
inline constexpr const char* eye = "\uf06e";
inline constexpr const char* eye_slash = "\uf070";
inline constexpr const char* move = "\uf047";
inline constexpr const char* rotate = "\uf021";
inline constexpr const char* resize = "\uf065";
inline constexpr const char* magnet = "\uf076";
inline constexpr const char* globe = "\uf0ac";
inline constexpr const char* crosshairs = "\uf05b";
inline constexpr const char* search = "\uf002";
inline constexpr const char* scissors = "\uf0c4";
inline constexpr const char* play = "\uf04b";
inline constexpr const char* pause = "\uf04c";
inline constexpr const char* step_back = "\uf048";
inline constexpr const char* step_forward = "\uf051";
inline constexpr const char* fast_back = "\uf049";
inline constexpr const char* fast_forward = "\uf050";
inline constexpr const char* star = "\uf005";
inline constexpr const char* flag = "\uf024";
inline constexpr const char* sliders = "\uf1de";
inline constexpr const char* gear = "\uf013";
inline constexpr const char* sun = "\uf185";
inline constexpr const char* moon = "\uf186";
inline constexpr const char* camera = "\uf030";
inline constexpr const char* home = "\uf015";
inline constexpr const char* question = "\uf128";
inline constexpr const char* info = "\uf05a";
inline constexpr const char* warning = "\uf071";
inline constexpr const char* error = "\uf06a";
inline constexpr const char* spinner = "\uf110";
inline constexpr const char* grid = "\uf00a";
inline constexpr const char* list = "\uf03a";
inline constexpr const char* table = "\uf0ce";
inline constexpr const char* tag = "\uf02b";
inline constexpr const char* adjust = "\uf042";
inline constexpr const char* palette = "\uf1fc";
inline constexpr const char* chevron_right = "\uf054";
inline constexpr const char* chevron_down = "\uf078";
inline constexpr const char* keyboard = "\uf11c";
inline constexpr const char* mouse_pointer = "\uf245";
inline constexpr const char* expand = "\uf0b2";
inline constexpr const char* history = "\uf1da";
inline constexpr const char* stop = "\uf04d";
inline constexpr const char* bug = "\uf188";

}  // namespace sectile::viewer::icons
