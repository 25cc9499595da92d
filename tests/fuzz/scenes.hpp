#pragma once
/// Makes small scenes that are right, to begin with and to return to.

#include "meshes.hpp"
#include "world.hpp"

namespace fuzz {

constexpr int recipes = 8;

/// Adds a context, two bodies and a contact of them to the world.
void make_bodies(World& world, int recipe);
/// Gives everything that a solve needs, whatever the contact was given before.
void set_scene(rollcon_contact* contact, int recipe);
/// Shortens solves, because long ones find nothing: few iterations, and coarse frames where the library makes them.
void shorten(rollcon_contact* contact, int iterations);
constexpr double least_frame_accuracy = 0.1;
/// Gives nodes, elements and support of a body; elastic ones need a material besides.
void give_mesh(World& world, rollcon_body* body, const Box& box);

/// Requires that the contact, given the scene again, and a fresh one of the same bodies solve to the same.
void require_usable(World& world, rollcon_contact* contact, int recipe);
/// Requires that a scene of two half-spaces made, solved and released gives what it gave at first.
void require_sound_library();

/// Solves with a watch on status, and on finite results that obey the simplest laws.
std::int32_t solve_and_check(World& world, rollcon_contact* contact);

}  // namespace fuzz
