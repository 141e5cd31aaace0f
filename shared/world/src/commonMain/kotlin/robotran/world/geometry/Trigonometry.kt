package robotran.world.geometry

/** The functions that platforms round differently, in one implementation for all. Angles are in radians. */
interface Trigonometry {
    fun sine(angle: Double): Double

    fun cosine(angle: Double): Double

    /** The angle of the vector, above -pi and up to pi. */
    fun angle(x: Double, y: Double): Double
}
