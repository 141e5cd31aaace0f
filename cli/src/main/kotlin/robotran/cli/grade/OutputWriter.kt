package robotran.cli.grade

import robotran.cli.console.messages
import robotran.cli.files.ON_CONSOLE
import robotran.cli.files.writeFile
import robotran.console.Console
import robotran.language.visibleText

/** Writes results to files or to the console. */
internal class OutputWriter(private val console: Console) {
    /** Returns an error if the file [name] could not be written, null otherwise. */
    fun write(name: String, text: String): String? = if (name == ON_CONSOLE) {
        console.say(text)
        null
    } else {
        write(name, "${visibleText(text)}\n".encodeToByteArray())
    }

    /** The same for [bytes] and a file. */
    fun write(name: String, bytes: ByteArray): String? = writeFile(name, bytes, console.messages)
}
