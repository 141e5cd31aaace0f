package robotran.documents.messages

/** The messages in Spanish. */
internal object SpanishDocumentMessages : DocumentMessages {
    override fun savedByNewer() = "Se guardó con un Robotran más nuevo."

    override fun copiesBroken() = "Sus dos copias están rotas."

    override fun defaultProjectName() = "Mi primer trabajo"

    override fun tutorialProjectName() = "Guía paso a paso"
}
