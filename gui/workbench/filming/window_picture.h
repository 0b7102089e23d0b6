#pragma once
// Pictures of a window as one sees it, whichever way its views are drawn, with the menus, dialogs and tips over it.
// Thread contract: the user interface's thread.

#include <QImage>

class QWidget;

namespace netpocket {

// Paints the whole window anew, in device pixels.
QImage window_picture(QWidget& window);

// For videos: copies what was painted last where the platform keeps it, and adds the mouse pointer. Costs a fraction of
// window_picture().
QImage window_frame(QWidget& window);

}  // namespace netpocket
