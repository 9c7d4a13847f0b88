#pragma once

namespace arris::test {

/// A part of a page by the names of the buttons that show it.
struct PagePart {
  const char* page;
  const char* part; ///< null where the page has no parts
};

/// Of each page with parts the last is the one it opens with.
inline constexpr PagePart kPageParts[] = {{"pageJob", "showDrawing"},
                                          {"pageJob", "showProfile"},
                                          {"pageJob", "showBoth"},
                                          {"pageJob", "showPane"},
                                          {"pageJob", "showMore"},
                                          {"pageJob", "showGrinding"},
                                          {"pageSetup", "showByHand"},
                                          {"pageSetup", "showSimulation"},
                                          {"pageSetup", "showMoving"},
                                          {"pageRun", nullptr},
                                          {"pageProfiles", "profilesPositions"},
                                          {"pageProfiles", "profilesPath"},
                                          {"pageProfiles", "profilesSpeeds"},
                                          {"pageAlarms", "showSignals"},
                                          {"pageAlarms", "showBackUp"},
                                          {"pageAlarms", "showAlarms"},
                                          {"pageSettings", "settingsMachine"},
                                          {"pageSettings", "settingsCode"},
                                          {"pageSettings", "settingsWindow"},
                                          {"pageHelp", nullptr}};

} // namespace arris::test
