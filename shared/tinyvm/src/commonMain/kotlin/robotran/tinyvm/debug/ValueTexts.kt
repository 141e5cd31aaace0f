package robotran.tinyvm.debug

import robotran.tinyvm.link.ArrayType
import robotran.tinyvm.link.LinkedClass
import robotran.tinyvm.run.Heap
import robotran.tinyvm.run.VirtualMachine
import robotran.tinyvm.run.longAt

/**
 * Formats values as a Java program writes them. A variable may be uninitialized, so its word need not be a valid
 * reference.
 */
internal class ValueTexts(private val machine: VirtualMachine) {
    private val isExact = machine.model.isExact

    /** Formats the value of a variable of type [descriptor] that is in [words] from index [at] on. */
    fun of(descriptor: String, words: IntArray, at: Int): String {
        val word = words.getOrElse(at) { 0 }
        val isLong = isExact && at + 1 < words.size
        return when (descriptor[0]) {
            'Z' -> if (word != 0) "true" else "false"
            'C' -> "'${word.toChar()}'"
            'F' -> decimal(Float.fromBits(word))

            'D' -> if (isLong) {
                NxtDecimalText.of(
                    Double.fromBits(longAt(words, at)),
                )
            } else {
                decimal(Float.fromBits(word))
            }

            'J' -> if (isLong) longAt(words, at).toString() else word.toString()
            'L', '[' -> reference(word)
            else -> word.toString()
        }
    }

    private fun decimal(number: Float): String = if (isExact) NxtDecimalText.of(number) else BrickFloatText.of(number)

    private fun reference(word: Int): String {
        if (word == 0) return "null"
        if (!machine.heap.isObject(word)) return "?"
        return when (val type = machine.heap.typeOf(word)) {
            machine.program.text -> "\"${machine.textOf(word)}\""
            is ArrayType -> array(type, word)
            is LinkedClass -> contentOf(type, word) ?: type.sourceName
        }
    }

    /** A number in an object, or the name of a constant of an enum; null for other objects. */
    private fun contentOf(type: LinkedClass, reference: Int): String? {
        val isNumber = type.name in BOXES
        val isConstant = type.superclass?.name == ENUM || type.superclass?.superclass?.name == ENUM
        if (!isExact || (!isNumber && !isConstant)) return null
        val fields = type.instanceFields
        val field = if (isNumber) fields.firstOrNull() else fields.firstOrNull { it.descriptor == TEXT }
        val place = reference + Heap.HEADER_WORDS + (field ?: return null).slot
        return if (isConstant) {
            machine.textOf(
                machine.heap.words[place],
            )
        } else {
            of(field.descriptor, machine.heap.words, place)
        }
    }

    private fun array(type: ArrayType, array: Int): String {
        val length = machine.heap.length(array)
        val words = machine.heap.words
        val shown = (0 until minOf(length, MAX_ELEMENTS)).map {
            val place = array + Heap.HEADER_WORDS + it * type.elementWords
            if (type.element is ArrayType && words[place] != 0) "[..]" else of(type.elementDescriptor, words, place)
        }
        return (if (length > MAX_ELEMENTS) shown + ".." else shown).joinToString(", ", "[", "]")
    }

    private companion object {
        const val MAX_ELEMENTS = 100
        const val ENUM = "java/lang/Enum"
        const val TEXT = "Ljava/lang/String;"
        val BOXES =
            listOf("Boolean", "Byte", "Character", "Short", "Integer", "Long", "Float", "Double").map {
                "java/lang/$it"
            }
    }
}
