// Draws what Dear ImGui made.
#pragma once

#include "render/gl_objects.h"
#include "render/shader_program.h"

struct ImDrawCmd;
struct ImDrawData;
struct ImFontAtlas;

namespace sectile::viewer {

class InterfaceDrawer {
 public:
  InterfaceDrawer();
  void draw(const ImDrawData& interface, int frame_width, int frame_height);

 private:
  void upload_fonts(ImFontAtlas& fonts);
  void draw_command(const ImDrawData& interface, const ImDrawCmd& command, int frame_height);

  ShaderProgram program_;
  GlVertexArray layout_;
  GlBuffer vertices_, indices_;
  GlTexture font_texture_;
};

}  // namespace sectile::viewer
