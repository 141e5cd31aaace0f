package robotran.nqc.syntax

/** All signs, the longest first: the longest one that fits is meant. */
internal object Signs {
    private val THREE = setOf("||=", "+-=", ">>=", "<<=")
    private val TWO = setOf(
        "@@",
        "&&",
        "||",
        "==",
        "!=",
        "<=",
        ">=",
        "<<",
        ">>",
        "++",
        "--",
        "+=",
        "-=",
        "*=",
        "/=",
        "&=",
        "|=",
        "%=",
        "^=",
        "##",
    )
    private const val ONE = "{}()[];,:?=+-*/%&|^~!<>@$#"

    /** The operators that assign. */
    val ASSIGNMENTS = setOf("=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>=", "||=", "+-=")

    /** The length of the sign at [index] of [text]; 0 if there is none. */
    fun lengthAt(text: String, index: Int): Int = when {
        index + 2 < text.length && text.substring(index, index + 3) in THREE -> 3
        index + 1 < text.length && text.substring(index, index + 2) in TWO -> 2
        text[index] in ONE -> 1
        else -> 0
    }
}
