package robotran.tinyvm.link

import robotran.tinyvm.classfile.ByteReader
import robotran.tinyvm.classfile.CodeEntry
import robotran.tinyvm.classfile.DamagedClassFile
import robotran.tinyvm.config.TinyVmLimits
import robotran.tinyvm.messages.LinkMessages
import robotran.tinyvm.messages.UnsupportedFeature

/** Decodes a method's code into instructions and rejects those that TinyVM does not support. */
internal class InstructionReader(
    private val code: CodeEntry,
    private val messages: LinkMessages,
    private val placeOf: (Int) -> CodeLocation,
) {
    private val reader = ByteReader(code.bytes)

    /** The instructions, indexed by byte position. */
    fun read(): Array<Instruction?> {
        val instructions = arrayOfNulls<Instruction>(code.bytes.size)
        while (!reader.isAtEnd) {
            val place = reader.position
            instructions[place] = try {
                readInstruction(place)
            } catch (_: DamagedClassFile) {
                placeOf(place).unsound(messages)
            }
        }
        return instructions
    }

    private fun readInstruction(place: Int): Instruction {
        val opcode = reader.unsignedByte()
        largeStep(opcode, place)?.let { return it }
        LACKED[opcode]?.let { placeOf(place).refuse(messages.lacks(it)) }
        if (SIMPLE_INSTRUCTIONS[opcode] != null) return made(opcode, place)
        return when (opcode) {
            Opcode.ACONST_NULL -> {
                made(opcode, place)
            }

            Opcode.BIPUSH -> {
                made(opcode, place, reader.signedByte())
            }

            Opcode.SIPUSH -> {
                made(opcode, place, reader.signedShort())
            }

            Opcode.LDC -> {
                made(opcode, place, reader.unsignedByte())
            }

            in Opcode.ILOAD..Opcode.ALOAD, in Opcode.ISTORE..Opcode.ASTORE, Opcode.RET, Opcode.NEWARRAY -> {
                made(opcode, place, reader.unsignedByte())
            }

            in Opcode.ILOAD_0..Opcode.ALOAD_3 -> {
                shortForm(Opcode.ILOAD, opcode - Opcode.ILOAD_0, place)
            }

            in Opcode.ISTORE_0..Opcode.ASTORE_3 -> {
                shortForm(Opcode.ISTORE, opcode - Opcode.ISTORE_0, place)
            }

            Opcode.IINC -> {
                val local = reader.unsignedByte()
                val step = reader.signedByte()
                made(opcode, place, local, step)
            }

            in Opcode.IFEQ..Opcode.JSR, Opcode.IFNULL, Opcode.IFNONNULL -> {
                made(opcode, place, place + reader.signedShort())
            }

            Opcode.LDC2_W,
            in Opcode.GETSTATIC..Opcode.INVOKESTATIC,
            Opcode.NEW,
            Opcode.ANEWARRAY,
            Opcode.CHECKCAST,
            Opcode.INSTANCEOF,
            -> {
                made(opcode, place, reader.unsignedShort())
            }

            Opcode.INVOKEINTERFACE -> {
                val constant = reader.unsignedShort()
                reader.unsignedShort()
                made(opcode, place, constant)
            }

            Opcode.MULTIANEWARRAY -> {
                val constant = reader.unsignedShort()
                val dimensions = reader.unsignedByte()
                made(opcode, place, constant, dimensions)
            }

            in WITHOUT_OPERANDS -> {
                made(opcode, place)
            }

            else -> {
                placeOf(place).unsound(messages)
            }
        }
    }

    /**
     * Decodes the `wide iinc` of `number += 1000`, otherwise returns null. The leJOS linker rejects wide bytecodes, but
     * some compilers emit this one for ordinary code, so it is accepted.
     */
    private fun largeStep(opcode: Int, place: Int): Instruction? {
        if (opcode != Opcode.WIDE || code.bytes.getOrNull(place + 1) != Opcode.IINC.toByte()) return null
        reader.unsignedByte()
        val local = reader.unsignedShort()
        val step = reader.signedShort()
        if (local > TinyVmLimits.LOCALS) placeOf(place).refuse(messages.lacks(UnsupportedFeature.MANY_LOCALS))
        return made(Opcode.IINC, place, local, step)
    }

    private fun shortForm(first: Int, index: Int, place: Int) = made(
        first + index / SHORT_FORMS,
        place,
        index % SHORT_FORMS,
    )

    private fun made(opcode: Int, place: Int, operand: Int = 0, second: Int = 0) =
        Instruction(opcode, place, reader.position, operand, second)

    private companion object {
        const val SHORT_FORMS = 4

        val WITHOUT_OPERANDS: Set<Int> = (Opcode.IALOAD..Opcode.SALOAD).toSet() + (Opcode.IASTORE..Opcode.SWAP) +
            (Opcode.IRETURN..Opcode.RETURN) + Opcode.ARRAYLENGTH + Opcode.ATHROW + Opcode.MONITORENTER +
            Opcode.MONITOREXIT

        /** Source: leJOS `CodeUtilities.java`. */
        val LACKED: Map<Int, UnsupportedFeature> = mapOf(
            Opcode.TABLESWITCH to UnsupportedFeature.SWITCH,
            Opcode.LOOKUPSWITCH to UnsupportedFeature.SWITCH,
            Opcode.WIDE to UnsupportedFeature.MANY_LOCALS,
            Opcode.LDC_W to UnsupportedFeature.MANY_CONSTANTS,
            Opcode.GOTO_W to UnsupportedFeature.FAR_JUMP,
            Opcode.JSR_W to UnsupportedFeature.FAR_JUMP,
            Opcode.INVOKEDYNAMIC to UnsupportedFeature.INVOKE_DYNAMIC,
            114 to UnsupportedFeature.DECIMAL_REMAINDER,
            115 to UnsupportedFeature.DECIMAL_REMAINDER,
        ) +
            listOf(97, 101, 105, 109, 113, 117, 121, 123, 125, 127, 129, 131, 148).associateWith {
                UnsupportedFeature.LONG_ARITHMETIC
            }
    }
}
