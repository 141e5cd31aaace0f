package robotran.workshop

import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import androidx.compose.runtime.snapshotFlow
import androidx.compose.runtime.withFrameNanos
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.flow.collectLatest
import kotlinx.coroutines.withTimeoutOrNull
import robotran.language.Language
import robotran.projects.Project
import robotran.simulation.RecordedInput
import robotran.simulation.RunReport
import robotran.simulation.physics.PhysicsEngine
import robotran.workshop.documents.DocumentStateHolder
import robotran.workshop.event.AssignmentEvent
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RobotEditEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.SchoolEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.event.WorldEvent
import robotran.workshop.platform.MemoryPlatform
import robotran.workshop.platform.Platform
import robotran.workshop.programs.ProgramRoom
import robotran.workshop.run.RunRoom
import robotran.workshop.school.SchoolRoom
import robotran.workshop.screen.ScreenStateHolder
import robotran.workshop.service.RoomEvent
import robotran.workshop.service.RoomEvents
import robotran.workshop.service.Services
import robotran.workshop.settings.SettingsStateHolder
import robotran.workshop.state.DocumentDialog
import robotran.workshop.state.NoticeAction
import robotran.workshop.state.Settings
import robotran.workshop.state.WorkshopState
import robotran.workshop.world.WorldRoom

/**
 * The view model of the app: composes the rooms, hands each [WorkshopEvent] to the room that it is for, and publishes
 * their states as one [WorkshopState]. What a room must tell others are [RoomEvent]s. Not thread-safe.
 *
 * @param project the initial project; it gets the square program if it has none.
 * @param settings the stored settings of this machine.
 */
