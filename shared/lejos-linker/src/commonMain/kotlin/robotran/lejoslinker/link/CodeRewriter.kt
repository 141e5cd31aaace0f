package robotran.lejoslinker.link

import robotran.lejoslinker.messages.tinyVm
import robotran.tinyvm.classfile.CodeEntry
import robotran.tinyvm.classfile.DamagedClassFile
import robotran.tinyvm.link.Opcode
import robotran.tinyvm.link.UNSUPPORTED_OPCODES

/**
 * Replaces the constant indices in a method's code by the numbers of the image. The code keeps its length. Source: leJOS
 * `CodeUtilities.java`, processCode.
 */
internal class CodeRewriter(private val tables: LinkedTables, private val method: ImageMethod, body: CodeEntry) {
    private val messages = tables.messages
    private val lines = body.lines
    private val variables = body.variables
    private val code = body.bytes.copyOf()
    private val operands = OperandWriter(tables, method.owner.file.constants, ::refuse)
    private var position = 0

    /** Returns the code for the image; adds what the firmware cannot run to the errors. */
    fun rewrite(): ByteArray {
        while (position < code.size) {
            val opcode = byteAt(position)
            val length = if (opcode == Opcode.WIDE) wideLength() else lengthOf(opcode)
            val unsupported = UNSUPPORTED_OPCODES[opcode]
            when {
                isLargeStep() -> refuseLargeStep()
                unsupported != null -> refuse(messages.tinyVm.unsupportedFeature(unsupported))
                length == 0 || position + length > code.size -> refuse(messages.tinyVm.codeInvalid())
                else -> rewriteChecked(opcode)
            }
            // The length of a switch depends on its operands; what follows it is not looked at.
            position += if (length == 0) code.size else length
        }
        return code
    }

    private fun rewriteChecked(opcode: Int) = try {
        rewriteInstruction(opcode)
    } catch (_: DamagedClassFile) {
        refuse(messages.tinyVm.codeInvalid())
    }

    private fun rewriteInstruction(opcode: Int) {
        when (opcode) {
            Opcode.LDC -> set(1, operands.loadedConstant(byteAt(position + 1), method))
            Opcode.LDC2_W -> setShort(1, operands.wideConstant(index()))

            Opcode.NEW, Opcode.CHECKCAST, Opcode.INSTANCEOF -> {
                setShort(1, operands.classNumber(index(), isTest = opcode != Opcode.NEW))
            }

            Opcode.GETSTATIC, Opcode.PUTSTATIC -> setShort(1, operands.staticField(index(), method))
            Opcode.GETFIELD, Opcode.PUTFIELD -> setShort(1, operands.instanceField(index()))
            Opcode.INVOKESTATIC, Opcode.INVOKESPECIAL -> setShort(1, operands.exactMethod(index()))
            Opcode.INVOKEVIRTUAL -> setShort(1, operands.virtualMethod(index()))

            Opcode.INVOKEINTERFACE -> {
                setShort(1, operands.virtualMethod(index()))
                set(0, Opcode.INVOKEVIRTUAL)
                setShort(COUNT_OF_INTERFACE_CALL, NOP_NOP)
            }

            Opcode.ANEWARRAY -> {
                operands.checkClass(index())
                set(0, Opcode.NEWARRAY)
                setShort(1, REFERENCE_NOP)
            }

            Opcode.MULTIANEWARRAY -> setShort(1, operands.arrayClass(index(), byteAt(position + DIMENSIONS_OF_ARRAY)))
        }
    }

    private fun wideLength() = if (byteAtOrNull(position + 1) == Opcode.IINC) WIDE_STEP_BYTES else WIDE_BYTES

    private fun isLargeStep() = byteAt(position) == Opcode.WIDE && byteAtOrNull(position + 1) == Opcode.IINC &&
        position + WIDE_STEP_BYTES <= code.size && shortAt(position + 2) <= MAX_LOCAL

    private fun refuseLargeStep() {
        val slot = shortAt(position + 2)
        val step = shortAt(position + 4).toShort().toInt()
        val variable = variables.find { it.slot == slot && position in it.start until it.end }
        refuse(messages.largeStep(variable?.name ?: UNKNOWN_VARIABLE, step))
    }

    private fun refuse(message: String) {
        tables.errors.add(method.place.copy(line = lines.lineAt(position)), message)
    }

    private fun index() = shortAt(position + 1)

    private fun byteAt(at: Int) = code[at].toInt() and 0xFF

    private fun byteAtOrNull(at: Int) = if (at < code.size) byteAt(at) else null

    private fun shortAt(at: Int) = byteAt(at) shl 8 or byteAt(at + 1)

    private fun set(offset: Int, value: Int) {
        code[position + offset] = value.toByte()
    }

    private fun setShort(offset: Int, value: Int) {
        set(offset, value shr 8)
        set(offset + 1, value)
    }

    private companion object {
        const val WIDE_BYTES = 4
        const val WIDE_STEP_BYTES = 6
        const val MAX_LOCAL = 0xFF
        const val COUNT_OF_INTERFACE_CALL = 3
        const val DIMENSIONS_OF_ARRAY = 3
        const val NOP_NOP = 0

        /** The element type of references, and a `nop`. */
        const val REFERENCE_NOP = 0
        const val UNKNOWN_VARIABLE = "number"
    }
}
