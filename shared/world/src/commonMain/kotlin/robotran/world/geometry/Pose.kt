package robotran.world.geometry

/**
 * A position on the paper and a heading.
 *
 * @property x centimetres from the paper's lower left corner to the right.
 * @property y centimetres from there upwards.
 * @property heading degrees counter-clockwise from the x axis, in (-180, 180].
 */
data class Pose(val x: Double, val y: Double, val heading: Double)
