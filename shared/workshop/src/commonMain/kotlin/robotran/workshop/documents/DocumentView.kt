package robotran.workshop.documents

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import kotlinx.coroutines.CompletableDeferred
import robotran.documents.SaveResult
import robotran.workshop.state.AutosaveError
import robotran.workshop.state.DocumentAnswer
import robotran.workshop.state.DocumentDialog
import robotran.workshop.state.DocumentState
import robotran.workshop.state.RecentFile

/** The document's UI state, and the question that waits for an answer. */
internal class DocumentView(private val autosaver: DocumentAutosaver, hasShareSheet: Boolean) {
    private var question: CompletableDeferred<DocumentAnswer?>? = null

    var state: DocumentState by mutableStateOf(DocumentState(hasShareSheet = hasShareSheet))
        private set

    val dialog: DocumentDialog? get() = state.dialog

    /** Shows [dialog]; null closes it. */
    fun show(dialog: DocumentDialog?) {
        state = state.copy(dialog = dialog)
        refresh()
    }

    fun showWarning(shown: Boolean) {
        state = state.copy(warningShown = shown)
    }

    /**
     * Asks the user about changes that cannot be saved; null if the user returns to the project. Answers an earlier
     * question with null.
     */
    suspend fun askAboutLoss(): DocumentAnswer? {
        answer(null)
        val asked = CompletableDeferred<DocumentAnswer?>()
        question = asked
        show(DocumentDialog.WouldBeLost)
        return asked.await()
    }

    /** Closes the dialog and returns [answer] to the caller that asked; null for none. */
    fun answer(answer: DocumentAnswer?) {
        val asked = question
        question = null
        show(null)
        asked?.complete(answer)
    }

    /** Autosaves changes at once; false on failure. */
    suspend fun saveNow(): Boolean {
        val result = autosaver.saveNow()
        result?.let(::tell)
        refresh()
        return result == null || result == SaveResult.Saved
    }

    /** Autosaves all changes, including those made meanwhile; false on failure. */
    suspend fun saveAll(): Boolean {
        while (!autosaver.isAutosaved) if (!saveNow()) return false
        return true
    }

    /** Autosaves changes if due. */
    suspend fun saveIfDue() {
        autosaver.saveIfDue()?.let(::tell)
        refresh()
    }

    /** Updates the state from the autosaver. */
    fun refresh() {
        val now = state.copy(name = autosaver.name, fileName = autosaver.file?.place?.name, saved = autosaver.isSaved)
        if (now != state) state = now
    }

    /** Finds the files that were used last, each once. */
    suspend fun findRecentFiles() {
        val others = autosaver.repository.projects()
            .filter { it.file != null && it.id != autosaver.openId && it.file?.place != autosaver.file?.place }
            .distinctBy { it.file?.place?.address }
        state = state.copy(recentFiles = others.take(RECENT_FILES).map { RecentFile(it.id, it.fileName.orEmpty()) })
    }

    /** Says at once that nothing can be saved, before there is anything to lose. */
    fun tellSilence() = tell(SaveResult.NoAnswer)

    private fun tell(result: SaveResult) {
        val error = when (result) {
            SaveResult.Saved -> null
            SaveResult.Full -> AutosaveError.Full
            SaveResult.TooLong -> AutosaveError.TooLong
            SaveResult.NoAnswer -> AutosaveError.NoAnswer
            is SaveResult.Failed -> AutosaveError.Failed(result.reason)
        }
        if (error != state.error) state = state.copy(error = error, warningShown = true)
    }

    private companion object {
        const val RECENT_FILES = 8
    }
}
