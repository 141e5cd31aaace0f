package robotran.documents.messages

/** The messages in English. */
internal object EnglishDocumentMessages : DocumentMessages {
    override fun keptByNewer() = "It was kept by a newer Robotran."

    override fun copiesBroken() = "Both copies of it are broken."

    override fun newWorkName() = "My first work"

    override fun tutorialWorkName() = "Tutorial"
}
