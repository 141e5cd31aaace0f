package robotran.robolang.translate

import org.apache.bcel.classfile.ClassParser
import org.apache.bcel.classfile.Code
import org.apache.bcel.classfile.ConstantDouble
import org.apache.bcel.classfile.ConstantFloat
import org.apache.bcel.classfile.ConstantInteger
import org.apache.bcel.classfile.ConstantLong
import org.apache.bcel.classfile.ConstantString
import org.apache.bcel.classfile.JavaClass
import org.apache.bcel.classfile.Method
import org.apache.bcel.generic.ANEWARRAY
import org.apache.bcel.generic.CHECKCAST
import org.apache.bcel.generic.ConstantPoolGen
import org.apache.bcel.generic.ConstantPushInstruction
import org.apache.bcel.generic.INSTANCEOF
import org.apache.bcel.generic.InstructionHandle
import org.apache.bcel.generic.InstructionList
import org.apache.bcel.generic.MULTIANEWARRAY
import org.apache.bcel.generic.NEWARRAY

/** The errors that the leJOS linker would report for the class file [bytes]; empty if there are none. */
internal fun tinyVmErrors(bytes: ByteArray): List<String> {
    val javaClass = ClassParser(bytes.inputStream(), "memory").parse()
    return (
        problemsOf(javaClass) + javaClass.methods.flatMap {
            problemsOf(it, javaClass)
        }
    ).map { "${javaClass.className}: $it" }
}

private fun problemsOf(javaClass: JavaClass): List<String> {
    val constants = javaClass.constantPool.constantPool.filter {
        it is ConstantString || it is ConstantInteger || it is ConstantFloat || it is ConstantLong ||
            it is ConstantDouble
    }
    val texts = constants.filterIsInstance<ConstantString>().map { it.getBytes(javaClass.constantPool) }
    return listOfNotNull(
        tooMany("methods", javaClass.methods.size, TinyVmLimits.METHODS),
        tooMany("fields", javaClass.fields.size, TinyVmLimits.FIELDS),
        tooMany("constants", constants.size, TinyVmLimits.CONSTANTS),
        tooMany("characters in a text", texts.maxOfOrNull { it.length } ?: 0, TinyVmLimits.STRING_CHARACTERS),
    )
}

private fun problemsOf(method: Method, javaClass: JavaClass): List<String> {
    val code = method.code ?: return emptyList()
    val parameters = method.argumentTypes.sumOf { it.size } + if (method.isStatic) 0 else 1
    val sizes = listOfNotNull(
        tooMany("locals", code.maxLocals, TinyVmLimits.LOCALS),
        tooMany("operands", code.maxStack, TinyVmLimits.OPERANDS),
        tooMany("parameters", parameters, TinyVmLimits.PARAMETERS),
        tooMany("exception handlers", code.exceptionTable.size, TinyVmLimits.EXCEPTION_HANDLERS),
        tooMany("bytes of code", code.code.size, TinyVmLimits.CODE_BYTES),
    )
    return (sizes + problemsOf(code, javaClass)).map { "${method.name}: $it" }
}

private fun problemsOf(code: Code, javaClass: JavaClass): List<String> {
    val constants = ConstantPoolGen(javaClass.constantPool)
    return InstructionList(code.code).mapNotNull { handle ->
        val instruction = handle.instruction
        when {
            instruction.opcode in TinyVmLimits.REFUSED_INSTRUCTIONS -> "the linker refuses ${instruction.name}"
            instruction.opcode in TinyVmLimits.UNKNOWN_INSTRUCTIONS -> "the brick does not know ${instruction.name}"
            instruction is MULTIANEWARRAY -> "an array of arrays is no list"

            instruction is CHECKCAST && instruction.getType(
                constants,
            ).signature.startsWith("[") -> "the linker refuses casts to arrays"

            instruction is INSTANCEOF && instruction.getType(
                constants,
            ).signature.startsWith("[") -> "the linker refuses tests for arrays"

            instruction is NEWARRAY || instruction is ANEWARRAY -> tooMany(
                "elements",
                lengthBefore(handle),
                TinyVmLimits.ARRAY_ELEMENTS,
            )

            else -> null
        }
    }
}

/** The length of the array that [handle] creates, if the previous instruction is a constant; otherwise 0. */
private fun lengthBefore(handle: InstructionHandle): Int =
    (handle.prev?.instruction as? ConstantPushInstruction)?.value?.toInt() ?: 0

private fun tooMany(what: String, count: Int, max: Int): String? = "$count $what, of which $max are allowed".takeIf {
    count > max
}
