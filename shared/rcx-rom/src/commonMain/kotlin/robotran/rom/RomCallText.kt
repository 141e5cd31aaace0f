package robotran.rom

/** Writes a call as `0x1a4e 0x2000 1 3`. */
internal object RomCallText {
    fun of(call: RomCall): String = (listOf(hexadecimal(call.address)) + call.arguments.map(::argument)).joinToString(" ")

    fun hexadecimal(value: Int): String = "0x" + value.toString(HEXADECIMAL).padStart(WORD_DIGITS, '0')

    private fun argument(value: Int): String =
        if (value and 0xFFFF in HEXADECIMAL_VALUES) hexadecimal(value and 0xFFFF) else value.toShort().toString()

    private val HEXADECIMAL_VALUES = 0x1000..0xEFFF
    private const val HEXADECIMAL = 16
    private const val WORD_DIGITS = 4
}
