package robotran.world.geometry

/** One implementation of the functions that platforms round differently. Angles are in radians. */
interface Trigonometry {
    fun sine(angle: Double): Double

    fun cosine(angle: Double): Double

    /** The angle of the vector, in (-pi, pi]. */
    fun angle(x: Double, y: Double): Double
}
