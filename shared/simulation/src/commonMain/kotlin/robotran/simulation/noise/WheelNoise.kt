package robotran.simulation.noise

/**
 * What makes one motor and its wheel stray.
 *
 * @param side such as `left wheel`; names its streams.
 * @param realism 0..1.
 */
internal class WheelNoise(streams: NoiseStreams, side: String, private val realism: Double) {
    private val flutterStream = streams.named("$side: flutter")
    private val slipStream = streams.named("$side: slip")

    /** Whether anything strays at all. */
    val isOn: Boolean get() = realism != 0.0

    /** How strong the motor is all the time, 1 as it should be. */
    val strength = 1 + realism * Realism.MOTOR_STRENGTH * streams.named("$side: strength").normal()

    /** What its speed is multiplied with now, beside [strength]. */
    var flutter = 1.0
        private set

    /** The part of the wheel's way that is lost now. */
    var slip = 0.0
        private set

    /** Lets a millisecond pass, the one with the number [tick]. */
    fun tick(tick: Long) {
        if (realism == 0.0 || tick % Realism.CHANGE_MILLISECONDS != 0L) return
        flutter = 1 + realism * Realism.MOTOR_FLUTTER * flutterStream.normal()
        slip = realism * Realism.WHEEL_SLIP * kotlin.math.abs(slipStream.normal())
    }
}
