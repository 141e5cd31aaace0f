package robotran.simulation.state

import robotran.world.geometry.Point

/**
 * A part of the way on which a robot drove without being picked up; never changes once given out.
 *
 * @property robot its number in the world, from 0.
 * @property points the corners of its pen's way, which stays within a twentieth of a millimetre of the line through
 * them.
 */
data class TrailPiece(val robot: Int, val points: List<Point>)
