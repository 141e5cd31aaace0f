package robotran.simulation.noise

/**
 * The noise of one motor and its wheel.
 *
 * @param side such as `left wheel`; names its streams.
 * @param realism 0..1.
 */
internal class WheelNoise(streams: NoiseStreams, side: String, private val realism: Double) {
    private val flutterStream = streams.named("$side: flutter")
    private val slipStream = streams.named("$side: slip")

    /** Whether there is any noise. */
    val isOn: Boolean get() = realism != 0.0

    /** The constant relative strength of the motor, 1 if nominal. */
    val strength = 1 + realism * Realism.MOTOR_STRENGTH * streams.named("$side: strength").normal()

    /** The current factor for the motor's speed, in addition to [strength]. */
    var flutter = 1.0
        private set

    /** The part of the wheel's distance that is lost now. */
    var slip = 0.0
        private set

    /** Advances by the millisecond number [tick]. */
    fun tick(tick: Long) {
        if (realism == 0.0 || tick % Realism.CHANGE_MILLISECONDS != 0L) return
        flutter = 1 + realism * Realism.MOTOR_FLUTTER * flutterStream.normal()
        slip = realism * Realism.WHEEL_SLIP * kotlin.math.abs(slipStream.normal())
    }
}
