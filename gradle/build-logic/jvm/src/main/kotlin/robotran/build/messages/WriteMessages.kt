package robotran.build.messages

/**
 * Writes the Kotlin of the tables of [catalogue]: an interface for each and a class for each of the [languages], or one
 * object for all languages. An instance of a class is made when its language is first asked for: Kotlin/Wasm makes objects
 * when the module starts, and with each comes a reference of every message, so that a page would load all of them first.
 */
class MessagesWriter(private val catalogue: MessageCatalogue, private val languages: List<SpokenLanguage>) {
    /** The contents of files by their names. */
    fun files(): Map<String, String> = catalogue.tables.flatMap { table ->
        if (table.isObject) {
            listOf("${table.name}.kt" to file(wholeObject(table)))
        } else {
            languages.map { "${className(table, it)}.kt" to file(classOf(table, it)) } +
                ("${table.name}.kt" to file(interfaceOf(table)))
        }
    }.toMap()

    private fun file(code: String) = buildString {
        append("// Generated from a catalogue of messages.\n")
        append("@file:Suppress(\"ktlint\", \"REDUNDANT_ELSE_IN_WHEN\", \"UNUSED_PARAMETER\")\n\n")
        append("package ${catalogue.packageName}\n\n")
        (catalogue.imports + USED).sorted().forEach { append("import $it\n") }
        append("\n$code")
    }

    private fun interfaceOf(table: MessageTable) = buildString {
        append(documentation(table.documentation, indent = ""))
        append("${visibility(table)}interface ${table.name}${bases(table.bases)} {\n")
        val modifier = if (table.bases.isEmpty()) "" else "override "
        append("    /** The language of these messages. */\n    ${modifier}val language: Language\n\n")
        for (message in table.messages.filter { !it.isTerm }) {
            append(documentation(message.documentation, indent = "    "))
            append("    fun ${message.signature}: String\n\n")
        }
        append("    companion object {\n")
        append("        private val made = arrayOfNulls<${table.name}>(${languages.size})\n\n")
        append("        fun of(language: Language): ${table.name} =\n")
        append("            made[language.ordinal] ?: make(language).also { made[language.ordinal] = it }\n\n")
        append("        private fun make(language: Language): ${table.name} = when (language) {\n")
        languages.forEach { append("            Language.${it.constant} -> ${className(table, it)}()\n") }
        append("        }\n    }\n}\n")
    }

    private fun wholeObject(table: MessageTable) = buildString {
        append(documentation(table.documentation, indent = ""))
        append("${visibility(table)}object ${table.name} {\n")
        for (message in table.messages) {
            append(documentation(message.documentation, indent = "    "))
            val parameters = listOf("language: Language") + message.parameters.map { "${it.name}: ${it.type}" }
            append("    fun ${message.name}(${parameters.joinToString()}): String = when (language) {\n")
            for (language in languages) {
                val pattern = message.patterns[language.tag] ?: message.patterns.getValue(ENGLISH)
                append("        Language.${language.constant} -> ")
                append("${PatternWriter(message, language).expression(pattern)}\n")
            }
            append("    }\n\n")
        }
        append("}\n")
    }

    private fun classOf(table: MessageTable, language: SpokenLanguage) = buildString {
        val delegated = table.bases.map { "$it by $it.of(Language.${language.constant})" }
        append("internal class ${className(table, language)}${bases(listOf(table.name) + delegated)} {\n")
        append("    override val language: Language get() = Language.${language.constant}\n\n")
        for (message in table.messages) {
            val pattern = message.patterns[language.tag] ?: message.patterns[ENGLISH] ?: continue
            val modifier = if (message.isTerm) "private" else "override"
            append("    $modifier fun ${message.signature}: String =\n")
            append("        ${PatternWriter(message, language).expression(pattern)}\n\n")
        }
        append("}\n")
    }

    private fun className(table: MessageTable, language: SpokenLanguage) = "${language.className}${table.name}"

    private fun visibility(table: MessageTable) = if (table.visibility.isEmpty()) "" else "${table.visibility} "

    private fun bases(names: List<String>) = if (names.isEmpty()) "" else names.joinToString(prefix = " : ")

    private fun documentation(text: String, indent: String): String = if (text.isEmpty()) {
        ""
    } else {
        "$indent/**\n" + text.lines().joinToString("") { "$indent * $it\n" } +
            "$indent */\n"
    }

    private companion object {
        val USED = listOf("decimal", "grouped", "listed", "quoted", "Language").map { "robotran.language.$it" }
    }
}
