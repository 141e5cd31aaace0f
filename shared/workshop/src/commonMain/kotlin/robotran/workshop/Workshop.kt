package robotran.workshop

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import androidx.compose.runtime.snapshotFlow
import androidx.compose.runtime.withFrameNanos
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.flow.collectLatest
import kotlinx.coroutines.withTimeoutOrNull
import robotran.documents.SavedBreakpoint
import robotran.language.Language
import robotran.language.source.Diagnostic
import robotran.programs.Program
import robotran.projects.Assignment
import robotran.projects.AssignmentTries
import robotran.projects.Project
import robotran.projects.ProjectSettings
import robotran.projects.repeatable
import robotran.projects.roomForPrograms
import robotran.runcontrol.RecordedRun
import robotran.simulation.RecordedInput
import robotran.simulation.RunReport
import robotran.simulation.physics.PhysicsEngine
import robotran.simulation.state.SessionState
import robotran.workshop.assignment.AssignmentStateHolder
import robotran.workshop.assignment.VariationTarget
import robotran.workshop.course.CourseStateHolder
import robotran.workshop.documents.DocumentStateHolder
import robotran.workshop.event.AssignmentEvent
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.CourseEvent
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.ExportEvent
import robotran.workshop.event.HandInsEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RobotEditEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.SendEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.SheetEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.export.ExportStateHolder
import robotran.workshop.handins.HandInPreviews
import robotran.workshop.handins.HandInsStateHolder
import robotran.workshop.learning.LearningStateHolder
import robotran.workshop.learning.programsLeftBehind
import robotran.workshop.platform.MemoryPlatform
import robotran.workshop.platform.Platform
import robotran.workshop.platform.appLanguage
import robotran.workshop.programs.ProgramsStateHolder
import robotran.workshop.run.RunStateHolder
import robotran.workshop.send.ProgramImageBuilder
import robotran.workshop.send.SendStateHolder
import robotran.workshop.send.TowerRobotLink
import robotran.workshop.service.AssignmentEditor
import robotran.workshop.service.CurrentProject
import robotran.workshop.service.Notices
import robotran.workshop.service.Preferences
import robotran.workshop.service.ProgramTabs
import robotran.workshop.service.ProjectEditor
import robotran.workshop.service.RunControls
import robotran.workshop.service.ScreenNavigator
import robotran.workshop.settings.SettingsStateHolder
import robotran.workshop.sheet.SheetStateHolder
import robotran.workshop.state.DocumentDialog
import robotran.workshop.state.Notice
import robotran.workshop.state.NoticeAction
import robotran.workshop.state.Pane
import robotran.workshop.state.Settings
import robotran.workshop.state.WorkshopState
import robotran.world.RobotDescription
import robotran.world.RobotPlacement
import robotran.world.World

