package robotran.workshop.documents

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import kotlinx.coroutines.channels.Channel
import kotlinx.coroutines.coroutineScope
import kotlinx.coroutines.delay
import kotlinx.coroutines.launch
import kotlinx.coroutines.sync.Mutex
import kotlinx.coroutines.sync.withLock
import robotran.documents.Keeping
import robotran.documents.KeepingTimes
import robotran.documents.newWorkName
import robotran.documents.workName
import robotran.projects.Project
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.platform.Arrival
import robotran.workshop.service.Bench
import robotran.workshop.state.DocumentAnswer
import robotran.workshop.state.DocumentDialog
import robotran.workshop.state.DocumentState
import robotran.workshop.state.KeepingTrouble
import robotran.workshop.state.Notice
import robotran.world.World
import robotran.world.file.BuiltInWorlds

/** Keeps what the project is called and where it lies, and sees to it that nothing of it is lost. */
class DocumentHolder(private val bench: Bench) {
    private val keeper = DocumentKeeper(bench)
    private val replacing = Mutex()
    private val files = DocumentFiles(bench, keeper, ::show, ::replaceWork, ::sayKept)
    private val exports = DocumentExports(bench, keeper, ::show)
    private val works = DocumentWorks(bench, keeper, { state.dialog }, ::show, ::keepNow) { next -> replaceWork { next() } }
    private val comeBack = WorkComingBack(bench, keeper)
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
            DocumentEvent.SiteWanted -> chooseSite()
            DocumentEvent.LinkCopied -> launch { exports.copyLink(state.dialog) }
            DocumentEvent.LinkShared -> launch { exports.shareLink(state.dialog) }
            DocumentEvent.LinkPastingWanted -> show(DocumentDialog.PastingLink())
            is DocumentEvent.PictureWanted -> launch { exports.savePicture(event.kind) }
            DocumentEvent.ReplayWanted -> launch { exports.saveReplay() }
            DocumentEvent.ProgramFileWanted -> launch { exports.saveProgram() }
            DocumentEvent.KitWanted -> launch { exports.saveKit() }
            is DocumentEvent.Answered -> launch { answer(event.answer) }
            is DocumentEvent.WarningShown -> state = state.copy(warningShown = event.shown)
            DocumentEvent.DialogClosed -> closeDialog()
        }
    }

    /** Brings back the work that was open last, unless something was brought to this window. */
    suspend fun start() {
        val arrival = bench.platform.arrivals.takeNow()
        val back = comeBack.take(isBroughtSomething = arrival != null)
        if (back == null) {
            keeper.beginWith(keeper.freeName())
        } else {
            bench.openProject(back.work.project)
            keeper.tookUp(back.work, back.claim, bench.project.takeIf { back.isKept })
            if (!back.isKept) keepNow()
            bench.perform(WorkshopEvent.TaskShown(false))
            comeBack.say(back)
        }
        refresh()
        if (arrival != null) receive(arrival)
    }

    /** Whether nobody has worked on what is open yet. */
    val isFresh: Boolean get() = keeper.openId == null && keeper.isKept

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
        keeper.touched()
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
        keeper.leaveUnkept()
        if (keepNow()) keeper.leave(comesBack = true)
    }

    /** Gives back what this window has claimed: it is gone. */
    fun release() = keeper.release()

    private suspend fun receive(arrival: Arrival) {
        when (arrival) {
            is Arrival.OfFiles -> files.open(arrival.files)
            is Arrival.OfLink -> files.openLink(arrival.link)
            is Arrival.Unreadable -> bench.say(Notice.ForeignError(arrival.sentence))
        }
    }

    /** See [Bench.beginWork]. */
    fun beginWork(name: String, project: Project, into: String?, onBegun: (left: String?, begun: String?) -> Unit) = launch {
        val taken = into?.let { works.claim(it) }
        replaceWork {
            val left = keeper.openId
            bench.openProject(project)
            if (taken != null) keeper.tookUp(taken.first, taken.second, taken.first.project) else keeper.opened(name, null)
            show(null)
            keepNow()
            onBegun(left, keeper.openId)
        }
    }

    /** See [Bench.openWorld]. */
    fun openWorld(world: World) = launch {
        replaceWork { before ->
            bench.changeWorld(world, isAnother = true)
            keeper.opened(workName(world.title) ?: newWorkName(bench.language), null, before, isOnlyChosen = true)
            show(null)
            sayKept(before)
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

    /**
     * Does [next], which puts another work in place of the open one, if nothing is lost by it or the pupil does not mind. It is given the id of the
     * work to go back to; null if there is none.
     */
    private suspend fun replaceWork(next: suspend (before: String?) -> Unit) = replacing.withLock {
        if (!keepAll()) {
            afterLoss = {
                keeper.leave(comesBack = false)
                next(null)
                refresh()
            }
            show(DocumentDialog.WouldBeLost)
            return@withLock
        }
        keeper.leave(comesBack = false)
        val id = keeper.openId
        if (id != null && keeper.isOnlyAChosenWorld) {
            val before = keeper.before
            keeper.shelf.delete(id)
            next(before)
        } else {
            next(id)
        }
        keepNow()
    }

    /** Keeps what has changed, also what changes meanwhile; false if it cannot be kept. */
    private suspend fun keepAll(): Boolean {
        while (!keeper.isKept) if (!keepNow()) return false
        return true
    }

    /** Says that the work [before] is kept, and offers the way back to it; nothing if there is none. */
    private fun sayKept(before: String?) {
        if (before != null) bench.say(Notice.EarlierProjectSaved(before))
    }

    private suspend fun begin() {
        val name = keeper.freeName()
        bench.openProject(Project(BuiltInWorlds.plain))
        keeper.beginWith(name)
        // It is there to do what one likes.
        bench.perform(WorkshopEvent.TaskShown(false))
        show(null)
    }

    private fun rename(name: String) {
        show(null)
        launch {
            keeper.name = keeper.freeName(workName(name) ?: newWorkName(bench.language), keeper.openId)
            refresh()
        }
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

    private fun chooseSite() {
        closeDialog()
        bench.perform(SettingsEvent.SiteWanted)
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
        if (trouble != state.trouble) state = state.copy(trouble = trouble, warningShown = true)
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
