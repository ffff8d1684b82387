// Campaign files in.  What is not understood in full is refused with one message: file,
// line and column, JSON pointer, what is there and what was expected.
#pragma once

#include <string>

#include "campaign/campaign.h"

namespace colloid {

/// Reads the campaign, and its scene file if it names one, and checks all but the scene.
Campaign read_campaign(const std::string& path);

/// The same for JSON text; `path` names it in messages and anchors the scene's file.
Campaign parse_campaign(const std::string& text, const std::string& path);

/// Throws the InputError for the value at `pointer` of the campaign's file.
[[noreturn]] void refuse(const Campaign& campaign, const std::string& pointer,
                         const std::string& why);

/// May this be a campaign's name?  It becomes the name of a folder, a word on command
/// lines and a heading of reports, so it is kept to letters, digits and ._- .
bool is_campaign_name(const std::string& name);

}  // namespace colloid
