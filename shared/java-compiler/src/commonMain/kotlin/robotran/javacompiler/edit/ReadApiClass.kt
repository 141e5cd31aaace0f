package robotran.javacompiler.edit

/**
 * Reads a class from its source in the library. It relies on the layout of these sources: a member is indented by four
 * spaces and has its comment above it. Members with the tag `@hidden`, which the brick lacks, are left out.
 */
internal fun readApiClass(name: String, path: String, source: String): ApiClass {
    var help = ""
    var parents = emptyList<String>()
    var classHelp = ""
    var isInterface = false
    var isHidden = false
    val members = mutableListOf<ApiMember>()
    val lines = source.lines()
    var index = 0
    while (index < lines.size) {
        val line = lines[index]
        when {
            line.trimStart().startsWith("/**") -> {
                val comment = commentFrom(lines, index)
                help = firstSentence(comment.joinToString(" "))
                isHidden = comment.any { HIDDEN in it }
                index += comment.size - 1
            }

            line.startsWith("public ") && (" class " in line || " interface " in line) -> {
                classHelp = help
                isInterface = " interface " in line
                parents = parentsIn(line)
                help = ""
            }

            isDeclaration(line, isInterface) -> {
                if (!isHidden) memberIn(line.trim(), help, isInterface, name)?.let(members::add)
                help = ""
                isHidden = false
            }
        }
        index++
    }
    return ApiClass(name, path, classHelp, parents, members)
}

private fun commentFrom(lines: List<String>, first: Int): List<String> {
    val last = (first..<lines.size).firstOrNull { "*/" in lines[it] } ?: first
    return lines.subList(first, last + 1)
}

/** The first sentence of a comment, before any tags. */
private fun firstSentence(comment: String): String {
    val text = comment.replace("/**", "").replace("*/", "").split(' ').filter {
        it.isNotEmpty() && it != "*"
    }.joinToString(" ").trim()
    val plain = text.substringBefore(" @").replace("{@code ", "").replace("}", "").removePrefix("@")
    val end = plain.indexOf(". ")
    return if (end < 0) plain else plain.take(end + 1)
}

private fun parentsIn(line: String): List<String> = line.substringBefore('{')
    .split(' ', ',')
    .dropWhile { it != "extends" && it != "implements" }
    .filter { it.isNotEmpty() && it != "extends" && it != "implements" }

private fun isDeclaration(line: String, isInterface: Boolean): Boolean {
    val isMember = line.startsWith("    ") && !line.startsWith("     ")
    return isMember && (line.startsWith("    public ") || (isInterface && line.trimEnd().endsWith(';')))
}

private fun memberIn(declaration: String, help: String, isInterface: Boolean, className: String): ApiMember? {
    val head = declaration.substringBefore('{').substringBefore(" = ").substringBefore('=').trim().trimEnd(';')
    val parameters = if ('(' in head) head.substringAfter('(').substringBeforeLast(')') else null
    val words = head.substringBefore('(').trim().split(' ').filter { it.isNotEmpty() }
    val name = words.last()
    val type = words.dropLast(1).lastOrNull { it !in MODIFIERS } ?: return null
    val isInner = type == "class" || type == "interface" || name == className
    return if (isInner) {
        null
    } else {
        ApiMember(
            name,
            type,
            parameters,
            "static" in words || (isInterface && parameters == null),
            help,
        )
    }
}

private const val HIDDEN = "@hidden"

private val MODIFIERS =
    setOf("public", "static", "final", "abstract", "native", "synchronized", "protected", "transient", "volatile")
