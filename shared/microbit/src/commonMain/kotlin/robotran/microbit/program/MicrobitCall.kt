package robotran.microbit.program

/**
 * A call by which a program acts on a micro:bit.
 *
 * @property numbers at least as many as the call has [parameters][MicrobitNative.parameters]; must not change afterwards.
 * @property text what to show or print.
 */
class MicrobitCall(val native: MicrobitNative, val numbers: IntArray = NONE, val text: String? = null) {
    /** Passes what identifies the call to [add], in this order: id, numbers, text. */
    fun identify(add: (Long) -> Unit) {
        add(native.id.toLong())
        for (number in numbers) add(number.toLong())
        if (text != null) {
            add(text.length.toLong())
            add(text.fold(0) { hash, character -> HASH_FACTOR * hash + character.code }.toLong())
        }
    }

    /** The call as the log shows it, such as `i2c 0x10 01 02 2d 00`, `pin 2 analog 88` or `display scroll 12`. */
    override fun toString(): String = when (native) {
        MicrobitNative.I2C_WRITE ->
            (listOf(native.words, "0x" + hex(numbers[0])) + numbers.drop(1).map(::hex)).joinToString(" ")

        MicrobitNative.PIN_ANALOG, MicrobitNative.PIN_PERIOD, MicrobitNative.PIN_DIGITAL ->
            "pin ${numbers[0]} ${native.words} ${numbers[1]}"

        else -> (listOf(native.words) + listOfNotNull(text) + numbers.map { "$it" }).joinToString(" ")
    }

    private fun hex(number: Int) = number.toString(HEXADECIMAL).padStart(2, '0')

    companion object {
        private val NONE = IntArray(0)
        private const val HASH_FACTOR = 31
        private const val HEXADECIMAL = 16

        /** See [MicrobitNative.I2C_WRITE]. */
        fun i2c(address: Int, bytes: List<Int>): MicrobitCall =
            MicrobitCall(MicrobitNative.I2C_WRITE, intArrayOf(address, *bytes.toIntArray()))

        /** See [MicrobitNative.PIN_ANALOG]. */
        fun pinAnalog(pin: Int, value: Int): MicrobitCall = of(MicrobitNative.PIN_ANALOG, pin, value)

        /** See [MicrobitNative.PIN_PERIOD]. */
        fun pinPeriod(pin: Int, milliseconds: Int): MicrobitCall = of(MicrobitNative.PIN_PERIOD, pin, milliseconds)

        /** A call with numbers only. */
        fun of(native: MicrobitNative, vararg numbers: Int): MicrobitCall = MicrobitCall(native, numbers)

        /** A call with a text. */
        fun of(native: MicrobitNative, text: String): MicrobitCall = MicrobitCall(native, text = text)
    }
}
