package robotran.lejoslinker.link

import robotran.tinyvm.classfile.CodeEntry
import robotran.tinyvm.classfile.DamagedClassFile
import robotran.tinyvm.link.Opcode

/** The instructions of [code] that name a constant of their class file. What is damaged is left out. */
internal class CodeReferences(private val code: CodeEntry) {
    /** Passes opcode and index in the pool to [visit]. */
    fun forEach(visit: (Int, Int) -> Unit) {
        val bytes = code.bytes
        var position = 0
        while (position < bytes.size) {
            val opcode = bytes[position].toInt() and BYTE
            val isWideStep =
                opcode == Opcode.WIDE && bytes.getOrNull(position + 1)?.toInt() == Opcode.IINC.toByte().toInt()
            val length = when {
                isWideStep -> WIDE_STEP_BYTES
                opcode == Opcode.WIDE -> WIDE_BYTES
                else -> lengthOf(opcode)
            }
            if (length == 0 || position + length > bytes.size) return
            val first = bytes[(position + 1).coerceAtMost(bytes.lastIndex)].toInt() and BYTE
            if (opcode == Opcode.LDC) {
                tryVisit(visit, opcode, first)
            } else if (opcode in WITH_INDEX) {
                tryVisit(visit, opcode, first shl BYTE_BITS or (bytes[position + 2].toInt() and BYTE))
            }
            position += length
        }
    }

    private fun tryVisit(visit: (Int, Int) -> Unit, opcode: Int, index: Int) = try {
        visit(opcode, index)
    } catch (_: DamagedClassFile) {
        // The code that names it is refused when it is written.
    }

    private companion object {
        const val BYTE = 0xFF
        const val BYTE_BITS = 8
        const val WIDE_BYTES = 4
        const val WIDE_STEP_BYTES = 6

        val WITH_INDEX = (Opcode.GETSTATIC..Opcode.INVOKESTATIC).toSet() + Opcode.INVOKEINTERFACE + Opcode.LDC2_W +
            Opcode.NEW + Opcode.ANEWARRAY + Opcode.CHECKCAST + Opcode.INSTANCEOF
    }
}
