// An off-screen context of EGL without any surface of a desktop, for systems whose Mesa has no
// OSMesa any more. The library is opened at run time, as OSMesa's is.
#include <dlfcn.h>

#include <array>
#include <stdexcept>
#include <string>

#include "render/current_context.h"

namespace sectile::viewer {
namespace {

// From EGL/egl.h and EGL/eglext.h, of which nothing else is needed to build.
using Display = void*;
using Config = void*;
using Device = void*;
constexpr unsigned egl_opengl_api = 0x30A2, egl_platform_surfaceless = 0x31DD,
                   egl_platform_device = 0x313F;
constexpr int egl_none = 0x3038, egl_extensions = 0x3055, egl_surface_type = 0x3033,
              egl_pbuffer_bit = 0x0001, egl_renderable_type = 0x3040, egl_opengl_bit = 0x0008,
              egl_red_size = 0x3024, egl_green_size = 0x3023, egl_blue_size = 0x3022,
              egl_alpha_size = 0x3021, egl_depth_size = 0x3025, egl_stencil_size = 0x3026,
              egl_width = 0x3057, egl_height = 0x3056, egl_major_version = 0x3098,
              egl_minor_version = 0x30FB, egl_profile_mask = 0x30FD, egl_core_profile = 0x0001;

class Library {
 public:
  static const Library& get() {
    static const Library library;
    return library;
  }

  Display display = nullptr;
  unsigned (*choose)(Display, const int* wanted, Config* found, int room, int* count) = nullptr;
  unsigned (*bind_api)(unsigned) = nullptr;
  void* (*create)(Display, Config, void* share, const int* attributes) = nullptr;
  void* (*create_surface)(Display, Config, const int* attributes) = nullptr;
  unsigned (*destroy)(Display, void* context) = nullptr;
  unsigned (*destroy_surface)(Display, void* surface) = nullptr;
  unsigned (*make_current)(Display, void* draw, void* read, void* context) = nullptr;
  void (*(*get_function)(const char* name))() = nullptr;

 private:
  using GetDisplay = Display (*)(unsigned platform, void* native, const std::intptr_t* attributes);
  using Initialize = unsigned (*)(Display, int* major, int* minor);

  Library() : handle_(dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL)) {
    if (!handle_)
      throw std::runtime_error(
          std::string("Pictures without a display need Mesa's off-screen library (Debian package "
                      "libosmesa6) or EGL (libegl1 and libegl-mesa0): ") +
          dlerror());
    find(choose, "eglChooseConfig");
    find(bind_api, "eglBindAPI");
    find(create, "eglCreateContext");
    find(create_surface, "eglCreatePbufferSurface");
    find(destroy, "eglDestroyContext");
    find(destroy_surface, "eglDestroySurface");
    find(make_current, "eglMakeCurrent");
    find(get_function, "eglGetProcAddress");
    GetDisplay get_display = nullptr;
    Initialize initialize = nullptr;
    find(get_display, "eglGetPlatformDisplay");
    find(initialize, "eglInitialize");
    // Software draws the same on all machines; what else there is will do where it is missing.
    if (Device software = software_device())
      display = get_display(egl_platform_device, software, nullptr);
    int major = 0, minor = 0;
    if (display && initialize(display, &major, &minor)) return;
    display = get_display(egl_platform_surfaceless, nullptr, nullptr);
    if (!display || !initialize(display, &major, &minor))
      throw std::runtime_error(
          "EGL gives no display without a screen (is libegl-mesa0 installed?)");
  }

  /// Null if there is none, or no way to ask.
  Device software_device() const {
    unsigned (*query)(int room, Device* devices, int* count) = nullptr;
    const char* (*query_text)(Device, int name) = nullptr;
    query = reinterpret_cast<decltype(query)>(get_function("eglQueryDevicesEXT"));
    query_text = reinterpret_cast<decltype(query_text)>(get_function("eglQueryDeviceStringEXT"));
    std::array<Device, 16> devices{};
    int count = 0;
    if (!query || !query_text || !query(static_cast<int>(devices.size()), devices.data(), &count))
      return nullptr;
    for (int i = 0; i < count; ++i) {
      Device device = devices[static_cast<std::size_t>(i)];
      const char* extensions = query_text(device, egl_extensions);
      if (extensions &&
          std::string(extensions).find("EGL_MESA_device_software") != std::string::npos)
        return device;
    }
    return nullptr;
  }

  template <typename FunctionPointer>
  void find(FunctionPointer& function, const char* name) {
    function = reinterpret_cast<FunctionPointer>(dlsym(handle_, name));
    if (!function) throw std::runtime_error(std::string("libEGL.so.1 has no ") + name);
  }

  void* handle_;  // never closed: Mesa's threads may still run in it
};

class EglContext final : public TurnTakingContext {
 public:
  EglContext(int width, int height, float scale) : width_(width), height_(height), scale_(scale) {
    check_size(width, height);
    const Library& egl = Library::get();
    const Config config = chosen();
    const int size[] = {egl_width, width, egl_height, height, egl_none};
    surface_ = egl.create_surface(egl.display, config, size);
    const int version[] = {egl_major_version, 3,       egl_minor_version, 3, egl_profile_mask,
                           egl_core_profile,  egl_none};
    egl.bind_api(egl_opengl_api);
    context_ = egl.create(egl.display, config, nullptr, version);
    if (surface_ && context_) return;
    destroy();
    throw std::runtime_error("EGL gives no OpenGL 3.3 context");
  }
  ~EglContext() override {
    retire();
    destroy();
  }
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  int width() const override { return width_; }
  int height() const override { return height_; }
  float scale() const override { return scale_; }
  void present() override {}

 protected:
  void bind() override {
    const Library& egl = Library::get();
    egl.bind_api(egl_opengl_api);
    if (!egl.make_current(egl.display, surface_, surface_, context_))
      throw std::runtime_error("The EGL context cannot be made current");
  }
  void unbind() override {
    const Library& egl = Library::get();
    egl.make_current(egl.display, nullptr, nullptr, nullptr);
  }
  Loader loader() const override { return Library::get().get_function; }

 private:
  static Config chosen() {
    const Library& egl = Library::get();
    const int wanted[] = {egl_surface_type,
                          egl_pbuffer_bit,
                          egl_renderable_type,
                          egl_opengl_bit,
                          egl_red_size,
                          8,
                          egl_green_size,
                          8,
                          egl_blue_size,
                          8,
                          egl_alpha_size,
                          8,
                          egl_depth_size,
                          24,
                          egl_stencil_size,
                          8,
                          egl_none};
    Config config = nullptr;
    int count = 0;
    if (!egl.choose(egl.display, wanted, &config, 1, &count) || count < 1)
      throw std::runtime_error("EGL has no pictures of 8 bits for each colour");
    return config;
  }

  void destroy() {
    const Library& egl = Library::get();
    if (context_) egl.destroy(egl.display, context_);
    if (surface_) egl.destroy_surface(egl.display, surface_);
  }

  int width_, height_;
  float scale_;
  void* surface_ = nullptr;
  void* context_ = nullptr;
};

}  // namespace

std::unique_ptr<GraphicsContext> make_egl_context(int width, int height, float scale) {
  return std::make_unique<EglContext>(width, height, scale);
}

}  // namespace sectile::viewer
