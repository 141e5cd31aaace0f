package robotran.simulation.physics

import robotran.world.geometry.Point

/**
 * Rigid bodies that push each other, without gravity. Bodies and their fixtures are known by numbers from 0. Angles are
 * in radians, masses in kilograms, times in seconds, lengths in the unit that whoever uses it has chosen.
 */
interface PhysicsWorld {
    /**
     * Adds a body without fixtures that nothing can move, until [setMass] or [spreadMass] makes it movable. Returns its
     * number.
     *
     * @param kind what [contacts] of others tells it apart by, 0..14.
     */
    fun addBody(kind: Int, x: Double, y: Double, angle: Double): Int

    /**
     * Adds a polygon to a body, as one fixture if it is convex and otherwise as several. Returns the number of its
     * first fixture on that body.
     *
     * @param corners x and y of each corner, counter-clockwise, seen from the body's origin; no two edges meet but in
     * corners.
     * @param friction Coulomb coefficient against other fixtures.
     */
    fun addPolygon(body: Int, corners: DoubleArray, friction: Double): Int

    /**
     * Adds a circle to a body and returns its number on that body; [x] and [y] are its centre, seen from the body's
     * origin.
     */
    fun addCircle(body: Int, x: Double, y: Double, radius: Double, friction: Double): Int

    /**
     * Makes a body movable; [x] and [y] are its centre of mass, seen from its origin, and [inertia] is about that
     * centre.
     */
    fun setMass(body: Int, x: Double, y: Double, mass: Double, inertia: Double)

    /** Makes a body movable whose [mass] is spread evenly over its fixtures. */
    fun spreadMass(body: Int, mass: Double)

    /** Lets a movable body rub on the floor: [force] is what it takes to move it, [torque] to turn it. */
    fun rubOnFloor(body: Int, force: Double, torque: Double)

    /** Puts a body somewhere else, at rest. */
    fun place(body: Int, x: Double, y: Double, angle: Double)

    /** Changes the velocity of a body at once, as a knock with this impulse at the point [x], [y] of the world does. */
    fun applyImpulse(body: Int, impulseX: Double, impulseY: Double, x: Double, y: Double)

    /** Lets one step of time pass. */
    fun step()

    fun motion(body: Int): BodyMotion

    /**
     * What the body touches after the last step: bit n stands for its fixture n of the first sixteen, bit 16 + k for
     * another body of the kind k.
     */
    fun contacts(body: Int): Int

    /**
     * How far it is from one point towards another until something is in the way; the whole distance if nothing is.
     * Neither [body] counts, unless it is negative, nor any other that the first point is in.
     */
    fun freeWay(body: Int, from: Point, to: Point): Double

    /** Frees what the world holds; nothing may be asked of it afterwards. */
    fun close()

    companion object {
        /** The bits of [contacts] that stand for fixtures; those for kinds follow. */
        const val FIXTURE_BITS = 16
    }
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
