package robotran.tinyvm.link

import robotran.tinyvm.classfile.Constant
import robotran.tinyvm.classfile.MethodEntry

/**
 * Estimates the bytes of brick memory that a linked program takes: the records of classes, callable methods, `catch`
 * clauses, constants and static fields, their content, and the code. Source of the record sizes: `TinyVMConstants` and
 * the record classes of leJOS 3.0.
 */
internal class ProgramSize(private val classes: List<LinkedClass>, private val texts: List<String>) {
    private val bySignature: Map<String, List<LinkedMethod>> = classes.flatMap { it.methods }.groupBy { it.signature }

    /** @param first the entry points: `main`, and `run` of threads. */
    fun bytes(first: List<LinkedMethod>): Int {
        val methods = calledFrom(first + classes.mapNotNull { it.initializer })
        return classes.sumOf { bytesOf(it) } + methods.sumOf { bytesOf(it.entry) } +
            texts.sumOf { CONSTANT_RECORD + it.length }
    }

    private fun calledFrom(first: List<LinkedMethod>): Set<LinkedMethod> {
        val found = LinkedHashSet<LinkedMethod>()
        val worklist = ArrayDeque(first.flatMap { callTargets(it) })
        while (worklist.isNotEmpty()) {
            val method = worklist.removeFirst()
            if (found.add(method)) method.called.forEach { worklist += callTargets(it) }
        }
        return found
    }

    /** The methods that a call of [method] may execute. */
    private fun callTargets(method: LinkedMethod): List<LinkedMethod> {
        val canBeOverridden = method.virtualIndex >= 0 || method.owner.isInterface
        return if (canBeOverridden) bySignature.getValue(method.signature) else listOf(method)
    }

    private fun bytesOf(linked: LinkedClass): Int {
        val fields = linked.fields.sumOf { if (it.isStatic) STATIC_FIELD_RECORD + brickBytesOf(it.descriptor) else 1 }
        return CLASS_RECORD + fields + numbersIn(linked) * (CONSTANT_RECORD + NUMBER)
    }

    private fun bytesOf(method: MethodEntry): Int {
        val code = method.code ?: return METHOD_RECORD
        return METHOD_RECORD + code.bytes.size + code.handlers.size * HANDLER_RECORD
    }

    private fun numbersIn(linked: LinkedClass): Int = linked.file.constants.all.count {
        it is Constant.Whole || it is Constant.Decimal || it is Constant.Long || it is Constant.Double
    }

    private companion object {
        const val CLASS_RECORD = 10
        const val METHOD_RECORD = 11
        const val HANDLER_RECORD = 7
        const val CONSTANT_RECORD = 4
        const val STATIC_FIELD_RECORD = 2
        const val NUMBER = 4
    }
}
