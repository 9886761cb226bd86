/// The HTML page of ref/viewer, made one text at build time (ref/viewer/embed.cmake).
#pragma once

namespace flatdt::ref {

/// The page, with "@DATA@" once, where the JSON text of the scene belongs.
extern const char* const kViewerPage;

}  // namespace flatdt::ref
