package robotran.hub.control

import robotran.hub.control.ControlConstants.FULL
import robotran.hub.control.ControlConstants.PERIOD
import robotran.hub.control.ControlConstants.PERIOD_SECONDS
import kotlin.math.abs

/**
 * Keeps something that turns on its [Trajectory]: one motor, or what two motors have in common or differ by. Works every
 * [PERIOD] milliseconds, in [tick].
 *
 * @param stiffness a share of [ControlConstants.STIFFNESS].
 * @param tolerance how near the end counts as reached, degrees.
 */
internal class AxisControl(private val stiffness: Double, private var tolerance: Double) {
    private var trajectory: Trajectory? = null
    private var ticks = 0
    private var stalledTicks = 0
    private var isHeldUp = false
    private var freeSpeed = ControlConstants.REFERENCE_SPEED

    /** Whether it controls at all. */
    val isActive: Boolean get() = trajectory != null

    /** Whether it is still on its way, and not only held where it has arrived. */
    val isOnItsWay: Boolean get() = trajectory?.let { seconds < it.seconds } == true

    /** Whether the move is over; a move without an end always is. */
    var isDone = true
        private set

    val isStalled: Boolean get() = stalledTicks * PERIOD >= ControlConstants.STALL_MILLISECONDS

    /** Where it should be now; null if it does not control, or if something is in its way. */
    val reference: Double? get() = trajectory?.takeUnless { isHeldUp }?.position(seconds)

    /** How fast it should be now. */
    val referenceSpeed: Double get() = trajectory?.speed(seconds) ?: 0.0

    private val seconds: Double get() = ticks * PERIOD_SECONDS

    /** Fits it to a motor that turns [freeSpeed] at full power. */
    fun fit(freeSpeed: Double, tolerance: Double) {
        this.freeSpeed = freeSpeed
        this.tolerance = tolerance
    }

    fun follow(trajectory: Trajectory) {
        this.trajectory = trajectory
        ticks = 0
        stalledTicks = 0
        isHeldUp = false
        isDone = trajectory.seconds == Double.POSITIVE_INFINITY
    }

    /** Keeps [angle]. */
    fun hold(angle: Double) {
        follow(Trajectory.to(angle, angle, speed = 0.0, fastest = 1.0, acceleration = 1.0))
        isDone = true
    }

    fun leave() {
        trajectory = null
        isDone = true
        stalledTicks = 0
    }

    /**
     * Goes on by [PERIOD] milliseconds.
     *
     * @param angle where it is.
     * @param speed how fast it turned since the last time.
     * @param meanSpeed how fast it turned in the last [ControlConstants.SPEED_WINDOW] milliseconds.
     * @return the power that it wants, percent.
     */
    fun tick(angle: Double, speed: Double, meanSpeed: Double): Double {
        val trajectory = trajectory ?: return 0.0
        val wantedSpeed = trajectory.speed(seconds)
        val behind = trajectory.position(seconds) - angle
        val scale = ControlConstants.REFERENCE_SPEED / freeSpeed
        val power = ahead(trajectory, wantedSpeed) +
            scale * (stiffness * ControlConstants.STIFFNESS * behind + ControlConstants.DAMPING * (wantedSpeed - speed))
        val isAtLimit = abs(power) >= FULL
        stalledTicks = if (isAtLimit && abs(speed) < ControlConstants.STALL_SPEED) stalledTicks + 1 else 0
        // A motor that cannot follow is waited for.
        isHeldUp = isAtLimit && power * wantedSpeed > 0 && behind * wantedSpeed > 0
        if (!isHeldUp) ticks++
        if (!isDone) {
            isDone = seconds > trajectory.seconds && abs(meanSpeed) < ControlConstants.SPEED_TOLERANCE &&
                abs(behind) <= tolerance
        }
        return power.coerceIn(-FULL, FULL)
    }

    /** The power that the move itself needs. */
    private fun ahead(trajectory: Trajectory, speed: Double): Double {
        val friction = if (speed > 0) {
            ControlConstants.FRICTION
        } else if (speed < 0) {
            -ControlConstants.FRICTION
        } else {
            0.0
        }
        val change = trajectory.acceleration(seconds) * ControlConstants.LAG
        return friction + (speed + change) / freeSpeed * FULL
    }
}
