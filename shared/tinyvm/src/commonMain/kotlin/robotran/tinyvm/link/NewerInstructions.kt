package robotran.tinyvm.link

import robotran.tinyvm.classfile.ByteReader
import robotran.tinyvm.classfile.damaged
import robotran.tinyvm.config.TinyVmLimits
import robotran.tinyvm.messages.LinkMessages
import robotran.tinyvm.messages.UnsupportedFeature

/** Decodes the bytecodes that an exact machine has and an RCX does not, but for those that only calculate. */
internal class NewerInstructions(
    private val reader: ByteReader,
    private val locationOf: (Int) -> CodeLocation,
    private val messages: LinkMessages,
) {
    /** Decodes [opcode], which is at [offset]; null if it is another. */
    fun read(opcode: Int, offset: Int): Instruction? = when (opcode) {
        Opcode.TABLESWITCH -> tableSwitch(offset)
        Opcode.LOOKUPSWITCH -> lookupSwitch(offset)
        Opcode.LDC_W -> Instruction(Opcode.LDC, offset, offset + 3, reader.unsignedShort())
        Opcode.GOTO_W -> Instruction(Opcode.GOTO, offset, offset + 5, offset + reader.int())
        Opcode.WIDE -> wide(offset)
        else -> null
    }

    private fun tableSwitch(offset: Int): Instruction {
        skipPadding()
        val default = offset + reader.int()
        val low = reader.int()
        val high = reader.int()
        val count = high.toLong() - low + 1
        if (count !in 0..MOST_KEYS) damaged("a wrong switch")
        val targets = IntArray(count.toInt()) { offset + reader.int() }
        return made(offset, default, IntArray(targets.size) { low + it }, targets)
    }

    private fun lookupSwitch(offset: Int): Instruction {
        skipPadding()
        val default = offset + reader.int()
        val count = reader.int()
        if (count !in 0..MOST_KEYS) damaged("a wrong switch")
        val keys = IntArray(count)
        val targets = IntArray(count) {
            keys[it] = reader.int()
            offset + reader.int()
        }
        for (index in 1 until count) if (keys[index] <= keys[index - 1]) damaged("a wrong switch")
        return made(offset, default, keys, targets)
    }

    private fun made(offset: Int, default: Int, keys: IntArray, targets: IntArray) =
        Instruction(Opcode.TABLESWITCH, offset, reader.position, default, 0, keys, targets)

    private fun skipPadding() {
        while (reader.position % PADDED_TO != 0) reader.unsignedByte()
    }

    private fun wide(offset: Int): Instruction {
        val opcode = reader.unsignedByte()
        val isLocal = opcode in Opcode.ILOAD..Opcode.ALOAD || opcode in Opcode.ISTORE..Opcode.ASTORE ||
            opcode == Opcode.RET || opcode == Opcode.IINC
        if (!isLocal) damaged("a wrong wide bytecode")
        val local = reader.unsignedShort()
        if (local > TinyVmLimits.LOCALS) {
            locationOf(offset).reject(messages.unsupportedFeature(UnsupportedFeature.MANY_LOCALS))
        }
        val step = if (opcode == Opcode.IINC) reader.signedShort() else 0
        return Instruction(opcode, offset, reader.position, local, step)
    }

    private companion object {
        const val PADDED_TO = 4
        const val MOST_KEYS = 16_384
    }
}
