#pragma once
// The desktop that window tests run on: the same everywhere, whatever the machine's own looks like.

namespace netpocket {

// What the environment says about scale, theme, language and fonts no longer counts; only DejaVu fonts are found, and
// their letters are drawn alike. To be called before the application is made.
void leave_desktop();

// The style, colours and fonts of the application's windows; the cursor does not blink.
void use_plain_look();

}  // namespace netpocket
