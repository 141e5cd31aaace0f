package robotran.tinyvm.classfile

import robotran.tinyvm.config.TinyVmLimits

/**
 * The parameter types and the result type of a method as class file descriptors: `I`, `Z`, `[C`, `Ljava/lang/String;`,
 * and `V` for no result.
 */
class MethodDescriptor private constructor(val parameters: List<String>, val result: String) {
    /** Words of the parameters, without `this`; a long or double takes two. */
    val parameterWords: Int get() = parameters.sumOf { wordsOf(it) }

    companion object {
        /** Parses [text]; throws [DamagedClassFile] if it is not a method descriptor. */
        fun of(text: String): MethodDescriptor {
            if (!text.startsWith("(")) damaged("a wrong method type")
            val parameters = ArrayList<String>()
            var index = 1
            while (index < text.length && text[index] != ')') {
                val end = endOfType(text, index)
                parameters += text.substring(index, end)
                index = end
            }
            val result = text.drop(index + 1)
            if (result != "V" && endOfType(result, 0) != result.length) damaged("a wrong method type")
            return MethodDescriptor(parameters, result)
        }
    }
}

/** Words that a value of type [descriptor] takes in locals and operands. */
fun wordsOf(descriptor: String): Int = when (descriptor) {
    "V" -> 0
    "J", "D" -> 2
    else -> 1
}

/** The index after the type that begins at [start] in [text]; throws [DamagedClassFile] if there is no type. */
internal fun endOfType(text: String, start: Int): Int {
    var index = start
    while (index < text.length && text[index] == '[') index++
    if (index >= text.length || index - start > TinyVmLimits.ARRAY_DIMENSIONS) damaged("a wrong type")
    if (text[index] in "ZBCSIJFD") return index + 1
    if (text[index] != 'L') damaged("a wrong type")
    val end = text.indexOf(';', index)
    if (end <= index + 1) damaged("a wrong type")
    return end + 1
}
