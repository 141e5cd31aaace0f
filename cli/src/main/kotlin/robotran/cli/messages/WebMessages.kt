package robotran.cli.messages

/** Messages about the built site: serving it, and packing it with assignments. */
internal interface WebMessages {
    /** @param folder the folder that was searched. */
    fun siteNotBuilt(folder: String): String

    fun siteNotHere(): String

    fun portTaken(port: Int): String

    fun siteServed(address: String): String

    /** @param site the beginning of links that lead to this machine. */
    fun linksStayHere(site: String): String

    fun notAnAssignment(name: String): String

    /** @param known the names of all courses. */
    fun noSuchCourse(name: String, known: List<String>): String

    /** A command needs one project, and [name] is a course. */
    fun isCourse(name: String): String
}
