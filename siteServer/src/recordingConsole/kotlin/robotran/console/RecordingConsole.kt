package robotran.console

/** A console that records its output. */
internal class RecordingConsole : Console {
    val said = mutableListOf<String>()
    val complaints = mutableListOf<String>()
    val mentions = mutableListOf<String>()

    override fun say(words: String) {
        said += words
    }

    override fun complain(words: String) {
        complaints += words
    }

    override fun mention(words: String) {
        mentions += words
    }
}
