package robotran.cli.messages

/** Messages about serving the built site. */
internal interface WebMessages {
    /** @param folder the folder that was searched. */
    fun siteNotBuilt(folder: String): String

    fun siteNotHere(): String

    fun portTaken(port: Int): String

    fun siteServed(address: String): String
}
