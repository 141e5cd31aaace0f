package robotran.legofirmware.assembly

import robotran.legofirmware.instructions.NumberRange
import robotran.legofirmware.messages.AssemblyMessages

/** Reads numbers and reports what is none, or out of range. */
internal class CheckedNumbers(private val sink: AssemblySink, private val messages: AssemblyMessages) {
    /** The number that [token] is; null if it is not one of [range]. */
    fun number(token: Token, range: NumberRange, form: String): Int? {
        val number = token.number
        when {
            number == null -> {
                val message = messages.numberNeeded(short(token.text), range.name, form)
                sink.error(AssemblyError.NUMBER_NEEDED, token, message)
            }

            number !in range.range -> {
                val message = messages.numberOutOfRange(range.name, number, range.range.first, range.range.last)
                sink.error(AssemblyError.NUMBER_OUT_OF_RANGE, token, message)
            }

            else -> return number
        }
        return null
    }
}
