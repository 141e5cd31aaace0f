package robotran.world.geometry

/** A point on the paper: centimetres from its lower left corner to the right ([x]) and upwards ([y]). */
data class Point(val x: Double, val y: Double)