class Workshop(
    project: Project,
    physics: PhysicsEngine,
    private val platform: Platform = MemoryPlatform(),
    settings: Settings = Settings(),
    scope: CoroutineScope = CoroutineScope(Dispatchers.Unconfined),
) {
    private val events = RoomEvents()
    private val settingsHolder = SettingsStateHolder(platform, scope, settings, events)
    private val screen: ScreenStateHolder =
        ScreenStateHolder(events, { state.hasTask }) { handle(SettingsEvent.SiteRequested) }
    private val notices: NoticeStateHolder =
        NoticeStateHolder({ school.handIns.isVisiting }, ::canUndo) { run.state.outcome }
    private val open: OpenProject = OpenProject(project, events, { programs.programs }, { run.run })

    /** What the rooms share. */
    val services: Services = Services(
        platform = platform,
        scope = scope,
        preferences = settingsHolder,
        current = open,
        editor = open,
        assignments = open,
        navigator = screen,
        notices = notices,
        events = events,
        tabs = { programs },
        runControls = { run },
    )
    private val programs: ProgramRoom = ProgramRoom(project, services, open::roomForPrograms)
    private val run: RunRoom = RunRoom(project, physics, programs.programs, services)
    private val world = WorldRoom(services) { school.assignment.state?.isWorldLocked == true }
    private val document: DocumentStateHolder =
        DocumentStateHolder(services, { school.course.opened(it) }) { school.handIns.takes(it) }
    private val school: SchoolRoom<DocumentStateHolder> =
        SchoolRoom(services, physics, document) { document.state.name.ifEmpty { open.world.title } }

    init {
        // Each follows those before it: the task is shown as the lesson says, an undo is offered if it is still there.
        for (room in listOf(
            programs::on,
            run::on,
            world::on,
            school::on,
            settingsHolder::on,
            screen::on,
            notices::on,
            document::on,
        )) {
            events.subscribe(room)
        }
    }

    /** The current UI state, always the same object. */
    val state: WorkshopState = object : WorkshopState {
        override val programs get() = this@Workshop.programs.state
        override val run get() = this@Workshop.run.state
        override val sheet get() = this@Workshop.world.sheet.state
        override val worldEdit get() = this@Workshop.world.editors.world
        override val robotEdit get() = this@Workshop.world.editors.robot
        override val document by derivedStateOf {
            this@Workshop.document.state.copy(
                hasGoals = run.world.goals.isNotEmpty(),
                canSend = programs.brick.receivesPrograms,
                hasFirmwareImage = programs.program.isForLegoFirmware,
            )
        }
        override val settings get() = settingsHolder.state
        override val learning by derivedStateOf { school.learning.state.copy(isInBlocks = programs.view.hasBlocks) }
        override val pane get() = screen.pane
        override val fullPane get() = screen.fullPane
        override val taskShown get() = screen.taskShown
        override val taskFolded get() = screen.taskFolded
        override val notice get() = notices.shown
        override val settingsShown get() = settingsHolder.shown
        override val siteRequested get() = settingsHolder.siteRequested
        override val send get() = school.send.state
        override val show get() = school.export.state
        override val handIns get() = school.handIns.state
        override val assignment get() = school.assignment.state
        override val handIn get() = school.assignment.handIn
        override val making get() = school.assignment.making
        override val course get() = school.course.state
        override val hasPage get() = platform.pageAddress.isNotEmpty()
    }

    val project: Project get() = open.project

    /** [project] with the inputs of the session and the programs that Run started. It reproduces the session. */
    val replay: Project get() = open.replay

    /** The recorded inputs of the current session. */
    val inputs: List<RecordedInput> get() = open.inputs
    val settings: Settings get() = settingsHolder.settings
    val language: Language get() = settingsHolder.language
    val hasLessMotion: Boolean get() = settingsHolder.hasLessMotion

    /** Whether time runs on the sheet, so that frames are needed. */
    val isAwake: Boolean get() = run.state.awake

    /** Handles a user action. */
    fun handle(event: WorkshopEvent) {
        when (event) {
            is ProgramEvent -> programs.handle(event)
            is RunEvent -> run.handle(event)
            is WorldEvent -> world.handle(event)
            is SchoolEvent -> school.handle(event)
            is DocumentEvent -> document.handle(event)
            is SettingsEvent -> settingsHolder.handle(event)
            is ScreenEvent -> screen.handle(event)
            WorkshopEvent.NoticeDismissed -> notices.dismiss()
            WorkshopEvent.NoticeTaken -> takeNotice()
        }
        notices.withdrawUndo()
        events.publish(RoomEvent.ProjectTouched)
    }

    /**
     * Restores the last project or opens the files passed to this window, and restores the learning progress. Must be
     * called once, before anything is shown. On the first run without a project shows the welcome page if [welcoming].
     */
    suspend fun start(welcoming: Boolean) {
        val isReloaded = platform.window.projectId != null
        school.assignment.start()
        school.course.start()
        document.start()
        if (isReloaded) school.handIns.restore()
        school.learning.start(welcoming && document.isFresh)
    }

    /**
     * Compiles Java programs in the pauses of typing; never returns. Call it once while the workshop is on the screen.
     */
    suspend fun runCompiler() {
        while (true) {
            programs.programs.awaitCompile()
            compilePrograms()
        }
    }

    /**
     * Watches that what was opened is compiled and drawn, so that it may be opened again; never returns. Call it once
     * while the workshop is on the screen, in the scope of its frames.
     */
    suspend fun runOpeningGuard() {
        snapshotFlow { document.opening to mayBeOpened }.collectLatest { (opening, mayBeOpened) ->
            if (!opening.first || !mayBeOpened) return@collectLatest
            // A hidden page draws nothing. It lives, as the pause shows.
            withTimeoutOrNull(UNDRAWN_MILLISECONDS) { repeat(DRAWN_FRAMES) { withFrameNanos { } } }
            document.openingSettled()
        }
    }

    /** The pictures in the list of projects are drawn one after the other, so that list is open as long as it is shown. */
    private val mayBeOpened: Boolean
        get() = programs.state.compileStatus.isOver && document.state.dialog !is DocumentDialog.ProjectList

    /** Autosaves the project on changes; never returns. Call it once while the workshop is on the screen. */
    suspend fun runAutosave() = document.runAutosave()

    /** Autosaves changes at once; false on failure. */
    suspend fun saveDocumentNow(): Boolean {
        saveSettings()
        return document.saveNow()
    }

    /** Autosaves changes at once when the window is hidden, since it may be ended without notice. */
    suspend fun hideDocument() {
        document.windowHidden()
        saveSettings()
    }

    /** Saves changes at once and asks the user if that fails. Returns whether the window may close. */
    suspend fun closeDocument(): Boolean {
        saveSettings()
        return document.close()
    }

    private suspend fun saveSettings() {
        settingsHolder.saveNow()
        school.saveNow()
    }

    /** Compiles all programs that have changed, then runs the actions that waited for the result. */
    suspend fun compilePrograms() {
        run.compile()
        programs.programs.loadHelp()
    }

    /** Called before each frame. [nanoseconds] is monotonic time; virtual time follows it while [isAwake]. */
    fun frame(nanoseconds: Long) = if (school.coversSheet) run.run.standStill() else run.frame(nanoseconds)

    /** Advances virtual time by [milliseconds] at once, without the sounds of the brick. */
    fun advance(milliseconds: Int) = run.advance(milliseconds)

    /** The result of the run so far. */
    fun report(): RunReport = run.report()

    /** Releases the session and the document's claims. No function may be called afterwards. */
    fun close() {
        school.close()
        document.release()
        run.run.close()
    }

    private fun canUndo(action: NoticeAction): Boolean = when (action) {
        NoticeAction.BeginningUndone -> school.assignment.canUndoBeginning
        else -> world.editors.canUndo(action)
    }

    private fun takeNotice() {
        when (val action = notices.take()) {
            NoticeAction.ShowProjects -> document.handle(DocumentEvent.ProjectListRequested)
            is NoticeAction.GoBack -> document.handle(DocumentEvent.SavedProjectChosen(action.project))
            is NoticeAction.GoOn -> document.handle(DocumentEvent.SavedProjectChosen(action.project))
            NoticeAction.ChangeNumber -> programs.editFirstLength()
            NoticeAction.BackToHandIns -> school.handIns.goBack()
            NoticeAction.BeginningUndone -> school.handle(AssignmentEvent.BeginningUndone)
            NoticeAction.UnplugSensors -> world.handle(WorldEditEvent.PlugUndone)
            NoticeAction.BringRobotBack -> world.handle(WorldEditEvent.RobotBroughtBack)
            is NoticeAction.BuildOn -> world.handle(RobotEditEvent.BenchOpened(action.robot))
            null -> Unit
        }
    }

    private companion object {
        /** The second frame begins once the first is drawn. */
        const val DRAWN_FRAMES = 3
        const val UNDRAWN_MILLISECONDS = 3_000L
    }
}
