package robotran.simulation.physics

import robotran.world.geometry.Point

/**
 * Rigid bodies that push each other, without gravity. Bodies and their fixtures are identified by indices from 0.
 * Angles are in radians, masses in kilograms, times in seconds, lengths in a unit of the caller's choice.
 */
interface PhysicsWorld {
    /**
     * Adds a body without fixtures, which stays immovable until [setMass] or [spreadMass] is called. Returns its index.
     *
     * @param kind identifies it in the [contacts] of others, 0..14.
     */
    fun addBody(kind: Int, x: Double, y: Double, angle: Double): Int

    /**
     * Adds a polygon to a body, as one fixture if it is convex and otherwise as several. Returns the index of its first
     * fixture on that body.
     *
     * @param corners x and y of each corner, counter-clockwise, relative to the body's origin; edges meet only in
     * corners.
     * @param friction Coulomb coefficient against other fixtures.
     */
    fun addPolygon(body: Int, corners: DoubleArray, friction: Double): Int

    /**
     * Adds a circle to a body and returns its index on that body; [x] and [y] are its centre, relative to the body's
     * origin.
     */
    fun addCircle(body: Int, x: Double, y: Double, radius: Double, friction: Double): Int

    /**
     * Makes a body movable; [x] and [y] are its centre of mass, relative to its origin, and [inertia] is about that
     * centre.
     */
    fun setMass(body: Int, x: Double, y: Double, mass: Double, inertia: Double)

    /** Makes a body movable, with its [mass] spread evenly over its fixtures. */
    fun spreadMass(body: Int, mass: Double)

    /** Adds floor friction to a movable body: [force] is needed to move it, [torque] to turn it. */
    fun addFloorFriction(body: Int, force: Double, torque: Double)

    /** Moves a body to another pose, at rest. */
    fun place(body: Int, x: Double, y: Double, angle: Double)

    /** Applies an impulse to a body at the point [x], [y] of the world; changes its velocity at once. */
    fun applyImpulse(body: Int, impulseX: Double, impulseY: Double, x: Double, y: Double)

    /** Advances by one step. */
    fun step()

    /** Whether the last step has not moved a body with floor friction; its [motion] is the same as before then. */
    fun isAtRest(body: Int): Boolean

    fun motion(body: Int): BodyMotion

    /**
     * The contacts of the body after the last step: bit n for its fixture n of the first sixteen, bit 16 + k for
     * another body of kind k.
     */
    fun contacts(body: Int): Int

    /**
     * The free distance from one point towards another; the whole distance if there is no obstacle. Ignores [body],
     * unless it is negative, and any other body that contains the first point.
     */
    fun freeDistance(body: Int, from: Point, to: Point): Double

    /**
     * What is in the way from one point towards another, seen from where [freeDistance] sees it; null if nothing is.
     */
    fun ray(body: Int, from: Point, to: Point): RayHit?

    /** Releases the world; it must not be used afterwards. */
    fun close()

    companion object {
        /** Number of bits of [contacts] for fixtures; the bits for kinds follow. */
        const val FIXTURE_BITS = 16
    }
}

/**
 * What a ray has met.
 *
 * @property distance from where the ray begins.
 * @property normalX of the direction, of length 1, in which the surface looks.
 * @property normalY of the same.
 * @property isRound whether it is a circle.
 * @property body its index.
 */
data class RayHit(val distance: Double, val normalX: Double, val normalY: Double, val isRound: Boolean, val body: Int)

/**
 * The pose and velocity of a body.
 *
 * @property x of its origin.
 * @property y of its origin.
 * @property cosine of its angle.
 * @property sine of its angle.
 * @property velocityX of its centre of mass.
 * @property velocityY of its centre of mass.
 * @property angularVelocity radians a second.
 */
data class BodyMotion(
    val x: Double,
    val y: Double,
    val cosine: Double,
    val sine: Double,
    val velocityX: Double,
    val velocityY: Double,
    val angularVelocity: Double,
)
