package robotran.workshop.documents

import kotlinx.coroutines.channels.Channel
import kotlinx.coroutines.coroutineScope
import kotlinx.coroutines.delay
import kotlinx.coroutines.launch
import robotran.brick.kind.BrickKind
import robotran.brick.kind.BuggyKind
import robotran.documents.AutosaveThrottle
import robotran.documents.ProjectLock
import robotran.documents.RestoredProject
import robotran.documents.SavedProject
import robotran.documents.SavedProjectResult
import robotran.documents.defaultProjectName
import robotran.documents.validProjectName
import robotran.projects.Course
import robotran.projects.Project
import robotran.workshop.event.DocumentEvent
import robotran.workshop.platform.OpenRequest
import robotran.workshop.service.ProgramRoomEvent
import robotran.workshop.service.ProjectSwitcher
import robotran.workshop.service.RoomEvent
import robotran.workshop.service.RunRoomEvent
import robotran.workshop.service.Services
import robotran.workshop.service.StoredAssignments
import robotran.workshop.service.SwitchResult
import robotran.workshop.state.DocumentAnswer
import robotran.workshop.state.DocumentDialog
import robotran.workshop.state.DocumentState
import robotran.workshop.state.Notice
import robotran.workshop.state.WorkToAdd
import robotran.world.ReadyRobots
import robotran.world.World
import robotran.world.file.BuiltInWorlds

/**
 * Holds the name and file of the project and makes sure that nothing is lost.
 *
 * @param isHandledElsewhere offers what arrives to a page that is open. Returns whether the page has taken it.
 */
