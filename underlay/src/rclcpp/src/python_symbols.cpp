// The middleware loads the Python halves of message packages into programs that have no Python in them. Their
// functions are looked up when they are called, which never happens; these two objects are looked up at once.
// In a Python process its own ones come first.

extern "C" {
__attribute__((weak)) void * PyExc_RuntimeError = nullptr;
__attribute__((weak)) long _Py_TrueStruct[8] = {};
}
