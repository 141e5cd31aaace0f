package robotran.documents.messages

/** The messages in English. */
internal object EnglishDocumentMessages : DocumentMessages {
    override fun savedByNewer() = "It was kept by a newer Robotran."

    override fun copiesBroken() = "Both copies of it are broken."

    override fun defaultProjectName() = "My first work"

    override fun tutorialProjectName() = "Tutorial"

    override fun decodedFrom(file: String, encoding: String) =
        "$file is in $encoding, not in UTF-8. It was read all the same."

    override fun readAs(file: String, name: String) = "$file was read as $name."
}
