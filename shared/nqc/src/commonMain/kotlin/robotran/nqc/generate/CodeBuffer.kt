package robotran.nqc.generate

import robotran.language.source.SourceRange
import robotran.legofirmware.instructions.Opcode

/** A place in code that is being generated. */
internal class Label {
    /** The number of the instruction at the place. */
    var index = 0
}

/** Instructions one after the other, whose jumps get their form and distance at the end. */
internal class CodeBuffer {
    /**
     * An instruction, or bytes of `asm`.
     *
     * @property bytes without the distance of a jump.
     * @property long the opcode in [bytes], which jumps to [target]; null if the instruction does not jump.
     */
    private class Item(val bytes: IntArray, val long: Opcode?, val target: Label?) {
        val size: Int get() = bytes.size + (long?.jump?.size ?: 0)
    }

    private val items = mutableListOf<Item>()
    private val marks = mutableListOf<Pair<Int, SourceRange>>()

    /** Bytes so far, with all jumps in their long form. */
    var size = 0
        private set

    /** Instructions so far. */
    val count: Int get() = items.size

    fun add(vararg bytes: Int) = append(Item(bytes, null, null))

    /** Adds a jump to [target] with the opcode [long]; [operands] come before the distance. */
    fun addJump(long: Opcode, target: Label, vararg operands: Int) =
        append(Item(intArrayOf(long.code, *operands), long, target))

    private fun append(item: Item) {
        items += item
        size += item.size
    }

    /** Makes a label for this place, which [place] can move. */
    fun label(): Label = Label().also { place(it) }

    /** Moves [label] to this place. */
    fun place(label: Label) {
        label.index = items.size
    }

    /** Says that what follows comes from [range]. */
    fun mark(range: SourceRange) {
        if (marks.lastOrNull()?.first == items.size) marks.removeAt(marks.lastIndex)
        if (marks.lastOrNull()?.second != range) marks += items.size to range
    }

    /** Removes all instructions from number [count] on. */
    fun truncate(count: Int) {
        while (items.size > count) size -= items.removeAt(items.lastIndex).size
    }

    /**
     * The code. As in the original compiler, jumps are laid out long, then those in reach are shortened once: a jump
     * that would fit only after others shrank stays long.
     */
    fun layout(): Code {
        val long = addresses { items[it].size }
        val opcodes = items.mapIndexed { index, item ->
            val short = item.long?.let { SHORT_FORMS[it] }
            val base = long[index] + item.bytes.size
            val isInReach = short?.jump != null && item.target != null &&
                short.jump!!.reaches(base, long[item.target.index])
            if (isInReach) short else item.long
        }
        val final = addresses { items[it].bytes.size + (opcodes[it]?.jump?.size ?: 0) }
        return Code(bytes(opcodes, final), lines(final))
    }

    /** The address of each instruction, and of the end. */
    private fun addresses(sizeOf: (Int) -> Int): IntArray {
        val addresses = IntArray(items.size + 1)
        for (index in items.indices) addresses[index + 1] = addresses[index] + sizeOf(index)
        return addresses
    }

    private fun bytes(opcodes: List<Opcode?>, addresses: IntArray): ByteArray {
        val bytes = ByteArray(addresses.last())
        items.forEachIndexed { index, item ->
            var address = addresses[index]
            for (byte in item.bytes) bytes[address++] = byte.toByte()
            val form = opcodes[index]?.jump
            if (form != null && item.target != null) {
                bytes[addresses[index]] = opcodes[index]!!.code.toByte()
                val distance = form.encode(address, addresses[item.target.index])
                for (byte in 0 until form.size) bytes[address + byte] = (distance shr byte * Byte.SIZE_BITS).toByte()
            }
        }
        return bytes
    }

    private fun lines(addresses: IntArray): List<NqcCodeLine> {
        val lines = marks.filter { (index, _) -> index < items.size }
            .map { (index, range) -> NqcCodeLine(addresses[index], range) }
        return lines.filterIndexed { index, line -> lines.getOrNull(index + 1)?.address != line.address }
    }

    private companion object {
        val SHORT_FORMS = mapOf(
            Opcode.JMPL to Opcode.JMP,
            Opcode.CHKL to Opcode.CHK,
            Opcode.LOOPCL to Opcode.LOOPC,
            Opcode.DECVJNL to Opcode.DECVJN,
            Opcode.MONEL to Opcode.MONE,
        )
    }
}
