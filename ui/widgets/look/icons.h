/// The icons of the product: code points of Font Awesome 4.7. Inside this corner only.
#pragma once

#include <array>

namespace hallux::ui {

enum class Icon : unsigned {
  None = 0,
  Home = 0xF015,
  Operations = 0xF02D,
  History = 0xF201,
  Messages = 0xF086,
  Backup = 0xF1C0,
  Help = 0xF059,
  More = 0xF142,
  Inbox = 0xF01C,
  Cohort = 0xF00A,
  Ratings = 0xF0AE,
  Scenarios = 0xF0C4,
  Live = 0xF108,
  People = 0xF0C0,
  Cohorts = 0xF19D,
  Devices = 0xF1DE,
  Audit = 0xF0CA,
  Search = 0xF002,
  Add = 0xF067,
  Import = 0xF093,
  Export = 0xF019,
  Copy = 0xF0C5,
  Compare = 0xF24D,
  Flag = 0xF024,
  Play = 0xF04B,
  Pause = 0xF04C,
  Back = 0xF048,
  Next = 0xF051,
  Branch = 0xF126,
  Send = 0xF1D8,
  Expand = 0xF0B2,
  Clock = 0xF017,
  Drill = 0xF140,
  Irrigation = 0xF043,
  Eye = 0xF06E,
  EyeOff = 0xF070,
  Lock = 0xF023,
  Dark = 0xF186,
  Light = 0xF185,
  Language = 0xF0AC,
  Close = 0xF00D,
  Delete = 0xF014,
  SortUp = 0xF0D8,
  SortDown = 0xF0D7,
  Left = 0xF053,
  Right = 0xF054,
  SignOut = 0xF08B,
  Settings = 0xF013,
  Stop = 0xF04D,
  Note = 0xF24A,
  Check = 0xF00C,
  Folder = 0xF07B,
  File = 0xF15B,
  Up = 0xF062,
  Less = 0xF068,
};

/// Every icon but None: what the atlas must hold.
inline constexpr std::array all_icons{
    Icon::Home,      Icon::Operations, Icon::History,    Icon::Messages, Icon::Backup,
    Icon::Help,      Icon::More,       Icon::Inbox,      Icon::Cohort,   Icon::Ratings,
    Icon::Scenarios, Icon::Live,       Icon::People,     Icon::Cohorts,  Icon::Devices,
    Icon::Audit,     Icon::Search,     Icon::Add,        Icon::Import,   Icon::Export,
    Icon::Copy,      Icon::Compare,    Icon::Flag,       Icon::Play,     Icon::Pause,
    Icon::Back,      Icon::Next,       Icon::Branch,     Icon::Send,     Icon::Expand,
    Icon::Clock,     Icon::Drill,      Icon::Irrigation, Icon::Eye,      Icon::EyeOff,
    Icon::Lock,      Icon::Dark,       Icon::Light,      Icon::Language, Icon::Close,
    Icon::Delete,    Icon::SortUp,     Icon::SortDown,   Icon::Left,     Icon::Right,
    Icon::SignOut,   Icon::Settings,   Icon::Stop,       Icon::Note,     Icon::Check,
    Icon::Folder,    Icon::File,       Icon::Up,         Icon::Less};

/// Icon heights by use, in logical pixels of the font: 13, 16, 20, 30.
enum class IconSize { Inline, Control, Tile, Empty };

}  // namespace hallux::ui
