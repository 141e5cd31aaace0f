package robotran.tinyvm.link

import robotran.tinyvm.classfile.ByteReader
import robotran.tinyvm.classfile.CodeEntry
import robotran.tinyvm.classfile.DamagedClassFile
import robotran.tinyvm.config.TinyVmLimits
import robotran.tinyvm.messages.LinkMessages
import robotran.tinyvm.messages.UnsupportedFeature

/**
 * Decodes a method's code into instructions and rejects those that a machine does not support.
 *
 * @param isExact whether it is an exact machine.
 */
internal class InstructionReader(
    private val code: CodeEntry,
    private val messages: LinkMessages,
    private val isExact: Boolean = false,
    private val locationOf: (Int) -> CodeLocation,
) {
    private val reader = ByteReader(code.bytes)
    private val simple = simpleInstructions(isExact)
    private val newer = NewerInstructions(reader, locationOf, messages)

    /** The instructions, indexed by byte position. */
    fun read(): Array<Instruction?> {
        val instructions = arrayOfNulls<Instruction>(code.bytes.size)
        while (!reader.isAtEnd) {
            val offset = reader.position
            instructions[offset] = try {
                readInstruction(offset)
            } catch (_: DamagedClassFile) {
                locationOf(offset).unsound(messages)
            }
        }
        return instructions
    }

    private fun readInstruction(offset: Int): Instruction {
        val opcode = reader.unsignedByte()
        largeStep(opcode, offset)?.let { return it }
        if (isExact) newer.read(opcode, offset)?.let { return it }
        if (simple[opcode] != null) return made(opcode, offset)
        UNSUPPORTED_OPCODES[opcode]?.let { locationOf(offset).reject(messages.unsupportedFeature(it)) }
        return when (opcode) {
            Opcode.ACONST_NULL -> made(opcode, offset)
            Opcode.BIPUSH -> made(opcode, offset, reader.signedByte())
            Opcode.SIPUSH -> made(opcode, offset, reader.signedShort())
            Opcode.LDC -> made(opcode, offset, reader.unsignedByte())

            in Opcode.ILOAD..Opcode.ALOAD, in Opcode.ISTORE..Opcode.ASTORE, Opcode.RET, Opcode.NEWARRAY -> {
                made(opcode, offset, reader.unsignedByte())
            }

            in Opcode.ILOAD_0..Opcode.ALOAD_3 -> shortForm(Opcode.ILOAD, opcode - Opcode.ILOAD_0, offset)
            in Opcode.ISTORE_0..Opcode.ASTORE_3 -> shortForm(Opcode.ISTORE, opcode - Opcode.ISTORE_0, offset)

            Opcode.IINC -> {
                val local = reader.unsignedByte()
                val step = reader.signedByte()
                made(opcode, offset, local, step)
            }

            in Opcode.IFEQ..Opcode.JSR, Opcode.IFNULL, Opcode.IFNONNULL -> {
                made(opcode, offset, offset + reader.signedShort())
            }

            Opcode.LDC2_W,
            in Opcode.GETSTATIC..Opcode.INVOKESTATIC,
            Opcode.NEW,
            Opcode.ANEWARRAY,
            Opcode.CHECKCAST,
            Opcode.INSTANCEOF,
            -> {
                made(opcode, offset, reader.unsignedShort())
            }

            Opcode.INVOKEINTERFACE -> {
                val constant = reader.unsignedShort()
                reader.unsignedShort()
                made(opcode, offset, constant)
            }

            Opcode.MULTIANEWARRAY -> {
                val constant = reader.unsignedShort()
                val dimensions = reader.unsignedByte()
                made(opcode, offset, constant, dimensions)
            }

            in WITHOUT_OPERANDS -> made(opcode, offset)
            else -> locationOf(offset).unsound(messages)
        }
    }

    /**
     * Decodes the `wide iinc` of `number += 1000`, otherwise returns null. The leJOS linker rejects wide bytecodes, but
     * some compilers emit this one for ordinary code, so it is accepted.
     */
    private fun largeStep(opcode: Int, offset: Int): Instruction? {
        if (opcode != Opcode.WIDE || code.bytes.getOrNull(offset + 1) != Opcode.IINC.toByte()) return null
        reader.unsignedByte()
        val local = reader.unsignedShort()
        val step = reader.signedShort()
        if (local > TinyVmLimits.LOCALS) {
            locationOf(offset).reject(messages.unsupportedFeature(UnsupportedFeature.MANY_LOCALS))
        }
        return made(Opcode.IINC, offset, local, step)
    }

    private fun shortForm(first: Int, index: Int, offset: Int) = made(
        first + index / SHORT_FORMS,
        offset,
        index % SHORT_FORMS,
    )

    private fun made(opcode: Int, offset: Int, operand: Int = 0, second: Int = 0) =
        Instruction(opcode, offset, reader.position, operand, second)

    private companion object {
        const val SHORT_FORMS = 4

        val WITHOUT_OPERANDS: Set<Int> = (Opcode.IALOAD..Opcode.SALOAD).toSet() + (Opcode.IASTORE..Opcode.SWAP) +
            (Opcode.IRETURN..Opcode.RETURN) + Opcode.ARRAYLENGTH + Opcode.ATHROW + Opcode.MONITORENTER +
            Opcode.MONITOREXIT
    }
}
