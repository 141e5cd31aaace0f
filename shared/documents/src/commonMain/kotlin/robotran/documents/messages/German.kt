package robotran.documents.messages

/** The messages in German. */
internal object GermanDocumentMessages : DocumentMessages {
    override fun savedByNewer() = "Es wurde mit einem neueren Robotran aufgehoben."

    override fun copiesBroken() = "Beide Kopien davon sind kaputt."

    override fun defaultProjectName() = "Meine erste Arbeit"

    override fun tutorialProjectName() = "Anleitung"

    override fun decodedFrom(file: String, encoding: String) =
        "$file ist in $encoding statt in UTF-8. Die Datei wurde trotzdem gelesen."

    override fun readAs(file: String, name: String) = "$file wurde als $name gelesen."
}
