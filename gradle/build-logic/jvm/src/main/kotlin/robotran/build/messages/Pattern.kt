package robotran.build.messages

/** A sentence with its placeholders and choices: the parts are said one after the other. */
class Pattern(val parts: List<PatternPart>)

sealed interface PatternPart {
    class Text(val text: String) : PatternPart

    /** The value of a parameter, a property of one, or another message: an [expression] in Kotlin. */
    class Placeholder(val expression: String) : PatternPart

    /** The number of the choice around it. */
    object CountedNumber : PatternPart

    /** A value as the language writes it. */
    class Formatted(val expression: String, val format: ValueFormat) : PatternPart

    /** The things of a list, with [word] before the last one. */
    class Listed(val expression: String, val word: String) : PatternPart

    /** One of the [arms], by the value of [expression]. */
    class Choice(val expression: String, val kind: ChoiceKind, val arms: List<Arm>) : PatternPart
}

enum class ValueFormat(val keyword: String) {
    /** A text such as `1.5`, with the language's decimal sign. */
    NUMBER("number"),

    /** A whole number with the language's sign between thousands. */
    GROUPED("grouped"),
}

enum class ChoiceKind(val keyword: String) { PLURAL("plural"), SELECT("select") }

/** @property keys any of them chooses this arm. */
class Arm(val keys: List<String>, val pattern: Pattern)

/** The key of the arm for all other values. */
const val OTHER = "other"
