package robotran.nxt.regulator

/**
 * Where a motor should be at each moment: it gets faster evenly, keeps its speed, and gets slower evenly, so that it
 * stands at its limit. All in 32-bit numbers, as on the brick.
 */
internal class MotorPlan {
    // Where the motor should be: whole degrees, and what is to be added, so that long ways stay exact.
    private var degrees = 0
    private var fraction = 0f

    /** Degrees a second, with its direction. */
    var velocity = 0f
        private set

    /** Degrees a second squared. */
    var acceleration = 0f
        private set

    /** Where the plan ends; [MotorRegulator.FORWARD] or [MotorRegulator.BACKWARD] if it does not. */
    var limit = MotorRegulator.FORWARD
        private set

    private var target = 0f
    private var isBraking = false
    private var deceleration = 0f

    /** Where the motor should be, in degrees. */
    val position: Float get() = degrees + fraction

    /** The whole degrees nearest to [position]. */
    val nearestDegrees: Int get() = degrees + (if (fraction < 0) fraction - HALF else fraction + HALF).toInt()

    /** Whether the plan goes nowhere any more. */
    val isOver: Boolean get() = velocity == 0f && target == 0f && !isLimited

    private val isLimited: Boolean get() = limit != MotorRegulator.FORWARD && limit != MotorRegulator.BACKWARD

    fun error(count: Int): Float = degrees - count + fraction

    /** Stands still at [count]. */
    fun standAt(count: Int) {
        degrees = count
        fraction = 0f
        stand()
        limit = count
    }

    fun stand() {
        velocity = 0f
        target = 0f
    }

    /** The counter was set back by [degrees]. */
    fun shift(degrees: Int) {
        this.degrees -= degrees
        if (isLimited) limit -= degrees
    }

    fun accelerateBy(acceleration: Float) {
        this.acceleration = acceleration
        isBraking = false
    }

    /** Plans to stop as soon as possible. */
    fun stop() = head(0f, MotorRegulator.FORWARD)

    /** Plans to go to [limit] with [speed], without turning round first. */
    fun go(speed: Float, limit: Int) = head(if (isAhead(limit)) speed else -speed, limit)

    private fun head(target: Float, limit: Int) {
        this.target = target
        this.limit = limit
        isBraking = false
    }

    /** Changes the speed of a motor that is under way, which it may be slowing down for its limit. */
    fun setSpeed(speed: Float) {
        if (target == 0f) return
        target = if (target < 0) -speed else speed
        isBraking = false
    }

    /** Whether the motor can go on to [limit] without turning round. */
    fun canReach(limit: Int): Boolean {
        if (velocity == 0f) return true
        if (velocity > 0 != isAhead(limit)) return false
        if (limit == MotorRegulator.FORWARD || limit == MotorRegulator.BACKWARD) return true
        return velocity * velocity <= 2 * acceleration * size(wayTo(limit))
    }

    /** Goes on by [seconds]. Returns whether the motor should now stand at the limit. */
    fun advance(seconds: Float): Boolean {
        val old = velocity
        val way = if (isLimited) wayTo(limit) else 0f
        if (isLimited && !isBraking && old * old >= 2 * acceleration * size(way)) brakeWithin(size(way))
        val change = (if (isBraking) deceleration else acceleration) * seconds
        velocity = approach(old, if (isBraking) 0f else target, change)
        var step = (old + velocity) * HALF * seconds
        if (velocity == 0f && old != 0f && change > 0) step = old * size(old) * HALF * seconds / change
        if (isLimited && isThere(way, step)) {
            standAt(limit)
            return true
        }
        fraction += step
        val whole = fraction.toInt()
        degrees += whole
        fraction -= whole
        return isOver
    }

    private fun brakeWithin(distance: Float) {
        isBraking = true
        deceleration = if (distance > 0) velocity * velocity / (2 * distance) else acceleration
    }

    private fun isThere(way: Float, step: Float): Boolean =
        (isBraking && velocity == 0f) || (if (way < 0) step <= way else step >= way)

    private fun isAhead(limit: Int): Boolean =
        limit == MotorRegulator.FORWARD || (limit != MotorRegulator.BACKWARD && wayTo(limit) >= 0)

    private fun wayTo(limit: Int): Float = limit - degrees - fraction

    private companion object {
        const val HALF = 0.5f

        fun size(value: Float): Float = if (value < 0) -value else value

        /** [from], closer to [wanted] by at most [change]. */
        fun approach(from: Float, wanted: Float, change: Float): Float = when {
            wanted - from > change -> from + change
            wanted - from < -change -> from - change
            else -> wanted
        }
    }
}
