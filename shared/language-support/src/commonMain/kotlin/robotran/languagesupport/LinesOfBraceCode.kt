package robotran.languagesupport

/** The lines of [text] in a language with the comments of C, without empty ones and comments. */
fun linesOfBraceCode(text: String): Int {
    var isInComment = false
    return text.lineSequence().count { line ->
        var rest = line
        val code = StringBuilder()
        while (rest.isNotEmpty()) {
            val end = if (isInComment) rest.indexOf("*/") else rest.indexOf("/*")
            if (!isInComment) code.append(if (end < 0) rest else rest.take(end))
            if (end < 0) break
            rest = rest.drop(end + 2)
            isInComment = !isInComment
        }
        code.toString().substringBefore("//").isNotBlank()
    }
}
