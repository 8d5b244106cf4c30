// Mesa keeps memory until the process ends; LeakSanitizer is to look at our own only.
extern "C" const char* __lsan_default_suppressions();

extern "C" const char* __lsan_default_suppressions() {
  return "leak:libOSMesa\nleak:libEGL\nleak:libgallium\nleak:libLLVM\nleak:libGLX\nleak:swrast_"
         "dri\nleak:libX11\nleak:libglfw\n";
}