class DocumentStateHolder(
    private val services: Services,
    openCourses: suspend (List<Course>) -> Unit,
    private val isHandledElsewhere: (OpenRequest) -> Boolean = { false },
) : ProjectSwitcher,
    StoredAssignments {
    private val platform = services.platform
    private val scope = services.scope
    private val preferences = services.preferences
    private val current = services.current
    private val editor = services.editor
    private val navigator = services.navigator
    private val notices = services.notices
    private val guard = OpeningGuard(platform.openingMarks, platform.clock)
    private val autosaver = DocumentAutosaver(platform, preferences, current, editor, guard)
    private val view = DocumentView(autosaver, platform.sharing.hasShareSheet)
    private val saver = FileSaver(platform, current, notices, autosaver, view)
    private val replacement = ProjectReplacement(autosaver, view, saver, notices)
    private val opener =
        FileOpener(services, autosaver, view, replacement, guard, openCourses, openStored = { openStored(it) })
    private val exports = DocumentExports(platform, preferences, current, notices, autosaver, view)
    private val projects = SavedProjectList(platform, preferences, editor, notices, autosaver, view, replacement, guard)
    private val restoration = ProjectRestoration(platform, notices, autosaver, guard)
    private val stopped = StoppedProjects(platform, preferences, notices, autosaver, view, opener, projects)
    private val changes = Channel<Unit>(Channel.CONFLATED)

    val state: DocumentState get() = view.state
    override val openId: String? get() = autosaver.openId

    fun on(event: RoomEvent) {
        when (event) {
            ProgramRoomEvent.CompileBegun, RunRoomEvent.Pressed -> guard.again(autosaver.openId)
            is RunRoomEvent.Changed -> Unit
            else -> projectMayHaveChanged()
        }
    }

    fun handle(event: DocumentEvent) {
        when (event) {
            DocumentEvent.NewRequested -> beginNew(BuiltInWorlds.plain)
            DocumentEvent.RobotChoiceRequested -> view.show(DocumentDialog.RobotChoice())
            is DocumentEvent.BuggyChoiceRequested -> view.show(DocumentDialog.RobotChoice(event.board))
            is DocumentEvent.NewWithBrick -> beginNew(plainWith(event.brick, event.buggy))
            DocumentEvent.OpenRequested -> launch { opener.choose() }
            is DocumentEvent.FilesBrought -> launch { opener.open(event.files) }
            is DocumentEvent.LinkOpened -> launch { opener.openLink(event.link) }
            is DocumentEvent.OfProjectList -> handleProjectList(event)
            DocumentEvent.SaveRequested -> launch { saver.save() }
            DocumentEvent.SaveAsRequested -> launch { saver.saveAs() }
            DocumentEvent.RenameRequested -> view.show(DocumentDialog.Renaming(autosaver.name))
            is DocumentEvent.Renamed -> rename(event.name)
            DocumentEvent.LinkRequested -> launch { exports.makeLink() }
            DocumentEvent.SiteRequested -> chooseSite()
            DocumentEvent.LinkCopied -> launch { exports.copyLink() }
            DocumentEvent.LinkShared -> launch { exports.shareLink() }
            DocumentEvent.LinkPastingRequested -> view.show(DocumentDialog.PastingLink())
            DocumentEvent.ReplayRequested -> launch { exports.saveReplay() }
            DocumentEvent.ProgramFileRequested -> launch { exports.saveProgram() }
            is DocumentEvent.TranslationSaved -> launch { exports.saveTranslation(event.translation) }
            DocumentEvent.KitRequested -> launch { exports.saveKit() }
            is DocumentEvent.AboutRequested -> view.show(DocumentDialog.About(event.version))
            is DocumentEvent.WorkOrFileChosen -> launch { opener.answer(event.isWork) }
            DocumentEvent.StoppedWorkOpened -> launch { stopped.open() }
            DocumentEvent.StoppedWorkSaved -> launch { stopped.save() }
            is DocumentEvent.Answered -> launch { answer(event.answer) }
            is DocumentEvent.WarningShown -> view.showWarning(event.shown)
            DocumentEvent.DialogClosed -> view.answer(null)
        }
    }

    /** Restores the last project, unless files were passed to this window. */
    suspend fun start() = autosaver.repository.readingOnce {
        val arrival = platform.openRequests.takeNow()
        val back = restoration.take(hasIncomingFiles = arrival != null)
        if (back == null) autosaver.startNew(autosaver.unusedName()) else restore(back)
        view.refresh()
        if (!platform.store.isAnswering) view.tellSilence()
        if (platform.showsRecentFiles) view.findRecentFiles()
        restoration.stopped?.let { projects.tellStopped(it) }
        if (arrival != null) receive(arrival)
    }

    private suspend fun restore(back: RestoredProject) {
        editor.openProject(back.work.project)
        autosaver.resume(back.work, back.claim, current.project.takeIf { back.isAutosaved })
        replacement.claimFile()
        if (!back.isAutosaved) saveNow()
        navigator.hideTask()
        restoration.show(back)
    }

    /** Whether something is being opened; and how many were opened before it. */
    internal val opening: Pair<Boolean, Int> get() = guard.isOpening to guard.count

    /** Called when what was opened is compiled and drawn. */
    internal fun openingSettled() = guard.settled()

    /** Whether the open project has not been edited yet. */
    val isFresh: Boolean get() = autosaver.openId == null && autosaver.isAutosaved

    /**
     * Autosaves the project and opens incoming files; never returns. Call it once while the workshop is on the screen.
     */
    suspend fun runAutosave() = coroutineScope {
        launch { while (true) receive(platform.openRequests.take()) }
        while (true) {
            do {
                view.saveIfDue()
                if (!autosaver.isAutosaved) delay(AutosaveThrottle.LOOK)
            } while (!autosaver.isAutosaved)
            changes.receive()
        }
    }

    /** Called when the project may have changed. */
    private fun projectMayHaveChanged() {
        autosaver.touched()
        changes.trySend(Unit)
    }

    /** Autosaves changes at once; false on failure. */
    suspend fun saveNow(): Boolean = view.saveNow()

    /** Prepares the window to close and asks the user if the project cannot be saved. Returns whether it may close. */
    suspend fun close(): Boolean {
        guard.settled()
        if (!saveNow()) return replacement.confirmsLoss()
        autosaver.leave(reopens = true)
        autosaver.forget()
        return true
    }

    /**
     * Called when the window is hidden and may be ended without notice. Autosaves everything, so that the next start
     * continues as after a normal exit.
     */
    suspend fun windowHidden() {
        guard.settled()
        autosaver.leaveUnsavedChanges()
        if (saveNow()) autosaver.leave(reopens = true)
    }

    /** Releases the claims of this window when it closes. */
    fun release() = autosaver.release()

    private suspend fun receive(arrival: OpenRequest): Unit = autosaver.repository.readingOnce {
        if (isHandledElsewhere(arrival)) return@readingOnce
        when (arrival) {
            is OpenRequest.OfFiles -> arrival.files.filterNot { it.isUnread }.ifEmpty { null }?.let { opener.open(it) }
            is OpenRequest.OfLink -> opener.openLink(arrival.link)
            is OpenRequest.Unreadable -> notices.show(Notice.ExternalError(arrival.sentence))
        }
    }

    override suspend fun beginProject(name: String, project: Project, into: String?): SwitchResult {
        val taken = into?.let { projects.claim(it) }
        return switch(taken) { before ->
            val left = before ?: autosaver.openId
            guard.begin(into ?: SWITCHED)
            editor.openProject(project)
            if (taken != null) {
                autosaver.resume(taken.first, taken.second, taken.first.project)
                replacement.claimFile()
            } else {
                autosaver.opened(name, null)
            }
            view.show(null)
            saveNow()
            left
        }
    }

    override suspend fun previewProject(name: String, project: Project): SwitchResult {
        val left = autosaver.openId
        val result = switch { before ->
            guard.begin(SWITCHED)
            editor.openProject(project)
            autosaver.opened(name, null, before, isOnlyChosen = true)
            view.show(null)
            left
        }
        // It is stored by now.
        return if (result is SwitchResult.Switched) result.copy(currentId = autosaver.openId) else result
    }

    override suspend fun returnTo(id: String?, name: String, project: Project): SwitchResult {
        val taken = id?.let { projects.claim(it) }
        return switch(taken) { before ->
            guard.begin(id ?: SWITCHED)
            editor.openProject(taken?.first?.project ?: project)
            if (taken != null) autosaver.resume(taken.first, taken.second) else autosaver.opened(name, null)
            view.show(null)
            before
        }
    }

    override suspend fun openWorld(world: World): SwitchResult = switch { before ->
        guard.begin(SWITCHED)
        editor.changeWorld(world, isAnother = true)
        val name = validProjectName(world.title) ?: defaultProjectName(preferences.language)
        autosaver.opened(name, null, before, isOnlyChosen = true)
        view.show(null)
        replacement.offerPreviousProject(before)
        before
    }

    override suspend fun resumeProject(id: String?, brick: BrickKind): SwitchResult {
        val taken = id?.let { projects.claim(it) }
        return switch(taken) { before ->
            if (taken == null) {
                begin(BuiltInWorlds.plainFor(brick))
            } else {
                guard.begin(taken.first.id)
                editor.openProject(taken.first.project)
                autosaver.resume(taken.first, taken.second)
                replacement.claimFile()
                view.show(null)
            }
            before
        }
    }

    /**
     * Lets [put] open another project, in place of the one with the ID that it gets, and give the ID of the previous one.
     *
     * @param taken what is opened, if it is stored; it is released if the pupil keeps the open project.
     */
    private suspend fun switch(
        taken: Pair<SavedProject, ProjectLock>? = null,
        put: suspend (before: String?) -> String?,
    ): SwitchResult {
        var result: SwitchResult = SwitchResult.Cancelled
        replacement.replace { before -> result = SwitchResult.Switched(put(before), autosaver.openId) }
        if (result == SwitchResult.Cancelled) taken?.second?.release()
        projectMayHaveChanged()
        return result
    }

    override suspend fun worksAt(ids: Set<String>): Map<String, String> = autosaver.repository.readingOnce {
        saveNow()
        val found = mutableMapOf<String, String>()
        for (summary in autosaver.repository.projects()) {
            val id = savedProject(summary.id)?.takeIf {
                it.handIn == null && it.assignment?.checks == null
            }?.assignment?.id
            if (id != null && id in ids) found.getOrPut(id) { summary.id }
        }
        found
    }

    override suspend fun storedProject(id: String): Project? =
        if (id == autosaver.openId) current.project else savedProject(id)

    override suspend fun assignmentsToAdd(): List<WorkToAdd> = autosaver.repository.readingOnce {
        saveNow()
        autosaver.repository.projects().mapNotNull { summary ->
            savedProject(summary.id)?.takeIf { it.assignment != null && it.handIn == null }
                ?.let { WorkToAdd(summary.id, summary.name, it.world.title) }
        }
    }

    override suspend fun openStored(id: String) {
        projects.handle(DocumentEvent.SavedProjectChosen(id))
        projectMayHaveChanged()
    }

    private suspend fun savedProject(id: String): Project? =
        (autosaver.repository.read(id) as? SavedProjectResult.Found)?.work?.project

    private fun handleProjectList(event: DocumentEvent.OfProjectList) {
        if (event is DocumentEvent.SavedProjectChosen) navigator.leavePages()
        launch { projects.handle(event) }
    }

    /** The empty sheet with a robot that has this brick, and this buggy, if any. */
    private fun plainWith(brick: BrickKind, buggy: BuggyKind?): World =
        if (buggy == null) BuiltInWorlds.plainFor(brick) else BuiltInWorlds.plainWith(ReadyRobots.on(buggy, brick))

    private fun beginNew(world: World) {
        launch {
            replacement.replace {
                navigator.leavePages()
                begin(world)
            }
        }
    }

    /** Pages stay: who leaves the tutorial may have opened one before this project is there. */
    private suspend fun begin(world: World) {
        val name = autosaver.unusedName()
        editor.openProject(Project(world))
        autosaver.startNew(name)
        // This project is for free experiments.
        navigator.hideTask()
        view.show(null)
    }

    private fun rename(name: String) {
        view.show(null)
        launch {
            autosaver.name =
                autosaver.uniqueName(
                    validProjectName(name) ?: defaultProjectName(preferences.language),
                    autosaver.openId,
                )
            view.refresh()
        }
    }

    private suspend fun answer(answer: DocumentAnswer) {
        val dialog = view.dialog
        view.answer(answer)
        if (dialog !is DocumentDialog.ChangedElsewhere) return
        when (answer) {
            DocumentAnswer.GO_ON -> saver.save(overOthers = true)
            DocumentAnswer.SAVE_AS -> saver.saveAs()
            DocumentAnswer.TAKE_THEIRS -> opener.reopen()
        }
    }

    private fun chooseSite() {
        view.answer(null)
        navigator.openSiteSetting()
    }

    private fun launch(work: suspend () -> Unit) {
        scope.launch {
            val before = autosaver.openId
            autosaver.repository.readingOnce {
                work()
                if (platform.showsRecentFiles && autosaver.openId != before) view.findRecentFiles()
            }
            projectMayHaveChanged()
        }
    }

    private companion object {
        /** The mark of a project that is not saved yet. */
        const val SWITCHED = "new"
    }
}
