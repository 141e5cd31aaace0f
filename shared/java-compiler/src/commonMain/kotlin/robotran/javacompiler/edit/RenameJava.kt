package robotran.javacompiler.edit

import robotran.brick.kind.BrickKind
import robotran.languagesupport.CodeTokenKind
import robotran.languagesupport.CodeTokens
import robotran.languagesupport.TextLines

/** Returns [source] with the name [old] replaced by [new] everywhere except in strings and comments. */
internal fun renamedInJava(source: String, old: String, new: String): String {
    val lines = TextLines(source)
    // On any brick the name of a class counts like any other.
    val tokens = CodeTokens(lines, JavaSyntax, BrickKind.default)
    val result = StringBuilder()
    for (line in 0..<lines.count) {
        if (line > 0) result.append('\n')
        val text = lines.line(line)
        var done = 0
        for (token in tokens.of(line)) {
            val isName = token.kind == CodeTokenKind.NAME || token.kind == CodeTokenKind.BUILT_IN
            if (!isName || text.substring(token.start, token.end) != old) continue
            result.append(text, done, token.start).append(new)
            done = token.end
        }
        result.append(text, done, text.length)
    }
    return result.toString()
}

/** Whether [name] is a valid name for a Java class. */
internal fun isJavaName(name: String): Boolean =
    name.isNotEmpty() && name !in JAVA_KEYWORDS && !name.first().isDigit() &&
        name.all { it.isLetterOrDigit() || it == '_' }
