package robotran.javacompiler.edit

import robotran.brick.kind.BrickKind
import robotran.languagesupport.BraceLayout
import robotran.languagesupport.BraceSyntax
import robotran.languagesupport.CompletionList
import robotran.languagesupport.CompletionRequest
import robotran.languagesupport.LineTokens
import robotran.languagesupport.TextLines

/** What editors ask about Java. */
internal object JavaSyntax : BraceSyntax() {
    override val keys =
        listOf("(", ")", "{", "}", ";", ".", "=", "<", ">", "+", "-", "*", "/", "\"", "[", "]", "&", "|", "!")

    override val layout = BraceLayout(setOf("if", "for", "while", "else"), openEnds = setOf("else", "do"))

    override fun structure(line: String, startsInComment: Boolean): LineTokens =
        tokenizeJavaLine(line, startsInComment, brick = null)

    override fun tokens(line: String, startsInComment: Boolean, brick: BrickKind): LineTokens =
        tokenizeJavaLine(line, startsInComment, brick)

    override fun brickOf(lines: TextLines): BrickKind? = brickOfJava(lines)

    override fun complete(request: CompletionRequest): CompletionList? = completeJava(request)

    /** No other language has classes with braces. */
    override fun isRecognised(text: String): Boolean = CLASS.containsMatchIn(text)

    private val CLASS = Regex("\\b(class|interface)\\s+\\w+[^\\n]*\\{")
}
