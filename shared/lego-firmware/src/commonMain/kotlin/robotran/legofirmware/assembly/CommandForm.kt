package robotran.legofirmware.assembly

import robotran.legofirmware.instructions.NumberRange
import robotran.legofirmware.instructions.Opcode
import robotran.legofirmware.instructions.OperandKind
import robotran.legofirmware.instructions.OperandNumbers
import robotran.legofirmware.listing.BYTES_MNEMONIC

/** What follows a command in assembly text: one entry for each number, null for a label. */
internal class CommandForm(val opcode: Opcode) {
    /** The kinds of operands that are written, in their order. */
    val kinds: List<OperandKind> = opcode.operands.filter { it != OperandKind.ZERO }

    val places: List<NumberRange?> = kinds.flatMap { kind ->
        if (kind.jump == null) OperandNumbers.rangesOf(kind) else listOf(null)
    }

    /** Such as `setv variable, source, argument`. */
    override fun toString(): String = opcode.mnemonic +
        if (places.isEmpty()) "" else places.joinToString(prefix = " ") { it?.name ?: LABEL }

    companion object {
        private const val LABEL = "label"
        private val forms: Map<String, List<CommandForm>> =
            Opcode.entries.map { CommandForm(it) }.groupBy { it.opcode.mnemonic }

        /** The form of a line with bytes. */
        const val BYTES_FORM = "$BYTES_MNEMONIC number, .."

        /** The words that begin a line. */
        val words: List<String> =
            forms.keys.toList() + BYTES_MNEMONIC + BlockDirective.entries.flatMap { listOf(it.word, it.end) }

        /** The forms of commands with this mnemonic: two for `stop`, which has a task or none. */
        fun of(mnemonic: String): List<CommandForm> = forms[mnemonic].orEmpty()
    }
}
