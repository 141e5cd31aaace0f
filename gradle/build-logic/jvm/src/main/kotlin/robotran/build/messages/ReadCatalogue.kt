package robotran.build.messages

/**
 * Reads a catalogue file. Its head names the package and the types of parameters, a heading begins a table, a heading
 * below it a message, and a list its sentences, one for each language:
 *
 * ```
 * - package: robotran.world.messages
 * - imports: robotran.world.TouchKind
 *
 * # TouchMessages
 *
 * What is said when something is touched.
 *
 * ## touched(kind: TouchKind, count: Int)
 *
 * - en: {count, plural, one {It touched} other {It touched # times}} {thing(kind)}.
 * - de: ...
 *
 * ## -thing(kind: TouchKind)
 * ```
 *
 * A heading with a dash is a term, for other messages of the table alone. `# internal Name: Base` is an internal table
 * with all messages of another one. `# object Name` has functions that take the language. Text between heading and list documents the table or the message; the list below the
 * heading of a table has notes for translators. A sentence may go on in indented lines.
 *
 * @throws CatalogueException naming [path] and line, if it is not well-formed.
 */
fun readCatalogue(path: String, text: String): MessageCatalogue = CatalogueReader(path, text.lines()).read()

private class CatalogueReader(private val path: String, private val lines: List<String>) {
    private var index = 0

    fun read(): MessageCatalogue {
        val head = items().toMap()
        val packageName = head["package"] ?: fail("the head has no package")
        val imports = head["imports"].orEmpty().split(',').map { it.trim() }.filter { it.isNotEmpty() }
        val tables = mutableListOf<MessageTable>()
        while (index < lines.size) tables += table()
        if (tables.isEmpty()) fail("there is no table")
        return MessageCatalogue(packageName, imports, tables)
    }

    private fun table(): MessageTable {
        val heading = TABLE.matchEntire(lines[index]) ?: fail("this is no heading of a table")
        val (visibility, kind, name, bases) = heading.destructured
        index++
        val documentation = documentation()
        items()
        val messages = mutableListOf<Message>()
        while (index < lines.size && lines[index].startsWith("## ")) messages += message()
        val twice = messages.groupBy { it.signature }.filterValues { it.size > 1 }.keys
        if (twice.isNotEmpty()) fail("$name has these twice: $twice")
        return MessageTable(name, visibility.trim(), kind.isNotEmpty(), names(bases), documentation, messages)
    }

    private fun message(): Message {
        val line = index
        val heading = MESSAGE.matchEntire(lines[index]) ?: fail("this is no heading of a message")
        val (dash, name, parameters) = heading.destructured
        index++
        val documentation = documentation()
        val patterns = items().associate { (tag, text) ->
            tag to try {
                readPattern(text)
            } catch (mistake: CatalogueException) {
                throw CatalogueException("$path:${line + 1}: $tag: ${mistake.message}")
            }
        }
        val isTerm = dash.isNotEmpty()
        if (!isTerm && ENGLISH !in patterns) fail("$name has no sentence in English", line)
        if (patterns.isEmpty()) fail("$name has no sentence", line)
        return Message(name, isTerm, parametersIn(parameters), documentation, patterns)
    }

    private fun parametersIn(text: String): List<Parameter> = PARAMETER.findAll(text).map {
        Parameter(it.groupValues[1], it.groupValues[2].trim())
    }.toList()

    private fun documentation(): String {
        val start = index
        while (index < lines.size && !lines[index].startsWith("#") && !ITEM.matches(lines[index])) index++
        return lines.subList(start, index).joinToString("\n").trim()
    }

    /** The items of a list, with their continued lines joined. */
    private fun items(): List<Pair<String, String>> {
        val items = mutableListOf<Pair<String, String>>()
        while (index < lines.size && !lines[index].startsWith("#")) {
            val line = lines[index]
            val item = ITEM.matchEntire(line)
            when {
                item != null -> items += item.groupValues[1] to item.groupValues[2].trim()
                line.isBlank() -> Unit
                line.startsWith("  ") && items.isNotEmpty() -> {
                    val (tag, text) = items.removeLast()
                    items += tag to "$text ${line.trim()}".trim()
                }
                else -> fail("this is neither a sentence nor goes on with one")
            }
            index++
        }
        return items
    }

    private fun names(text: String) = text.removePrefix(":").split(',').map { it.trim() }.filter { it.isNotEmpty() }

    private fun fail(why: String, line: Int = index): Nothing =
        throw CatalogueException("$path:${minOf(line, lines.size - 1) + 1}: $why")

    private companion object {
        val TABLE = Regex("# (internal )?(object )?(\\w+)(: .*)?")
        val MESSAGE = Regex("## (-?)(\\w+)\\((.*)\\)")
        val PARAMETER = Regex("(\\w+): ((?:[^,<(]|<[^>]*>+|\\([^)]*\\))+)")
        val ITEM = Regex("- (\\w[\\w-]*):(.*)")
    }
}

/** The language in which every message exists. */
const val ENGLISH = "en"
