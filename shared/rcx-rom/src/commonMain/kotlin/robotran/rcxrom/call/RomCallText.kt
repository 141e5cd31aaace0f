package robotran.rcxrom.call

/** Formats a call as `0x1a4e 0x2000 1 3`: codes and pointers in hexadecimal, numbers in signed decimal. */
internal object RomCallText {
    fun of(call: RomCall): String {
        val parameters = RomTable.find(call.address)?.parameters.orEmpty()
        return buildString {
            append(hexadecimal(call.address))
            call.arguments.forEachIndexed { place, argument ->
                append(' ')
                append(argumentText(argument, parameters.getOrNull(place)))
            }
        }
    }

    fun hexadecimal(value: Int): String = "0x" + value.toString(HEXADECIMAL).padStart(WORD_DIGITS, '0')

    private fun argumentText(argument: Int, parameter: RomParameter?): String {
        val word = argument and WORD
        val asHexadecimal = when (parameter) {
            RomParameter.NUMBER -> false
            RomParameter.POINTER -> true
            RomParameter.CODE, null -> word in LOOKS_LIKE_A_CODE
        }
        return if (asHexadecimal) hexadecimal(word) else word.toShort().toString()
    }

    /** Codes start with a byte of at least 0x10; a value from 0xf000 on is more likely a small negative number. */
    private val LOOKS_LIKE_A_CODE = 0x1000..0xEFFF
    private const val WORD = 0xFFFF
    private const val HEXADECIMAL = 16
    private const val WORD_DIGITS = 4
}
