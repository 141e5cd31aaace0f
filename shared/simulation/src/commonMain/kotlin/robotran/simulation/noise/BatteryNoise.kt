package robotran.simulation.noise

/** The voltage of the batteries, which falls as motors are driven. */
internal class BatteryNoise(streams: NoiseStreams, private val realism: Double) {
    private val used = realism * Realism.USED_BATTERY * streams.named("battery: used").share()
    private var drawn = 0.0
    private var sag = 0.0

    /** What there is now, in volts. */
    var volts = FRESH_VOLTS - used
        private set

    /** The same as a part of what fresh batteries give. */
    val share: Double get() = volts / FRESH_VOLTS

    /**
     * Lets a millisecond pass in which as many motors were driven at full power as [motors] says; half a motor is one
     * at half power.
     */
    fun tick(motors: Double) {
        if (realism == 0.0) return
        drawn += motors * MINUTES_PER_TICK
        sag += (motors * Realism.MOTOR_SAG - sag) * SAG_RESPONSE
        volts = maxOf(EMPTY_VOLTS, FRESH_VOLTS - used - realism * (sag + drawn * Realism.BATTERY_FADE))
    }

    companion object {
        /** Six fresh cells, for which the robot's speeds are known. */
        const val FRESH_VOLTS = 9.0

        /** They never give less here, or a long run would come to a standstill. */
        private const val EMPTY_VOLTS = 7.0
        private const val MINUTES_PER_TICK = 1.0 / 60_000

        /** The voltage follows the load within some 50 ms. */
        private const val SAG_RESPONSE = 1.0 / 50
    }
}
