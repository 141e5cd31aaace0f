package robotran.build.messages

/**
 * The tables of one catalogue file.
 *
 * @property imports the qualified names of the types that parameters have.
 */
class MessageCatalogue(val packageName: String, val imports: List<String>, val tables: List<MessageTable>)

/**
 * The messages of one generated interface or object.
 *
 * @property visibility `internal`, or empty for a public table.
 * @property isObject whether it is an object whose functions take the language, instead of an interface. Callers then
 *   need no table, and code that nobody calls takes no room in the page.
 * @property bases the tables, of this or another catalogue, whose messages this one has, too.
 */
class MessageTable(
    val name: String,
    val visibility: String,
    val isObject: Boolean,
    val bases: List<String>,
    val documentation: String,
    val messages: List<Message>,
)

/**
 * A message in all its languages.
 *
 * @property isTerm whether only other messages of the table use it.
 * @property patterns by the tag of the language.
 */
class Message(
    val name: String,
    val isTerm: Boolean,
    val parameters: List<Parameter>,
    val documentation: String,
    val patterns: Map<String, Pattern>,
) {
    val signature: String get() = parameters.joinToString(prefix = "$name(", postfix = ")") { "${it.name}: ${it.type}" }
}

class Parameter(val name: String, val type: String)

/** A mistake in a catalogue file, for its author. */
class CatalogueException(message: String) : Exception(message)
