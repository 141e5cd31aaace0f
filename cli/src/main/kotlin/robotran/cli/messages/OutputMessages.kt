package robotran.cli.messages

/** Messages about what a command writes. Each `name` is as the user entered it. */
internal interface OutputMessages {
    /** @param why the error message of the operating system. */
    fun unwritable(name: String, why: String): String

    fun diskFull(name: String): String

    fun notAFileName(name: String): String

    /** @param target the file that the symbolic link leads to. */
    fun isSymbolicLink(name: String, target: String): String

    /** The same command reads [name], or what is in it. */
    fun isInput(name: String): String

    fun writtenTwice(name: String): String

    /** @param endings those of the kinds of pictures. */
    fun notAPicture(name: String, endings: List<String>): String

    /** Robotran itself has a mistake; [problem] says which for its developers. */
    fun unexpected(problem: String): String
}
