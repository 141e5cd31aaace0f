package robotran.documents.messages

/** The messages in German. */
internal object GermanDocumentMessages : DocumentMessages {
    override fun keptByNewer() = "Es wurde mit einem neueren Robotran aufgehoben."

    override fun copiesBroken() = "Beide Kopien davon sind kaputt."

    override fun newWorkName() = "Meine erste Arbeit"

    override fun tutorialWorkName() = "Anleitung"
}
