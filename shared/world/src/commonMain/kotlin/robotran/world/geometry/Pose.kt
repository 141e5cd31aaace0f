package robotran.world.geometry

/**
 * A place on the paper and a direction.
 *
 * @property x centimetres from the paper's lower left corner to the right.
 * @property y centimetres from there upwards.
 * @property heading degrees counter-clockwise from the x axis, above -180 and up to 180.
 */
data class Pose(val x: Double, val y: Double, val heading: Double)
