package robotran.robolang.translate

import robotran.robolang.syntax.Command
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.SyntaxTree
import robotran.robolang.syntax.bodies

/**
 * Writes the texts that a program shows. The brick allocates a new string each time it evaluates a literal, and never
 * frees it; texts that may be shown repeatedly are therefore fields.
 */
internal class JavaShownTexts(tree: SyntaxTree, private val names: JavaNames) {
    private val repeated: List<String> = repeatedTexts(tree).distinct()
    private val fields: Map<String, String> by lazy(LazyThreadSafetyMode.NONE) {
        repeated.associateWith { text -> names.shared("TEXT_" + text.map(::letter).joinToString("")) }
    }

    /** The Java expression for [text]. */
    fun of(text: String): String = fields[text] ?: javaString(text)

    fun write(writer: JavaWriter) {
        if (repeated.isEmpty()) return
        writer.blank()
        writer.line(
            "/** Texts are made here, once: where they are shown the brick would make new ones until its memory is " +
                "full. */",
        )
        for ((text, name) in fields) writer.line("static final char[] $name = ${javaString(text)}.toCharArray();")
    }

    private fun repeatedTexts(tree: SyntaxTree): List<String> {
        val again = tree.routines.flatMap { it.body } + tree.behaviours.flatMap { it.body }
        return shown(tree.statements, isRepeated = false) + shown(again, isRepeated = true)
    }

    private fun shown(statements: List<Statement>, isRepeated: Boolean): List<String> =
        statements.flatMap { statement ->
            val own = (statement as? Command.ShowText)?.text?.takeIf { isRepeated }
            listOfNotNull(own) + statement.bodies.flatMap { shown(it, isRepeated || statement is Statement.Loop) }
        }

    private fun letter(character: Char): Char = when (character) {
        in 'a'..'z' -> character - ('a' - 'A')
        in 'A'..'Z', in '0'..'9' -> character
        else -> '_'
    }
}

/** [text] as a Java string literal in ASCII. */
internal fun javaString(text: String): String = buildString {
    append('"')
    for (character in text) {
        when (character) {
            '"', '\\' -> append('\\').append(character)
            in ' '..'~' -> append(character)
            else -> append("\\u").append(character.code.toString(radix = 16).padStart(4, '0'))
        }
    }
    append('"')
}
