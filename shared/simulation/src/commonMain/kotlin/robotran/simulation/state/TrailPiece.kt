package robotran.simulation.state

import robotran.world.geometry.Point

/**
 * A part of a robot's path, driven without being picked up; immutable.
 *
 * @property robot its index in the world.
 * @property points the corners of its pen's path, which stays within a twentieth of a millimetre of the line through
 * them.
 */
data class TrailPiece(val robot: Int, val points: List<Point>)
