package robotran.documents

import robotran.language.Language

/** The error messages for saved projects that cannot be opened, in whole sentences. */
interface DocumentMessages {
    fun keptByNewer(): String

    /** The store holds two copies of each project. */
    fun copiesBroken(): String

    companion object {
        fun of(language: Language): DocumentMessages = when (language) {
            Language.ENGLISH -> EnglishDocumentMessages
            Language.SPANISH -> SpanishDocumentMessages
            Language.GERMAN -> GermanDocumentMessages
        }
    }
}

private object EnglishDocumentMessages : DocumentMessages {
    override fun keptByNewer() = "It was kept by a newer Robotran."

    override fun copiesBroken() = "Both copies of it are broken."
}

private object SpanishDocumentMessages : DocumentMessages {
    override fun keptByNewer() = "Se guardó con un Robotran más nuevo."

    override fun copiesBroken() = "Sus dos copias están rotas."
}

private object GermanDocumentMessages : DocumentMessages {
    override fun keptByNewer() = "Es wurde mit einem neueren Robotran aufgehoben."

    override fun copiesBroken() = "Beide Kopien davon sind kaputt."
}
