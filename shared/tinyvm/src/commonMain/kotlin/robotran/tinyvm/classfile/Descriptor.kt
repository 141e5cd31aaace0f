package robotran.tinyvm.classfile

import robotran.tinyvm.config.TinyVmLimits

/**
 * The types of a method's parameters and of what it returns, each as a class file writes it: `I`, `Z`, `[C`,
 * `Ljava/lang/String;`, and `V` for nothing.
 */
internal class MethodDescriptor private constructor(val parameters: List<String>, val result: String) {
    /** Words that the parameters take, `this` not counted: long and double take two. */
    val parameterWords: Int get() = parameters.sumOf { wordsOf(it) }

    companion object {
        /** Reads [text]; anything else than a method's descriptor is damage. */
        fun of(text: String): MethodDescriptor {
            if (!text.startsWith("(")) damaged("a wrong method type")
            val parameters = ArrayList<String>()
            var place = 1
            while (place < text.length && text[place] != ')') {
                val end = endOfType(text, place)
                parameters += text.substring(place, end)
                place = end
            }
            val result = text.drop(place + 1)
            if (result != "V" && endOfType(result, 0) != result.length) damaged("a wrong method type")
            return MethodDescriptor(parameters, result)
        }
    }
}

/** How many words a value of the type [descriptor] takes among locals and operands. */
internal fun wordsOf(descriptor: String): Int = when (descriptor) {
    "V" -> 0
    "J", "D" -> 2
    else -> 1
}

/** Where the type that begins at [start] of [text] ends; no type there is damage. */
internal fun endOfType(text: String, start: Int): Int {
    var place = start
    while (place < text.length && text[place] == '[') place++
    if (place >= text.length || place - start > TinyVmLimits.ARRAY_DIMENSIONS) damaged("a wrong type")
    if (text[place] in "ZBCSIJFD") return place + 1
    if (text[place] != 'L') damaged("a wrong type")
    val end = text.indexOf(';', place)
    if (end <= place + 1) damaged("a wrong type")
    return end + 1
}
