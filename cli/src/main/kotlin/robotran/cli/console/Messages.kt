package robotran.cli.console

import robotran.cli.messages.CommandMessages
import robotran.console.Console
import robotran.json.JsonWarning

/** The messages in this console's language. */
internal val Console.messages: CommandMessages get() = CommandMessages.of(language)

/** Prints what people should know about the file [name], although it could be read. */
internal fun Console.warn(name: String, notes: List<String>, warnings: List<JsonWarning>) {
    notes.forEach(::complain)
    warnings.forEach { complain(messages.warning("$name: ${it.message}")) }
}
