#pragma once
// Texts of figures (render/figures/rich_text.h) as Qt's HTML.

#include <QString>
#include <string_view>

namespace netpocket {

QString to_html(std::string_view markup);

}  // namespace netpocket
