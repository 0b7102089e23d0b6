#include "engine/scenario/check_pocket.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <string>

#include "engine/math/elementary.h"
#include "engine/scenario/check_control.h"
#include "engine/scenario/check_overlaps.h"
#include "engine/scenario/check_scenario.h"
#include "engine/scenario/fidelity.h"
#include "engine/scenario/pocket_outline.h"
#include "engine/scenario/pocket_tether.h"
#include "engine/scenario/sector_scatter.h"

namespace netpocket {
namespace {

class PocketChecker {
 public:
  PocketChecker(const Scenario& scenario, const Shape* target, Diagnostics& problems)
      : s_(scenario), target_(target), found_(problems) {}

  void run() {
    check_sections();
    check_profile();
    if (!found_.ok()) return;
    // The following checks need a valid profile.
    check_mesh();
    check_sector_scatter(s_, found_);
    check_pocket_tether(s_, found_);
    check_closing();
    check_control(s_, found_);
    if (target_ != nullptr) check_overlaps(s_, *target_, found_);
  }

 private:
  void add(std::string_view key, std::string message) {
    found_.add({.key = std::string(key), .message = std::move(message)});
  }

  void check_sections() {
    const double radius = s_.rods.outer_diameter / 2;
    for (const auto& [key, wall] :
         {std::pair("rods.wall_lower", s_.rods.wall_lower), {"rods.wall_upper", s_.rods.wall_upper}}) {
      if (wall > radius) add(key, fmt::format("a wall of {} m does not fit into the outer radius {} m", wall, radius));
    }
  }

  void check_profile() {
    const auto& profile = s_.rods.profile;
    if (profile.size() != 3) {
      add("rods.profile", fmt::format("needs exactly three points (root, kink, tip), not {}", profile.size()));
      return;
    }
    for (const auto& point : profile) {
      if (point.x() < s_.rods.outer_diameter) {
        add("rods.profile", fmt::format("a rod {} m from the axis is nearer than its diameter {} m", point.x(),
                                        s_.rods.outer_diameter));
        return;
      }
    }
    check_gaps_between_rods();
    if (profile[1].y() <= profile[0].y() || profile[2].y() <= profile[1].y()) {
      add("rods.profile", fmt::format("the heights of root, kink and tip must increase, not go {}, {}, {} m",
                                      profile[0].y(), profile[1].y(), profile[2].y()));
    }
  }

  void check_gaps_between_rods() {
    const double chord = 2 * sine(std::numbers::pi / s_.pocket.rod_count);
    for (const auto& point : s_.rods.profile) {
      if (point.x() * chord >= s_.rods.outer_diameter) continue;
      add("rods.profile", fmt::format("{} rods {} m from the axis intersect: their axes are {:.3g} m apart, less than "
                                      "their diameter {} m",
                                      s_.pocket.rod_count, point.x(), point.x() * chord, s_.rods.outer_diameter));
      return;
    }
  }

  void check_mesh() {
    const double elements = largest_element_count(s_);
    if (elements > kLargestElementCount) {
      add("pocket",
          fmt::format("rods, rows, columns and elements_per_side make up to {:.3g} elements; {:.0f} are allowed",
                      elements, kLargestElementCount));
    }
    const auto& profile = s_.rods.profile;
    const double width = 2 * std::min(profile[1].x(), profile[2].x()) * sine(std::numbers::pi / s_.pocket.rod_count);
    const MeshDivision mesh = mesh_division(s_);
    const double lower = (profile[1] - profile[0]).norm() / mesh.columns;
    const double upper = (profile[2] - profile[1]).norm() / mesh.rows;
    const double element = std::min({width / mesh.columns, lower, upper}) / mesh.per_side;
    if (element < s_.net.diameter) {
      add("net.diameter",
          fmt::format("elements of {:.3g} m are shorter than the cord is thick; use fewer or thinner cords", element));
    }
  }

  void check_closing() {
    const ClosingParameters& closing = s_.closing;
    const double open = open_tip_distance(s_);
    if (closing.law == ClosingLaw::table) {
      check_table(open);
      return;
    }
    if (closing.closed_length >= open) {
      add("closing.closed_length", fmt::format("must be shorter than the {:.6g} m between the open tips, not {} m",
                                               open, closing.closed_length));
    }
    check_rope_length("closing.closed_length", closing.closed_length);
  }

  void check_rope_length(std::string_view key, double length) {
    const double shortest = s_.rope.diameter * s_.closing.elements;
    if (length < shortest) {
      add(key, fmt::format("a rope of {} m has elements shorter than it is thick; at least {} m are needed", length,
                           shortest));
    }
  }

  void check_table(double open) {
    const auto& table = s_.closing.table;
    if (table.size() < 2) {
      add("closing.table", "the law \"table\" needs at least two points [time after start, length]");
      return;
    }
    if (table.front().x() != 0) add("closing.table", fmt::format("must start at time 0, not {} s", table.front().x()));
    constexpr double kTolerance = 0.01;  // the paper itself prints 5.78 m for 5.786 m
    if (std::abs(table.front().y() - open) > kTolerance * open) {
      add("closing.table", fmt::format("must start with the {:.6g} m between the open tips (to 1 %), not {} m", open,
                                       table.front().y()));
    }
    for (std::size_t i = 1; i < table.size(); ++i) {
      if (table[i].x() <= table[i - 1].x()) {
        add("closing.table", fmt::format("times must increase, but {} s follows {} s", table[i].x(), table[i - 1].x()));
        return;
      }
    }
    // The first row describes the open pocket. Ropes may be paid out again, but only to their open length.
    for (std::size_t i = 1; i < table.size(); ++i) {
      if (table[i].y() <= open) continue;
      add("closing.table",
          fmt::format("row {} asks for {} m of rope, but only the {:.6g} m between the open tips can be "
                      "paid out",
                      i + 1, table[i].y(), open));
      return;
    }
    const auto shorter = [](const auto& a, const auto& b) { return a.y() < b.y(); };
    check_rope_length("closing.table", std::min_element(table.begin(), table.end(), shorter)->y());
  }

  const Scenario& s_;
  const Shape* target_;
  Diagnostics& found_;
};

}  // namespace

void check_pocket(const Scenario& scenario, const Shape* target, Diagnostics& problems) {
  PocketChecker(scenario, target, problems).run();
}

}  // namespace netpocket
