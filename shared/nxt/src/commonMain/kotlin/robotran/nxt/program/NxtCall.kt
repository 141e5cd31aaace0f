package robotran.nxt.program

import robotran.brick.sensors.SensorKind
import robotran.language.quoted

/**
 * A call by which a program acts on the brick. The arrays must not change afterwards.
 *
 * @property numbers as many as the call has [parameters][NxtNative.parameters].
 * @property text what to draw or to log, or the name of a robot.
 * @property bytes what to send or to play.
 * @property sensor which sensor the class library asks; null if it does not say.
 */
class NxtCall(
    val native: NxtNative,
    val numbers: IntArray = NONE,
    val text: String? = null,
    val bytes: ByteArray? = null,
    val sensor: SensorKind? = null,
) {
    /** The speed, in degrees a second, of a call that has one. */
    val speed: Float get() = Float.fromBits(numbers[native.speed])

    /**
     * The arguments as the log shows them: the text, the numbers, and few bytes in hexadecimal or how many they are.
     */
    val arguments: String
        get() = buildList {
            if (text != null) add(quoted(text.replace("\n", "\\n")))
            numbers.forEachIndexed { index, number -> add(if (index == native.speed) tenths(speed) else "$number") }
            if (bytes != null) add(bytesText(bytes))
        }.joinToString(" ")

    /** Passes what identifies the call to [add], in this order: id, numbers, text, bytes. */
    fun identify(add: (Long) -> Unit) {
        add(native.id.toLong())
        for (number in numbers) add(number.toLong())
        if (text != null) {
            add(text.length.toLong())
            add(text.fold(0) { hash, character -> HASH_FACTOR * hash + character.code }.toLong())
        }
        if (bytes != null) {
            add(bytes.size.toLong())
            add(bytes.fold(0) { hash, byte -> HASH_FACTOR * hash + byte }.toLong())
        }
    }

    override fun toString(): String = "${native.nativeName} $arguments".trim()

    companion object {
        private val NONE = IntArray(0)
        private const val HASH_FACTOR = 31
        private const val MOST_BYTES_SHOWN = 8
        private const val BYTE = 0xFF

        /** A call with numbers only. */
        fun of(native: NxtNative, vararg numbers: Int): NxtCall = NxtCall(native, numbers)

        fun controlMotor(port: Int, power: Int, brakes: Boolean): NxtCall =
            of(NxtNative.CONTROL_MOTOR, port, power, if (brakes) 1 else 0)

        /** See [NxtNative.REGULATE]. */
        fun regulate(port: Int, speed: Float, acceleration: Int, limit: Int, hold: Boolean): NxtCall =
            of(NxtNative.REGULATE, port, speed.toRawBits(), acceleration, limit, if (hold) 1 else 0)

        /** See [NxtNative.REGULATOR_SPEED]. */
        fun regulatorSpeed(port: Int, speed: Float): NxtCall = of(NxtNative.REGULATOR_SPEED, port, speed.toRawBits())

        fun drawString(text: String, column: Int, row: Int, inverted: Boolean = false): NxtCall =
            NxtCall(NxtNative.DRAW_STRING, intArrayOf(column, row, if (inverted) 1 else 0), text)

        private fun bytesText(bytes: ByteArray): String = if (bytes.size > MOST_BYTES_SHOWN) {
            "[${bytes.size} bytes]"
        } else {
            bytes.joinToString(" ", "[", "]") { (it.toInt() and BYTE).toString(radix = 16).padStart(2, '0') }
        }
    }
}

/** A speed with one decimal, the same on all platforms. */
internal fun tenths(speed: Float): String {
    val tenths = (speed * 10 + (if (speed < 0) -ROUNDING else ROUNDING)).toLong()
    val size = if (tenths < 0) -tenths else tenths
    return (if (tenths < 0) "-" else "") + size / 10 + (if (size % 10 == 0L) "" else ".${size % 10}")
}

private const val ROUNDING = 0.5f
