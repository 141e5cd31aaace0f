package robotran.documents.messages

/** The messages in Spanish. */
internal object SpanishDocumentMessages : DocumentMessages {
    override fun savedByNewer() = "Se guardó con un Robotran más nuevo."

    override fun copiesBroken() = "Sus dos copias están rotas."

    override fun defaultProjectName() = "Mi primer trabajo"

    override fun tutorialProjectName() = "Guía paso a paso"

    override fun decodedFrom(file: String, encoding: String) =
        "$file está en $encoding y no en UTF-8. Se ha leído de todos modos."

    override fun readAs(file: String, name: String) = "$file se ha leído como $name."
}
