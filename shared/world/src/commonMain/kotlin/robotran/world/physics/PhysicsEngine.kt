package robotran.world.physics

/** Rigid bodies seen from above, and the trigonometry that goes with them; the same to the last bit on every target. */
interface PhysicsEngine {
    val trigonometry: Trigonometry

    /** A new world with nothing in it. */
    fun createWorld(settings: PhysicsSettings): PhysicsWorld
}

/** The physics of this platform: at once on the JVM and Android; in the browser it loads the physics module first, and throws if it cannot. */
expect suspend fun loadPhysicsEngine(): PhysicsEngine

/** The functions that platforms round differently, in one implementation for all. Angles are in radians. */
interface Trigonometry {
    fun sine(angle: Double): Double

    fun cosine(angle: Double): Double

    /** The angle of the vector, above -pi and up to pi. */
    fun angle(x: Double, y: Double): Double
}

/**
 * What a world is solved with.
 *
 * @property stepSeconds the fixed time of one step.
 * @property stepParts how many equal parts a step is solved in; the more, the less deep a body gets into another before it is noticed.
 * @property lengthTolerance how deep two fixtures may overlap before they are pushed apart, in the world's unit of length.
 * @property velocityIterations how often the solver goes over the contacts' velocities in a step.
 * @property positionIterations how often it goes over their positions.
 */
data class PhysicsSettings(
    val stepSeconds: Double,
    val stepParts: Int,
    val lengthTolerance: Double,
    val velocityIterations: Int,
    val positionIterations: Int,
)
