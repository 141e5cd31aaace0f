package robotran.console

import robotran.language.Language
import robotran.language.visibleText

/** The output of the command line. Tests pass one that records it. Texts are for people and go through [visible]. */
interface Console {
    /** The language of the messages. */
    val language: Language get() = Language.ENGLISH

    /** Prints a result. */
    fun say(words: String)

    /** Prints an error. */
    fun complain(words: String)

    /** Prints progress as is, without a line break. */
    fun mention(words: String)
}

/** This console with all text as [visibleText] has it, whatever a program, a file name or a message contains. */
fun Console.visible(): Console = VisibleConsole(this)

private class VisibleConsole(private val console: Console) : Console by console {
    override fun say(words: String) = console.say(visibleText(words))

    override fun complain(words: String) = console.complain(visibleText(words))

    /** A progress bar begins its line anew. */
    override fun mention(words: String) =
        console.mention(words.split('\r').joinToString("\r", transform = ::visibleText))
}

/** Standard output and standard error of the process. */
object ProcessConsole : Console {
    override fun say(words: String) = println(words)

    override fun complain(words: String) = System.err.println(words)

    override fun mention(words: String) {
        System.err.print(words)
        System.err.flush()
    }
}
