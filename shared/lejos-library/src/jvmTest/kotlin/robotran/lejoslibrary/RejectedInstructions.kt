package robotran.lejoslibrary

import org.apache.bcel.Const
import org.apache.bcel.classfile.JavaClass
import org.apache.bcel.generic.CHECKCAST
import org.apache.bcel.generic.ConstantPoolGen
import org.apache.bcel.generic.IINC
import org.apache.bcel.generic.INSTANCEOF
import org.apache.bcel.generic.Instruction
import org.apache.bcel.generic.InstructionList

/**
 * The instructions of [javaClass] that the linker of leJOS refuses, each as its line in the source, or 0, and its name.
 */
internal fun refusedInstructions(javaClass: JavaClass): List<Pair<Int, String>> = javaClass.methods.flatMap { method ->
    val code = method.code ?: return@flatMap emptyList()
    val constants = ConstantPoolGen(javaClass.constantPool)
    InstructionList(code.code).mapNotNull { handle ->
        val instruction = handle.instruction
        val isOfArray = (instruction as? CHECKCAST)?.getType(constants)?.signature?.startsWith("[")
            ?: (instruction as? INSTANCEOF)?.getType(constants)?.signature?.startsWith("[")
            ?: false
        val isWide = code.code[handle.position].toInt() and BYTE == Const.WIDE.toInt() && !isLargeStep(instruction)
        val line = code.lineNumberTable?.getSourceLine(handle.position) ?: 0
        when {
            isWide -> line to "wide"
            instruction.opcode in REFUSED || isOfArray -> line to instruction.name
            else -> null
        }
    }
}

/** ECJ makes one of `number = number + 1000`, too, where other compilers add, so it cannot be the pupil's fault. */
private fun isLargeStep(instruction: Instruction): Boolean = instruction is IINC && instruction.index <= BYTE

private const val BYTE = 0xFF

/** Source: `CodeUtilities` of `js.tinyvm` in leJOS 3.0. */
private val REFUSED: Set<Short> = setOf(
    Const.LOOKUPSWITCH,
    Const.TABLESWITCH,
    Const.GOTO_W,
    Const.JSR_W,
    Const.LDC_W,
    Const.FREM,
    Const.DREM,
    Const.LADD,
    Const.LSUB,
    Const.LMUL,
    Const.LDIV,
    Const.LREM,
    Const.LNEG,
    Const.LCMP,
    Const.LSHL,
    Const.LSHR,
    Const.LUSHR,
    Const.LAND,
    Const.LOR,
    Const.LXOR,
    Const.INVOKEDYNAMIC,
)
