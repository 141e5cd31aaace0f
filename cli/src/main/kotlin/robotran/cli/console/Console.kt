package robotran.cli.console

import robotran.language.Language

/** Where the command line's words go; tests give one that remembers them. */
interface Console {
    /** What is spoken at it. */
    val language: Language get() = Language.ENGLISH

    /** Says what was asked for. */
    fun say(words: String)

    /** Says what is wrong. */
    fun complain(words: String)

    /** Says how far some work is, just as it stands, with no end of line. */
    fun mention(words: String)
}

/** The console of the process: standard output and standard error. */
object ProcessConsole : Console {
    override fun say(words: String) = println(words)

    override fun complain(words: String) = System.err.println(words)

    override fun mention(words: String) {
        System.err.print(words)
        System.err.flush()
    }
}
