package robotran.ui.workshop

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import kotlinx.coroutines.channels.Channel
import kotlinx.coroutines.coroutineScope
import kotlinx.coroutines.delay
import kotlinx.coroutines.launch
import robotran.documents.ComingBack
import robotran.documents.Keeping
import robotran.documents.KeepingTimes
import robotran.documents.workName
import robotran.projects.Project
import robotran.ui.platform.Arrival
import robotran.ui.resources.Res
import robotran.ui.resources.documents_back
import robotran.ui.resources.documents_back_others
import robotran.ui.resources.documents_back_unnamed
import robotran.ui.resources.documents_my_work
import robotran.world.BuiltInWorlds

/** Keeps what the project is called and where it lies, and sees to it that nothing of it is lost. */
class DocumentHolder(private val bench: Bench) {
    private val keeper = DocumentKeeper(bench)
    private val files = DocumentFiles(bench, keeper, ::show, ::replaceWork)
    private val exports = DocumentExports(bench, keeper, ::show)
    private val works = DocumentWorks(bench, keeper, { state.dialog }, ::show, ::keepNow, ::replaceWork)
    private val changes = Channel<Unit>(Channel.CONFLATED)
    private var afterLoss: (suspend () -> Unit)? = null

    var state: DocumentState by mutableStateOf(DocumentState(hasShareSheet = bench.platform.sharing.hasShareSheet))
        private set

    fun handle(event: DocumentEvent) {
        when (event) {
            DocumentEvent.NewWanted -> launch { replaceWork { begin() } }
            DocumentEvent.OpenWanted -> launch { files.choose() }
            is DocumentEvent.FilesBrought -> launch { files.open(event.files) }
            is DocumentEvent.LinkOpened -> launch { files.openLink(event.link) }
            is DocumentEvent.OfWorks -> launch { works.handle(event) }
            DocumentEvent.SaveWanted -> launch { files.save() }
            DocumentEvent.SaveAsWanted -> launch { files.saveAs() }
            DocumentEvent.RenameWanted -> show(DocumentDialog.Renaming(keeper.name))
            is DocumentEvent.Renamed -> rename(event.name)
            DocumentEvent.LinkWanted -> launch { exports.makeLink() }
            DocumentEvent.LinkCopied -> launch { exports.copyLink(state.dialog) }
            DocumentEvent.LinkShared -> launch { exports.shareLink(state.dialog) }
            DocumentEvent.LinkPastingWanted -> show(DocumentDialog.PastingLink())
            is DocumentEvent.PictureWanted -> launch { exports.savePicture(event.kind) }
            DocumentEvent.ReplayWanted -> launch { exports.saveReplay() }
            DocumentEvent.ProgramFileWanted -> launch { exports.saveProgram() }
            DocumentEvent.KitWanted -> launch { exports.saveKit() }
            is DocumentEvent.Answered -> launch { answer(event.answer) }
            DocumentEvent.DialogClosed -> closeDialog()
        }
    }

    /** Brings back the work that was open last, unless something was brought to this window. */
    suspend fun start() {
        keeper.beginWith("")
        val arrival = bench.platform.arrivals.takeNow()
        if (arrival != null) return receive(arrival)
        val back = (if (bench.platform.goesOn) keeper.openWorks.takeBack() else null) ?: return
        bench.openProject(back.work.project)
        keeper.tookUp(back.work, back.claim)
        refresh()
        if (back.wasCutShort || back.others > 0) sayBack(back)
    }

    /** Whether nobody has worked on what is open yet. */
    val isFresh: Boolean get() = keeper.openId == null && keeper.isKept

    private fun sayBack(back: ComingBack) {
        val name = back.work.name
        if (back.others > 0) {
            val works = { handle(DocumentEvent.WorksWanted) }
            bench.say(Notice(Res.string.documents_back_others, action = Res.string.documents_my_work, onAction = works))
        } else if (name.isEmpty()) {
            bench.say(Notice(Res.string.documents_back_unnamed))
        } else {
            bench.say(Notice(Res.string.documents_back, listOf(name)))
        }
    }

    /** Keeps the work as it changes and opens what is brought, for ever; to be called once, for as long as the workshop is on a screen. */
    suspend fun keepKeeping() = coroutineScope {
        launch { while (true) receive(bench.platform.arrivals.take()) }
        while (true) {
            do {
                keeper.keepIfDue()?.let(::tell)
                refresh()
                if (!keeper.isKept) delay(KeepingTimes.LOOK)
            } while (!keeper.isKept)
            changes.receive()
        }
    }

