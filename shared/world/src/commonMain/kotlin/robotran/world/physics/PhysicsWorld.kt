package robotran.world.physics

/**
 * Rigid bodies that push each other, without gravity. Bodies and their fixtures are known by numbers from 0. Angles are in radians,
 * masses in kilograms, times in seconds, lengths in the unit that whoever uses it has chosen.
 */
interface PhysicsWorld {
    /** Adds a body without fixtures that nothing can move, until [setMass] makes it movable. Returns its number. */
    fun addBody(x: Double, y: Double, angle: Double): Int

    /**
     * Adds a convex polygon to a body and returns its number on that body.
     *
     * @param corners x and y of each corner, counter-clockwise, seen from the body's origin.
     * @param friction Coulomb coefficient against other fixtures.
     */
    fun addPolygon(body: Int, corners: DoubleArray, friction: Double): Int

    /** Makes a body movable; [x] and [y] are its centre of mass, seen from its origin, and [inertia] is about that centre. */
    fun setMass(body: Int, x: Double, y: Double, mass: Double, inertia: Double)

    /** Changes the velocity of a body at once, as a knock with this impulse at the point [x], [y] of the world does. */
    fun applyImpulse(body: Int, impulseX: Double, impulseY: Double, x: Double, y: Double)

    /** Lets one step of time pass. */
    fun step()

    fun motion(body: Int): BodyMotion

    /** The body's fixtures that touch another body after the last step: bit n stands for fixture n. */
    fun touchedFixtures(body: Int): Int

    /** Frees what the world holds; nothing may be asked of it afterwards. */
    fun close()
}

/**
 * How a body lies and moves.
 *
 * @property x where its origin is.
 * @property y where its origin is.
 * @property cosine of its angle.
 * @property sine of its angle.
 * @property velocityX the velocity of its centre of mass.
 * @property velocityY the velocity of its centre of mass.
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