/**
 * The view model of the app. Dispatches [WorkshopEvent]s to the state holders of the panes, advances virtual time, and
 * publishes the result as one [WorkshopState]. Not thread-safe.
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
) : Preferences,
    CurrentProject,
    ProjectEditor,
    AssignmentEditor,
    ProgramTabs,
    RunControls,
    ScreenNavigator,
    Notices {
    private var opened = project
    private var measuredRoom: Pair<Project, Int>? = null
    private var pane by mutableStateOf(Pane.WORLD)
    private var fullPane: Pane? by mutableStateOf(null)
    private var taskShown by mutableStateOf(false)
    private var taskFolded by mutableStateOf(false)
    private val noticeHolder = NoticeStateHolder({ handIns.isVisiting }, ::canUndo)

    private val settingsHolder = SettingsStateHolder(platform.store, scope, settings)
    private val programs: ProgramsStateHolder =
        ProgramsStateHolder(project, platform, this, this, this, ::roomForPrograms)
    private val run: RunStateHolder =
        RunStateHolder(
            project.worldToRun,
            physics,
            programs,
            this,
            this,
            this,
            platform,
            scope,
            this,
            this,
            project.inputs,
            filesChanged = { document.projectMayHaveChanged() },
        ).also { it.setSound(settings.soundOn) }
    private val sheet = SheetStateHolder(this)
    private val editors: WorldEditors = WorldEditors(
        platform,
        scope,
        this,
        this,
        noticeHolder,
        VariationTarget(this, this, this),
        isLocked = { assignment.state?.isWorldLocked == true },
        onOpening = ::closePage,
        onClosed = { assignment.worldEditorClosed(it) },
    )
    private val assignment: AssignmentStateHolder =
        AssignmentStateHolder(platform, scope, physics, this, this, this, this, this, this) { editors.open(it) }
    private val document: DocumentStateHolder =
        DocumentStateHolder(platform, scope, this, this, this, this, this, this, { course.opened(it) }, ::putRobot) {
            handIns.takes(it)
        }
    private val course: CourseStateHolder =
        CourseStateHolder(platform, scope, this, this, document, document, this) { handIns.openCourse(it) }
    private val learning =
        LearningStateHolder(platform.store, scope, this, this, this, document, this, this, this, this)
    private val send =
        SendStateHolder(platform, scope, this, this, ProgramImageBuilder(platform, this, this), ::TowerRobotLink)
    private val show = ExportStateHolder(platform, scope, this, this, this) {
        document.state.name.ifEmpty { this.project.world.title }
    }
    private val handIns: HandInsStateHolder =
        HandInsStateHolder(platform, scope, this, this, physics, HandInPreviews(document, this, this)) {
            document.state.name.ifEmpty { this.project.world.title }
        }

    /** The current UI state, observable by Compose. */
    val state: WorkshopState
        get() = WorkshopState(
            programs = programs.state,
            run = run.state,
            sheet = sheet.state,
            worldEdit = editors.world,
            document = document.state.copy(
                hasGoals = run.state.world.goals.isNotEmpty(),
                canSend = programs.state.brick.receivesPrograms,
                hasFirmwareImage = programs.state.program.isForLegoFirmware,
            ),
            settings = settingsHolder.state,
            learning = learning.state.copy(isInBlocks = programs.state.view.hasBlocks),
            pane = pane,
            taskShown = taskShown,
            notice = noticeHolder.shown,
            settingsShown = settingsHolder.shown,
            siteRequested = settingsHolder.siteRequested,
            send = send.state,
            show = show.state,
            handIns = handIns.state,
            assignment = assignment.state,
            handIn = assignment.handIn,
            making = assignment.making,
            course = course.state,
            hasPage = platform.pageAddress.isNotEmpty(),
            fullPane = fullPane,
            robotEdit = editors.robot,
            taskFolded = taskFolded,
        )

    override val project: Project get() = opened.copy(
        robots = programs.projectRobots(opened.world),
        inputs = emptyList(),
    )
    override val savedBreakpoints: List<SavedBreakpoint> get() = programs.savedBreakpoints
    override val shownProgram: Program get() = programs.state.program
    override val shownRobot: RobotPlacement get() = programs.state.robot

    /** The recorded inputs of the current session. */
    val inputs: List<RecordedInput> get() = run.inputs
    override val replay: Project
        get() {
            val first = opened.world.robots.map { it.name }.zip(run.startedPrograms).toMap()
            val now = project
            val files = run.filesAtStart
            val robots = now.robots.map {
                it.copy(firstProgram = first[it.name] ?: 0, files = files[it.name].orEmpty())
            }
            return now.copy(robots = robots, inputs = inputs.repeatable())
        }
    override val session: SessionState get() = run.state.session
    override val settings: Settings get() = settingsHolder.state
    override val language: Language get() = appLanguage(settings.language)

    /** Whether animations are reduced: as the pupil has chosen, before that as the system is told. */
    val hasLessMotion: Boolean get() = settings.lessMotion ?: platform.prefersLessMotion

    override fun change(settings: Settings) = handle(SettingsEvent.SettingsChanged(settings))

    /** Handles a user action. */
    fun handle(event: WorkshopEvent) {
        // Only these: a project that is opened has another world and other programs, and offers the way back.
        val isEdit = event is ProgramEvent || event is WorldEditEvent || event is RobotEditEvent
        val before = if (isEdit) opened.world to programs.written else null
        dispatch(event)
        if (before != null && before != opened.world to programs.written) noticeHolder.projectUsed()
        document.projectMayHaveChanged()
    }

    private fun dispatch(event: WorkshopEvent) {
        when (event) {
            is ProgramEvent -> handleProgram(event)
            is RunEvent -> handleRun(event)
            is SheetEvent -> sheet.handle(event)
            is WorldEditEvent -> editors.handle(event)
            is RobotEditEvent -> editors.handle(event)
            is DocumentEvent -> document.handle(event)
            is SettingsEvent -> handleSettings(event)
            is LearningEvent -> learning.handle(event)
            is SendEvent -> send.handle(event)
            is ExportEvent -> show.handle(event)
            is HandInsEvent -> handIns.handle(event)
            is AssignmentEvent -> assignment.handle(event)
            is CourseEvent -> course.handle(event)
            is WorkshopEvent.PaneChosen -> pane = event.pane
            is WorkshopEvent.PaneFilled -> fullPane = event.pane
            is WorkshopEvent.TaskShown -> showTask(event.shown)
            is WorkshopEvent.TaskFolded -> taskFolded = event.folded
            WorkshopEvent.NoticeDismissed -> noticeHolder.dismiss()
            WorkshopEvent.NoticeTaken -> takeNotice()
        }
    }

    /**
     * Restores the last project or opens the files passed to this window, and restores the learning progress. Must be
     * called once, before anything is shown. On the first run without a project shows the welcome page if [welcoming].
     */
    suspend fun start(welcoming: Boolean) {
        val isReloaded = platform.window.projectId != null
        assignment.start()
        course.start()
        document.start()
        if (isReloaded) handIns.restore()
        learning.start(welcoming && document.isFresh)
    }

    /**
     * Compiles Java programs in the pauses of typing; never returns. Call it once while the workshop is on the screen.
     */
    suspend fun runCompiler() {
        while (true) {
            programs.awaitCompile()
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
        learning.saveNow()
        handIns.saveNow()
        assignment.saveNow()
        course.saveNow()
    }

    /** Compiles all programs that have changed, then runs the actions that waited for the result. */
    suspend fun compilePrograms() {
        compile()
        programs.loadHelp()
    }

    private suspend fun compile() {
        document.markOpenProject()
        run.programsCompiled(programs.compile())
        runChanged()
    }

    /**
     * Called before each frame. [nanoseconds] is monotonic time; virtual time follows it while [WorkshopState.awake].
     */
    fun frame(nanoseconds: Long) {
        if (show.state != null || handIns.state != null) return run.standStill()
        run.frame(nanoseconds)
        if (runChanged()) celebrate()
    }

    /** Advances virtual time by [milliseconds] at once, without the sounds of the brick. */
    fun advance(milliseconds: Int) {
        run.advance(milliseconds)
        if (runChanged()) celebrate()
    }

    private fun celebrate() {
        if (!hasLessMotion) run.celebrate()
    }

    /** Returns whether the task has just been solved. */
    private fun runChanged(): Boolean {
        assignment.runChanged(run.endedTry)
        withdrawPraise()
        return learning.runChanged(run.state.session, run.state.outcome, shownProgram)
    }

    /** That all goals are met is said only of the present run in the present world. */
    private fun withdrawPraise() {
        if (!run.state.outcome.allMet) noticeHolder.dismissIf { it is Notice.WorldSolved }
    }

    /** The result of the run so far. */
    fun report(): RunReport = run.report()

    /** Releases the session and the document's claims. No function may be called afterwards. */
    fun close() {
        send.close()
        show.close()
        handIns.close()
        assignment.close()
        document.release()
        run.close()
    }

    override fun openProject(project: Project) {
        noticeHolder.projectOpened()
        learning.leaveProject()
        editors.leave()
        opened = project
        programs.open(project)
        run.changeWorld(project.worldToRun, project.inputs)
        assignment.projectChanged()
        course.projectChanged()
        worldChanged(isAnother = true)
    }

    override fun restoreBreakpoints(breakpoints: List<SavedBreakpoint>) {
        programs.restoreBreakpoints(breakpoints)
        run.programsChanged()
    }

    override fun changeWorld(world: World, isAnother: Boolean) {
        if (isAnother) noticeHolder.projectOpened()
        learning.leaveProject()
        if (isAnother) editors.leave()
        val before = run.state.world
        // An assignment belongs to its world.
        opened = if (isAnother) Project(world, opened.robots, opened.settings) else opened.copy(world = world)
        if (isAnother) {
            assignment.projectChanged()
            course.projectChanged()
        }
        programs.worldChanged(world)
        if (isAnother) programs.removePrograms(programsLeftBehind(world))
        run.changeWorld(opened.worldToRun)
        worldChanged(isAnother || before.title != world.title || before.task != world.task)
    }

    override fun saveWorld(world: World) {
        learning.leaveProject()
        val before = opened.world.robots
        opened = opened.copy(world = world)
        // A robot with a new name would lose its programs.
        val isRenamed = before.size == world.robots.size && before.first().name != world.robots.first().name
        if (isRenamed) programs.worldChanged(world)
        noticeHolder.withdrawUndo()
        document.projectMayHaveChanged()
    }

    override fun changeAssignment(assignment: Assignment?) {
        opened = opened.copy(assignment = assignment)
        course.triesChanged()
        document.projectMayHaveChanged()
    }

    override fun saveTries(tries: AssignmentTries?) {
        opened = opened.copy(tries = tries)
        course.triesChanged()
        document.projectMayHaveChanged()
    }

    override fun changeProjectSettings(settings: ProjectSettings) {
        opened = opened.copy(settings = settings)
        programs.runJava(settings.java)
        run.changeWorld(opened.worldToRun)
        document.projectMayHaveChanged()
    }

    override fun addProgram(program: Program, replacing: Boolean) {
        val index = programs.state.programs.indexOfFirst { it.name == program.name }
        if (!replacing || index < 0 || program.files.size > 1) {
            handleProgram(ProgramEvent.ProgramAdded(program))
        } else {
            handleProgram(ProgramEvent.ProgramChosen(index))
            handleProgram(ProgramEvent.ProgramEdited(program.files.single().text))
        }
        document.projectMayHaveChanged()
    }

    override fun chooseProgram(index: Int) = handle(ProgramEvent.ProgramChosen(index))

    override fun removeProgram(index: Int) {
        handle(ProgramEvent.ProgramClosed(index))
        handle(ProgramEvent.ClosedMessageDismissed)
    }

    override fun removePrograms(isMeant: (Program) -> Boolean) {
        programs.removePrograms(isMeant)
        run.programsChanged()
        learning.programsChanged()
        assignment.programsChanged()
    }

    override fun replacePrograms(programs: List<Program>) {
        this.programs.replacePrograms(programs)
        run.programsChanged()
        learning.programsChanged()
        assignment.programsChanged()
    }

    override fun showLine(index: Int, line: Int) {
        programs.showLine(index, line)
        learning.programsChanged()
    }

    override fun showDiagnostic(diagnostic: Diagnostic) = programs.showDiagnostic(diagnostic)

    override fun run() = handle(RunEvent.RunPressed)

    override fun startOver() = handle(RunEvent.StartedOver)

    override suspend fun playInputs() {
        compile()
        handle(RunEvent.RecordingPlayed)
    }

    override fun recordedRun(): RecordedRun = run.recorded()

    override fun hideTask() = handle(WorkshopEvent.TaskShown(false))

    override fun leavePages() {
        if (learning.state.page != null) handle(LearningEvent.PageClosed)
        if (settingsHolder.shown) handle(SettingsEvent.SettingsShown(false))
    }

    override fun openSiteSetting() = handle(SettingsEvent.SiteRequested)

    override fun show(notice: Notice) = noticeHolder.show(notice)

    override fun add(warnings: List<String>) = noticeHolder.add(warnings)

    override fun show(pane: Pane) {
        this.pane = pane
        if (fullPane != pane) fullPane = null
    }

    /** Measures the rest of the project only once. */
    private fun roomForPrograms(): Int {
        val known = measuredRoom?.takeIf { it.first === opened } ?: (opened to roomForPrograms(opened))
        measuredRoom = known
        return known.second
    }

    /** Called after the world has changed; [isAnother] is whether it is a different one or has a new title or task. */
    private fun worldChanged(isAnother: Boolean) {
        learning.projectChanged()
        if (isAnother) showTask(state.hasTask)
        if (taskShown) show(Pane.WORLD)
        sheet.worldChanged()
        withdrawPraise()
        noticeHolder.withdrawUndo()
        document.projectMayHaveChanged()
    }

    private fun canUndo(action: NoticeAction): Boolean = when (action) {
        NoticeAction.BeginningUndone -> assignment.canUndoBeginning
        else -> editors.canUndo(action)
    }

    /** Help would cover the palette of the world editor. */
    private fun closePage() {
        if (learning.state.page != null) learning.handle(LearningEvent.PageClosed)
    }

    private fun putRobot(robot: RobotDescription) {
        if (editors.putRobot(robot, shownRobot)) show(Pane.WORLD)
    }

    /** The whole task; who asks for it wants to read it. */
    private fun showTask(shown: Boolean) {
        taskShown = shown
        taskFolded = false
    }

    /** On Run, hides the task and the notice that asks for it, so that the whole sheet is visible. */
    private fun handleRun(event: RunEvent) {
        val wasRunning = run.state.running
        if (event == RunEvent.RunPressed) document.markOpenProject()
        if (event == RunEvent.RunPressed) noticeHolder.dismissIf { it is Notice.SensorsPluggedIn }
        run.handle(event)
        val isStarted = event == RunEvent.RunPressed || (!wasRunning && isStartButton(event))
        if (isStarted) showTask(false)
        if (isStarted || (!wasRunning && run.state.running)) noticeHolder.projectUsed()
        // A new run takes the praise of the last one away.
        if (runChanged()) celebrate()
        if (event is RunEvent.ShortfallShown) {
            event.shortfall.place?.let { sheet.handle(SheetEvent.PlaceRequested(it)) }
        }
    }

    private fun isStartButton(event: RunEvent): Boolean =
        event is RunEvent.ButtonPressed && event.button == run.state.brick.kind.startButton && run.state.brick.poweredOn

    private fun handleProgram(event: ProgramEvent) {
        val before = programs.written
        programs.handle(event)
        if (event is BlockEvent.ViewChosen) {
            settingsHolder.handle(SettingsEvent.SettingsChanged(settings.copy(programView = event.view)))
        }
        if (event is BlockEvent.SnippetRequested) {
            programs.snippet(event.load)?.let {
                run.runSnippet(it)
                noticeHolder.projectUsed()
                showTask(false)
            }
        }
        // Selections and caret movements do not affect the run.
        val isWritten = programs.written != before
        if (isWritten) noticeHolder.dismissIf { it == Notice.FirstProgramRuns }
        val isForRun = event is ProgramEvent.BreakpointToggled || event is ProgramEvent.RobotChosen
        if (isWritten || isForRun) run.programsChanged()
        if (isWritten || event is ProgramEvent.ProgramChosen) learning.programsChanged()
        if (isWritten) assignment.programsChanged()
        noticeHolder.withdrawUndo()
    }

    private fun handleSettings(event: SettingsEvent) {
        val before = language
        settingsHolder.handle(event)
        run.setSound(settingsHolder.state.soundOn)
        if (language == before) return
        programs.setLanguage(language)
        run.programsCompiled(programs.state.compileStatus)
        run.setLanguage(language)
        learning.refresh()
    }

    private fun takeNotice() {
        when (val action = noticeHolder.take()) {
            NoticeAction.ShowProjects -> document.handle(DocumentEvent.ProjectListRequested)
            is NoticeAction.GoBack -> document.handle(DocumentEvent.SavedProjectChosen(action.project))
            is NoticeAction.GoOn -> document.handle(DocumentEvent.SavedProjectChosen(action.project))
            NoticeAction.ChangeNumber -> editFirstLength()
            NoticeAction.BackToHandIns -> handIns.goBack()
            NoticeAction.BeginningUndone -> assignment.handle(AssignmentEvent.BeginningUndone)
            NoticeAction.UnplugSensors -> editors.handle(WorldEditEvent.PlugUndone)
            NoticeAction.BringRobotBack -> editors.handle(WorldEditEvent.RobotBroughtBack)
            is NoticeAction.BuildOn -> editors.handle(RobotEditEvent.BenchOpened(action.robot))
            null -> Unit
        }
    }

    private fun editFirstLength() {
        show(Pane.PROGRAM)
        programs.editFirstLength()
    }

    private companion object {
        /** The second frame begins once the first is drawn. */
        const val DRAWN_FRAMES = 3
        const val UNDRAWN_MILLISECONDS = 3_000L
    }
}
