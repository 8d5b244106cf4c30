// Contexts without a window, and the interface drawn over a picture.
#include <gtest/gtest.h>
#include <imgui.h>

#include <stdexcept>
#include <string_view>

#include "demo_pictures.h"
#include "drawn_pictures.h"
#include "render/embedded.h"
#include "render/image_difference.h"

namespace sectile::viewer {
namespace {

TEST(InterfaceDrawer, DrawsTheInterfaceOverThePicture) {
  const auto context = make_offscreen_context(width, height, 2);
  Renderer renderer(*context);
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.DisplaySize = {width / 2.0f, height / 2.0f};
  io.DisplayFramebufferScale = {2, 2};
  for (int round = 0; round < 2; ++round) {
    // The second time the font atlas was built anew.
    io.Fonts->Clear();
    ImFontConfig config;
    config.FontDataOwnedByAtlas = false;
    const std::string_view font = embedded_file("Inter-Regular.otf");
    io.Fonts->AddFontFromMemoryTTF(const_cast<char*>(font.data()), static_cast<int>(font.size()),
                                   30, &config);
    io.Fonts->Build();
    io.Fonts->SetTexID(nullptr);
    ImGui::NewFrame();
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    list.AddRectFilled({10, 10}, {60, 50}, IM_COL32(0, 128, 0, 255));
    list.AddText({80, 20}, IM_COL32(0, 0, 0, 255), "HHH");
    list.PushClipRect({100, 80}, {110, 90});
    list.AddRectFilled({0, 60}, {160, 120}, IM_COL32(0, 0, 255, 128));
    list.PopClipRect();
    ImGui::Render();
    renderer.begin_frame();
    renderer.draw(plain_picture(), {0, 0, width, height});
    renderer.draw(*ImGui::GetDrawData());
    const Image image = renderer.read_frame();
    EXPECT_EQ(at(image, 70, 60).g, 128);
    EXPECT_EQ(at(image, 70, 60).r, 0);
    EXPECT_EQ(at(image, 70, 110).r, 255);
    EXPECT_NEAR(at(image, 210, 170).r, 127, 1);
    EXPECT_EQ(at(image, 190, 170).r, 255);
    int dark = 0;
    for (int y = 40; y < 100; ++y)
      for (int x = 160; x < 240; ++x) dark += at(image, x, y).r < 100;
    EXPECT_GT(dark, 200);
    EXPECT_LT(dark, 2000);
  }
  ImGui::DestroyContext();
}

// On a machine without OSMesa the two are one.
TEST(OffscreenContext, EglDrawsAsOsmesaDoes) {
  const Picture picture = demo_pictures().front().picture;
  const auto drawn_in = [&](GraphicsContext& context) {
    Renderer renderer(context);
    renderer.begin_frame();
    renderer.draw(picture, {0, 0, 320, 240});
    return renderer.read_frame();
  };
  const auto chosen = make_offscreen_context(320, 240), egl = make_egl_context(320, 240);
  const Image by_egl = drawn_in(*egl);
  EXPECT_LT(compare_images(drawn_in(*chosen), by_egl).share, 0.001);
  EXPECT_EQ(drawn_in(*egl).rgba, by_egl.rgba) << "the contexts take turns";
}

TEST(OffscreenContext, RefusesImpossibleSizes) {
  EXPECT_THROW(make_offscreen_context(0, 100), std::runtime_error);
  EXPECT_THROW(make_offscreen_context(100, 100000), std::runtime_error);
  EXPECT_THROW(make_egl_context(0, 100), std::runtime_error);
}

}  // namespace
}  // namespace sectile::viewer
