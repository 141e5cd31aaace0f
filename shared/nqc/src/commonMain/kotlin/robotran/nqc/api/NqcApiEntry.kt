package robotran.nqc.api

import robotran.language.Language
import robotran.nqc.tree.FunctionUnit

/**
 * A name that every NQC program has.
 *
 * @property parameters the names of its arguments; null if it takes none, not even brackets.
 * @property function what it does; null if it is no function.
 */
class NqcApiEntry internal constructor(
    val name: String,
    val kind: NqcApiKind,
    val parameters: List<String>?,
    internal val function: FunctionUnit?,
    internal val doc: ApiDoc,
) {
    /** One sentence about what it does. */
    fun help(language: Language): String = doc.help.of(language)

    /** As it is used: `SetPower(outputs, power)`. */
    val signature: String get() = name + (parameters?.joinToString(prefix = "(", postfix = ")") ?: "")
}

enum class NqcApiKind {
    /** A statement. */
    FUNCTION,

    /** Something that can be read, such as a sensor, and sometimes assigned to. */
    VALUE,
    CONSTANT,
}
