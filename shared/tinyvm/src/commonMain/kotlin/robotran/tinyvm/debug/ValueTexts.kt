package robotran.tinyvm.debug

import robotran.tinyvm.link.ArrayType
import robotran.tinyvm.link.LinkedClass
import robotran.tinyvm.run.Heap
import robotran.tinyvm.run.VirtualMachine

/**
 * Formats values as a Java program writes them. A variable may be uninitialized, so its word need not be a valid
 * reference.
 */
internal class ValueTexts(private val machine: VirtualMachine) {
    /** Formats [word], the value of a variable of type [descriptor]. */
    fun of(descriptor: String, word: Int): String = when (descriptor[0]) {
        'Z' -> if (word != 0) "true" else "false"
        'C' -> "'${word.toChar()}'"
        'F', 'D' -> BrickFloatText.of(Float.fromBits(word))
        'L', '[' -> reference(word)
        else -> word.toString()
    }

    private fun reference(word: Int): String {
        if (word == 0) return "null"
        if (!machine.heap.isObject(word)) return "?"
        return when (val type = machine.heap.typeOf(word)) {
            machine.program.text -> "\"${machine.textOf(word)}\""
            is ArrayType -> array(type, word)
            is LinkedClass -> type.sourceName
        }
    }

    private fun array(type: ArrayType, array: Int): String {
        val length = machine.heap.length(array)
        val shown = (0 until minOf(length, MAX_ELEMENTS)).map {
            val element = machine.heap.words[array + Heap.HEADER_WORDS + it]
            if (type.element is ArrayType && element != 0) "[..]" else of(type.elementDescriptor, element)
        }
        return (if (length > MAX_ELEMENTS) shown + ".." else shown).joinToString(", ", "[", "]")
    }

    private companion object {
        const val MAX_ELEMENTS = 100
    }
}
