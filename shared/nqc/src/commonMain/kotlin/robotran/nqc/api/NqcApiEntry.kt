package robotran.nqc.api

import robotran.language.Language
import robotran.language.choose
import robotran.legofirmware.image.FirmwareTarget

/**
 * A name that every NQC program has.
 *
 * @property parameters the names of its arguments; null if it takes none, not even brackets.
 * @property targets the firmware that has it.
 */
class NqcApiEntry internal constructor(
    val name: String,
    val kind: NqcApiKind,
    val group: NqcApiGroup,
    val parameters: List<String>?,
    val targets: Set<FirmwareTarget>,
    internal val definition: ApiDefinition,
    private val help: ApiHelp,
) {
    /** One sentence about what it does. */
    fun help(language: Language): String = help.of(language)

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

/** What an entry of the API is about. */
enum class NqcApiGroup { OUTPUTS, SENSORS, SOUND, DISPLAY, DATALOG, TIME, EVENTS, MESSAGES, TASKS, SERIAL, OTHER }

/** One sentence in each language. */
internal class ApiHelp(private val english: String, private val german: String, private val spanish: String) {
    fun of(language: Language): String = language.choose(english, spanish, german)
}
