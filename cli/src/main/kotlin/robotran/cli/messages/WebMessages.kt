package robotran.cli.messages

/** What is told of serving the built site. */
internal interface WebMessages {
    /** @param folder where it was looked for. */
    fun siteNotBuilt(folder: String): String

    fun siteNotHere(): String

    fun portTaken(port: Int): String

    fun siteServed(address: String): String
}
