package robotran.workshop

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import robotran.workshop.service.Notices
import robotran.workshop.state.Notice
import robotran.workshop.state.NoticeAction

/**
 * Holds the message at the bottom of the screen.
 *
 * @param isVisiting whether a hand-in is replayed.
 * @param canUndo whether an undo that a notice offers is still possible.
 */
internal class NoticeStateHolder(
    private val isVisiting: () -> Boolean,
    private val canUndo: (NoticeAction) -> Boolean,
) : Notices {
    private var latest: Notice? by mutableStateOf(null)

    /** While a hand-in is replayed, there is always the way back; that it is solved is said elsewhere. */
    val shown: Notice?
        get() = latest.takeUnless { it is Notice.WorldSolved && isVisiting() }
            ?: Notice.HandInOpen.takeIf { isVisiting() }

    override fun show(notice: Notice) {
        latest = notice
    }

    override fun add(warnings: List<String>) {
        if (warnings.isNotEmpty()) latest = Notice.WithWarnings(latest, warnings)
    }

    fun dismiss() {
        latest = null
    }

    /** Dismisses the notice if it [isOver]; remarks that were added to it stay. */
    fun dismissIf(isOver: (Notice) -> Boolean) {
        val notice = latest
        if (notice is Notice.WithWarnings) {
            if (notice.notice?.let(isOver) == true) latest = notice.copy(notice = null)
        } else if (notice?.let(isOver) == true) {
            latest = null
        }
    }

    /** The pupil has run or changed the open project, and so goes on with it: the way back to the last one is over. */
    fun projectUsed() = dismissIf { it is Notice.EarlierProjectSaved }

    /** Another project is open: how the last one came to be open, and its files and robots, are no matter any more. */
    fun projectOpened() {
        if (latest is Notice.WithWarnings || latest?.isOfProject == true) latest = null
    }

    /** Dismisses the notice and returns the action that it offers; null if it offers none. */
    fun take(): NoticeAction? = shown?.action.also { latest = null }

    /** Removes an offer to undo what cannot be undone any more. */
    fun withdrawUndo() = dismissIf { notice -> notice.action?.let { !canUndo(it) } ?: false }
}
