package robotran.desktop.cli

/** A console that keeps what it was told. */
internal class RememberingConsole : Console {
    val said = mutableListOf<String>()
    val complaints = mutableListOf<String>()

    override fun say(words: String) {
        said += words
    }

    override fun complain(words: String) {
        complaints += words
    }
}
