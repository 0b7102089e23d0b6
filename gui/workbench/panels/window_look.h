#pragma once
// How the whole window looks: the size of its letters, light or dark. Needs the application.
// Thread contract: the user interface's thread.

namespace netpocket {

enum class TypeSize { normal, larger, largest };
enum class Theme { system, light, dark };

// Letters of the desktop's size, or larger ones.
void use_type_size(TypeSize size);
// Of the letters in use against the desktop's: what draws its letters itself makes them as large.
double type_scale();

// `system` leaves colours and style to the desktop.
void use_theme(Theme theme);

}  // namespace netpocket
