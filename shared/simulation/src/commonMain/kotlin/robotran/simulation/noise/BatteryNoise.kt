package robotran.simulation.noise

/**
 * The voltage of the batteries, which drops while motors are driven.
 *
 * @param fresh their voltage at first, the reference for the robot's speeds.
 * @param empty min voltage, so that a long run does not come to a standstill.
 */
internal class BatteryNoise(
    streams: NoiseStreams,
    private val realism: Double,
    private val fresh: Double = FRESH_VOLTS,
    private val empty: Double = EMPTY_VOLTS,
) {
    private val used = realism * Realism.USED_BATTERY * streams.named("battery: used").share()
    private var drawn = 0.0
    private var sag = 0.0

    /** The current voltage. */
    var volts = fresh - used
        private set

    /** The voltage relative to fresh batteries. */
    val share: Double get() = volts / fresh

    /**
     * Advances by one millisecond with a load of [motors] motors at full power; a motor at half power counts as half a
     * motor.
     */
    fun tick(motors: Double) {
        if (realism == 0.0) return
        drawn += motors * MINUTES_PER_TICK
        sag += (motors * Realism.MOTOR_SAG - sag) * SAG_RESPONSE
        volts = maxOf(empty, fresh - used - realism * (sag + drawn * Realism.BATTERY_FADE))
    }

    companion object {
        /** Six fresh cells. */
        const val FRESH_VOLTS = 9.0

        private const val EMPTY_VOLTS = 7.0
        private const val MINUTES_PER_TICK = 1.0 / 60_000

        /** The voltage follows the load within about 50 ms. */
        private const val SAG_RESPONSE = 1.0 / 50
    }
}
