package robotran.tinyvm.run

import robotran.tinyvm.link.ArrayType
import robotran.tinyvm.link.HeapType
import robotran.tinyvm.link.RegisterOperation

/**
 * The calls of register code that a program for an RCX has seldom or never. They are not in the interpreter's loop, which
 * would become too large to be compiled well.
 */
internal class FarCalls(machine: VirtualMachine) {
    private val words = machine.heap.words

    /** The numbers of the methods to call by type and number of the interface method, -1 for none; only on an exact machine. */
    private val interfaceMethods: Array<IntArray> =
        if (machine.model.isExact) interfaceNumbers(machine.program.types) else emptyArray()

    /**
     * The number of the method that the instruction at [at] of [code] calls, with the registers of [stack] from [base] on;
     * -1 if the stack code must call it. Puts the object whose method it is where the first argument belongs.
     */
    fun method(code: IntArray, at: Int, stack: IntArray, base: Int): Int {
        val word = code[at]
        val operation = word and BYTE
        if (operation == RegisterOperation.CALL_STATIC_FAR) return code[at + 2]
        val receiver = stack[base + (word ushr SHIFT_C)]
        if (receiver == 0) return -1
        stack[base + (word ushr SHIFT_A and BYTE)] = receiver
        if (operation == RegisterOperation.CALL_EXACTLY_FAR) return code[at + 2]
        return interfaceMethods[words[receiver]][word ushr SHIFT_B and BYTE]
    }

    private fun interfaceNumbers(types: List<HeapType>): Array<IntArray> {
        val ofArrays = numbersOf(types.first { it is ArrayType })
        return Array(types.size) {
            val type = types[it]
            if (type is ArrayType) ofArrays else numbersOf(type)
        }
    }

    private fun numbersOf(type: HeapType): IntArray {
        val methods = type.interfaceMethods
        return IntArray(methods.size) { methods[it]?.number ?: -1 }
    }

    private companion object {
        const val BYTE = 0xFF
        const val SHIFT_A = 8
        const val SHIFT_B = 16
        const val SHIFT_C = 24
    }
}
