package robotran.javacompiler.edit

import robotran.brick.kind.BrickKind
import robotran.languagesupport.BlockEffect
import robotran.languagesupport.CodeSyntax
import robotran.languagesupport.CodeTokenKind
import robotran.languagesupport.CompletionList
import robotran.languagesupport.CompletionRequest
import robotran.languagesupport.LineTokens
import robotran.languagesupport.TextLines

/** What editors ask about Java. */
internal object JavaSyntax : CodeSyntax {
    override val indent = "    "
    override val blockEnds = setOf("}")
    override val hasLongComments = true
    override val keys =
        listOf("(", ")", "{", "}", ";", ".", "=", "<", ">", "+", "-", "*", "/", "\"", "[", "]", "&", "|", "!")

    override fun blockEffect(line: String): BlockEffect {
        val braces = bracesOf(line)
        return BlockEffect(
            closes = line.trimStart().startsWith('}'),
            opens = braces.lastIndexOf('{') > braces.lastIndexOf('}'),
        )
    }

    /** The braces of a line outside strings and comments. */
    private fun bracesOf(line: String): String = tokenizeJavaLine(line, startsInComment = false, brick = null).tokens
        .filter { it.kind == CodeTokenKind.SIGN }
        .joinToString("") { line.substring(it.start, it.end) }
        .filter { it == '{' || it == '}' }

    override fun tokens(line: String, startsInComment: Boolean, brick: BrickKind): LineTokens =
        tokenizeJavaLine(line, startsInComment, brick)

    override fun brickOf(lines: TextLines): BrickKind? = brickOfJava(lines)

    override fun complete(request: CompletionRequest): CompletionList? = completeJava(request)

    override fun format(source: String): String = formatJava(source)

    /** No other language has classes with braces. */
    override fun isRecognised(text: String): Boolean = CLASS.containsMatchIn(text)

    private val CLASS = Regex("\\b(class|interface)\\s+\\w+[^\\n]*\\{")
}
