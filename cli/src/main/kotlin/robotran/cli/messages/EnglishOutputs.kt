package robotran.cli.messages

import robotran.language.listed

internal object EnglishOutputMessages : OutputMessages {
    override fun unwritable(name: String, why: String) = "$name could not be written: $why"

    override fun diskFull(name: String) = "$name could not be written: the disk is full. What was there is unchanged."

    override fun notAFileName(name: String) = "$name is not the name of a file."

    override fun isSymbolicLink(name: String, target: String) =
        "$name is a link to $target. To change that file, use its own name."

    override fun isInput(name: String) =
        "$name is read by this command, so nothing is written there. Choose another name for the result."

    override fun writtenTwice(name: String) = "Two results would go to $name. Choose another name for one of them."

    override fun notAPicture(name: String, endings: List<String>) =
        "$name cannot be written: a picture can be ${listed(endings, "or")}."

    override fun unexpected(problem: String) =
        "Something went wrong in Robotran itself. Please tell its developers what you did, and this: $problem"
}
