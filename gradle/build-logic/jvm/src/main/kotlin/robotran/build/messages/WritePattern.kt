package robotran.build.messages

/** Writes the patterns of [message] in [language] as Kotlin expressions. */
class PatternWriter(private val message: Message, private val language: SpokenLanguage) {
    /** An expression of type `String`. */
    fun expression(pattern: Pattern): String = expression(pattern, counted = null)

    /** @param counted the expression of the number that the choice around counts. */
    private fun expression(pattern: Pattern, counted: String?): String {
        val only = pattern.parts.singleOrNull()
        if (only is PatternPart.Choice) return choice(only, counted)
        return pattern.parts.joinToString("", prefix = "\"", postfix = "\"") { part ->
            when (part) {
                is PatternPart.Text -> escaped(part.text)
                is PatternPart.Placeholder -> "\${${part.expression}}"
                PatternPart.CountedNumber -> "\${$counted}"
                is PatternPart.Formatted -> "\${${formatted(part)}}"
                is PatternPart.Listed -> "\${listed(${part.expression}, \"${escaped(part.word)}\")}"
                is PatternPart.Choice -> "\${${choice(part, counted)}}"
            }
        }
    }

    private fun formatted(part: PatternPart.Formatted): String = when (part.format) {
        ValueFormat.NUMBER -> "language.decimal(${part.expression})"
        ValueFormat.GROUPED -> "language.grouped(${part.expression})"
    }

    private fun choice(choice: PatternPart.Choice, counted: String?): String {
        val number = if (choice.kind == ChoiceKind.PLURAL) choice.expression else counted
        val arms = choice.arms.joinToString("; ") { arm ->
            val condition = if (arm.keys == listOf(OTHER)) "else" else arm.keys.joinToString { condition(it, choice) }
            "$condition -> ${expression(arm.pattern, number)}"
        }
        return "when (${choice.expression}) { $arms }"
    }

    private fun condition(key: String, choice: PatternPart.Choice): String = when {
        choice.kind == ChoiceKind.PLURAL && key == ONE -> language.singular.joinToString()
        choice.kind == ChoiceKind.PLURAL && key.startsWith("=") -> key.drop(1)
        !SIMPLE_NAME.matches(key) || key in LITERALS -> key
        else -> nameIn(typeOf(choice.expression), key)
    }

    /** An entry of an enum, which is in capitals, a subtype, or a constant of a simple type. */
    private fun nameIn(type: String, key: String): String = when {
        type in SIMPLE_TYPES -> key
        key.all { it.isUpperCase() || it.isDigit() || it == '_' } -> "$type.$key"
        else -> "is $type.$key"
    }

    private fun typeOf(expression: String): String =
        message.parameters.find { it.name == expression }?.type?.removeSuffix("?")
            ?: throw CatalogueException(
                "${message.name}: $expression is no parameter, so its keys need the names of their types",
            )

    private companion object {
        const val ONE = "one"
        val SIMPLE_NAME = Regex("[A-Z]\\w*")
        val SIMPLE_TYPES = setOf("Int", "Long", "String")
        val LITERALS = setOf("true", "false", "null")
    }
}

/** [text] between the quotation marks of a string in Kotlin. */
internal fun escaped(text: String): String = buildString {
    for (character in text) {
        if (character in "\"\\$") append('\\')
        append(character)
    }
}