    /** Something may have been done to the work. */
    fun lookAgain() {
        changes.trySend(Unit)
    }

    /** Keeps at once what has changed; false if it cannot be kept. */
    suspend fun keepNow(): Boolean {
        val keeping = keeper.keepNow()
        keeping?.let(::tell)
        refresh()
        return keeping == null || keeping == Keeping.Kept
    }

    /**
     * Makes the window ready to be closed.
     *
     * @param onLoss is called if the work cannot be kept and the pupil wants to close nevertheless.
     * @return whether it can be closed now.
     */
    suspend fun close(onLoss: () -> Unit): Boolean {
        if (!keepNow()) {
            afterLoss = { onLoss() }
            show(DocumentDialog.WouldBeLost)
            return false
        }
        keeper.leave(comesBack = true)
        keeper.forget()
        return true
    }

    /** The window is out of sight and may be gone without a word: all is kept, and the next start goes on as if it had been closed. */
    suspend fun rest() {
        if (keepNow()) keeper.leave(comesBack = true)
    }

    /** Gives back what this window has claimed: it is gone. */
    fun release() = keeper.forget()

    private suspend fun receive(arrival: Arrival) {
        when (arrival) {
            is Arrival.OfFiles -> files.open(arrival.files)
            is Arrival.OfLink -> files.openLink(arrival.link)
            is Arrival.Unreadable -> bench.say(Notice(null, plain = arrival.sentence, bad = true))
        }
    }

    /** See [Bench.beginWork]. */
    fun beginWork(name: String, project: Project, into: String?, onBegun: (left: String?, begun: String?) -> Unit) = launch {
        val taken = into?.let { works.claim(it) }
        replaceWork {
            val left = keeper.openId
            if (taken != null) {
                bench.openProject(taken.first.project)
                keeper.tookUp(taken.first, taken.second)
                bench.openProject(project)
            } else {
                bench.openProject(project)
                keeper.opened(name, null)
            }
            show(null)
            keepNow()
            onBegun(left, keeper.openId)
        }
    }

    /** See [Bench.takeUpWork]. */
    fun takeUpWork(id: String?, next: () -> Unit) = launch {
        val taken = id?.let { works.claim(it) }
        replaceWork {
            if (taken == null) {
                begin()
            } else {
                bench.openProject(taken.first.project)
                keeper.tookUp(taken.first, taken.second)
                show(null)
            }
            next()
        }
    }

    /** Does [next], which puts another work in place of the open one, if nothing is lost by it or the pupil does not mind. */
    private suspend fun replaceWork(next: suspend () -> Unit) {
        if (!keepNow()) {
            afterLoss = {
                keeper.leave(comesBack = false)
                next()
                refresh()
            }
            show(DocumentDialog.WouldBeLost)
            return
        }
        keeper.leave(comesBack = false)
        next()
        keepNow()
    }

    private fun begin() {
        bench.openProject(Project(BuiltInWorlds.plain))
        keeper.beginWith("")
        show(null)
    }

    private fun rename(name: String) {
        keeper.name = workName(name).orEmpty()
        show(null)
    }

    private suspend fun answer(answer: DocumentAnswer) {
        val dialog = state.dialog
        val next = afterLoss
        closeDialog()
        when (dialog) {
            is DocumentDialog.ChangedMeanwhile -> files.answer(answer)

            DocumentDialog.WouldBeLost -> when (answer) {
                DocumentAnswer.SAVE_AS -> if (files.saveAs()) next?.invoke()
                else -> next?.invoke()
            }

            else -> Unit
        }
    }

    private fun closeDialog() {
        afterLoss = null
        show(null)
    }

    private fun tell(keeping: Keeping) {
        val trouble = when (keeping) {
            Keeping.Kept -> null
            Keeping.Full -> KeepingTrouble.Full
            Keeping.TooLong -> KeepingTrouble.TooLong
            is Keeping.Failed -> KeepingTrouble.Failed(keeping.reason)
        }
        if (trouble != state.trouble) state = state.copy(trouble = trouble)
    }

    private fun show(dialog: DocumentDialog?) {
        state = state.copy(dialog = dialog)
        refresh()
    }

    private fun refresh() {
        val now = state.copy(name = keeper.name, fileName = keeper.file?.place?.name, saved = keeper.isSaved)
        if (now != state) state = now
    }

    private fun launch(work: suspend () -> Unit) {
        bench.scope.launch {
            work()
            lookAgain()
        }
    }
}
