package robotran.workshop.learning

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import kotlinx.coroutines.launch
import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.learning.GalleryWorld
import robotran.learning.Lesson
import robotran.learning.LessonPlace
import robotran.learning.Lessons
import robotran.learning.WorldGallery
import robotran.programs.Program
import robotran.runcontrol.RunOutcome
import robotran.simulation.state.GoalProgress
import robotran.simulation.state.GoalStatus
import robotran.simulation.state.SessionState
import robotran.workshop.event.LearningEvent
import robotran.workshop.examples.firstProgram
import robotran.workshop.examples.isFirst
import robotran.workshop.service.ProgramRoomEvent
import robotran.workshop.service.ProjectRoomEvent
import robotran.workshop.service.ProjectSwitcher
import robotran.workshop.service.RoomEvent
import robotran.workshop.service.RunRoomEvent
import robotran.workshop.service.SchoolRoomEvent
import robotran.workshop.service.Services
import robotran.workshop.service.WindowRoomEvent
import robotran.workshop.service.WorldRoomEvent
import robotran.workshop.service.pupilPrograms
import robotran.workshop.state.EndedAttempt
import robotran.workshop.state.HelpState
import robotran.workshop.state.LearningPage
import robotran.workshop.state.LearningState
import robotran.workshop.state.Notice
import robotran.workshop.state.Pane
import robotran.workshop.state.SolvedTask
import robotran.workshop.state.TaskHelp
import robotran.workshop.state.TutorialState
import robotran.workshop.state.WorldTaskState

/** Holds the state of the learning pages and the learning progress. */
class LearningStateHolder(private val services: Services, private val switcher: ProjectSwitcher) {
    private val scope = services.scope
    private val preferences = services.preferences
    private val current = services.current
    private val tabs = services.tabs
    private val runControls = services.runControls
    private val navigator = services.navigator
    private val notices = services.notices
    private val store = LearningProgressStore(services.platform.store, scope)
    private val progress: LearningProgress get() = store.progress
    private val drawings = PupilDrawings(services.platform.store, scope)
    private var hasStarted = false

    /** Whether the tutorial was folded because another project was loaded. */
    private var isFoldedAutomatically = false
    private var goalsSeen: List<GoalProgress> = emptyList()
    private var isTryOver = false
    private val tutorial = TutorialController(scope, preferences, current, services.editor, switcher, navigator, store)
    private val hints = HintGiver(preferences)
    private val newTabs = NewTabs(current, tabs, navigator, notices)
    private val help = HelpFinder(preferences, current, newTabs)
    private val worldTask = WorldTaskController(preferences, current, newTabs, runControls, hints)

    private val places = LessonPlaces(tutorial, current)

    /** Whether it was the solution that began the present run, which solves nothing. */
    private var isSolutionRun = false

    var state: LearningState by mutableStateOf(BEFORE_START)
        private set

    /** Restores the learning progress; on the first run shows the welcome page if [welcoming]. */
    suspend fun start(welcoming: Boolean) {
        store.load()
        drawings.load()
        state = state.copy(
            page = LearningPage.FIRST_RUN.takeIf { welcoming && !progress.welcomed },
            tutorial =
                tutorial.loadedStep()?.let(tutorial::show) ?: if (progress.tutorialShown) tutorial.first() else null,
        )
        hasStarted = true
        refresh()
        // The loaded world has its own task.
        state = state.copy(tutorial = state.tutorial?.let { it.copy(isFolded = progress.folded || !it.isLoaded) })
    }

    fun on(event: RoomEvent) {
        when (event) {
            is ProjectRoomEvent.Leaving -> leaveProject()
            is ProjectRoomEvent.Opened, is ProjectRoomEvent.WorldChanged -> projectChanged()
            is ProgramRoomEvent.Written, ProgramRoomEvent.Chosen -> programsChanged()
            is RunRoomEvent.Changed -> runChanged(event, current.shownProgram)
            is WindowRoomEvent.LanguageChanged -> refresh()
            WorldRoomEvent.EditorOpening, WindowRoomEvent.PagesLeft -> {
                if (state.page != null) handle(LearningEvent.PageClosed)
            }

            is ProjectRoomEvent.WorldSaved, is ProjectRoomEvent.RunSettingsChanged, ProjectRoomEvent.AssignmentChanged,
            ProjectRoomEvent.Touched, ProgramRoomEvent.DebuggingChanged, ProgramRoomEvent.CompileBegun,
            is ProgramRoomEvent.Compiled, is ProgramRoomEvent.SnippetRequested, RunRoomEvent.Pressed,
            is RunRoomEvent.Started, is RunRoomEvent.PointShown, is RunRoomEvent.Told, WorldRoomEvent.Edited,
            is WorldRoomEvent.EditorRequested, is WorldRoomEvent.EditorClosed, is WorldRoomEvent.RobotOpened,
            is WindowRoomEvent.SettingsChanged, is SchoolRoomEvent,
            -> Unit
        }
    }

    fun handle(event: LearningEvent) {
        when (event) {
            is LearningEvent.PageRequested -> openPage(event.page)
            LearningEvent.PageClosed -> leavePage()
            LearningEvent.FirstProgramTried -> trySquare()
            LearningEvent.TutorialStarted -> beginTutorial()
            is LearningEvent.StepChosen -> changeTutorial { tutorial.choose(it, event.index) }
            LearningEvent.StepTried -> changeTutorial { tutorial.loadStep(it) }
            LearningEvent.StepRestarted -> changeTutorial { tutorial.beginAgain(it) }
            LearningEvent.OtherPlaceTried -> tryElsewhere()
            is LearningEvent.LessonChosen -> openLesson(event.index)
            is LearningEvent.HintRequested -> nextHint(event.shown)
            is LearningEvent.SolutionRequested -> showSolution(event.shown)
            is LearningEvent.TutorialFolded -> fold(event.folded)
            LearningEvent.TutorialClosed -> leaveTutorial()
            is LearningEvent.WorldSearchChanged -> state = state.copy(query = event.query)
            is LearningEvent.WorldChosen -> chooseWorld(event.name)
            LearningEvent.WorldProgramRequested -> putWorldProgram()
            is LearningEvent.WorldHintRequested -> changeWorldTask { worldTask.nextHint(it, event.shown) }
            is LearningEvent.WorldSolutionRequested -> showWorldSolution(event.shown)
            is LearningEvent.ExampleChosen -> if (help.addExample(event.language, event.name, event.brick)) leavePage()
            is LearningEvent.HelpRequested -> showHelp(help.at(event.text, event.offset))
            is LearningEvent.WordChosen -> showHelp(help.on(state.help.programLanguage, event.word, state.help.brick))
            is LearningEvent.WordsRequested -> showHelp(help.on(event.language, null))
            LearningEvent.ExampleTried -> if (help.tryExample(state.help)) leavePage()
        }
        refresh()
    }

    /**
     * Called with each new state of the run. The task is completed once all goals are met, and solved once the run is
     * over.
     */
    private fun runChanged(run: RunRoomEvent.Changed, program: Program) {
        val session = run.session
        val outcome = run.outcome
        if (outcome.finished == null && session.milliseconds < START_MILLISECONDS) isSolutionRun = isSolutionShown
        goalsChanged(session)
        tryChanged(session, outcome, program, run.ended)
        if (!outcome.isSolved) {
            if (state.isReached) state = state.copy(solved = null, elsewhere = null)
        } else if (!state.isReached && !isSolutionRun) {
            reached(PassedRun(outcome.finished ?: 0, session), program, run.ended)
        }
    }

    /** The goals are reached at the end of [run]. In a lesson with two places this counts once it is so in both. */
    private fun reached(run: PassedRun, program: Program, ended: EndedAttempt?) {
        val step = tutorial.loadedStep()
        if (step == null || !places.areTwo(step)) return showSolved(step, run, program)
        // A replay is no try of a program.
        val tried = ended?.takeIf { it.result.isSolved }?.program ?: return
        val runs = places.pass(step, tried, run)
        val other = step.places.firstOrNull { it !in runs }
        if (other == null) {
            stepDone(step)
            showSolved(step, runs.getValue(LessonPlace.FIRST), tried)
        } else {
            changeHelp { _, help -> hints.none(help) }
            state = state.copy(elsewhere = other)
            refresh()
        }
    }

    private fun showSolved(step: Lesson?, run: PassedRun, program: Program) {
        state = state.copy(solved = solve(step, run, program))
        refresh()
        services.publish(SchoolRoomEvent.TaskSolved)
    }

    /** Whether the program in the editor is the solution that the app shows. */
    private val isSolutionShown: Boolean
        get() = (state.worldTask?.help ?: state.tutorial?.help)?.solutionShown == true

    private fun solve(step: Lesson?, run: PassedRun, program: Program): SolvedTask {
        val world = worldTask.loadedWorld()
        val name = step?.name ?: world?.let { "world/${it.name}" }
        val record = TaskRecord(run.milliseconds, linesOf(program))
        val before = progress.records[name]
        if (name != null) store.update { it.copy(records = it.records + (name to (before?.with(record) ?: record))) }
        if (step != null) drawings.keep(step.name, run.drawing)
        val index = step?.let(Lessons::indexOf)
        return SolvedTask(
            learned = step?.text(preferences.language, words = preferences.words)?.skill,
            milliseconds = run.milliseconds,
            lines = record.lines,
            bestMilliseconds = before?.milliseconds,
            bestLines = before?.lines,
            nextStep = index?.let { it + 1 }?.takeIf { it in Lessons.all.indices },
            harder = world?.let { WorldGallery.harderThan(it) }.orEmpty().filter { it.name !in progress.worldsDone },
        )
    }

    /**
     * A goal that is met stays met, whatever the run goes on to do, so the task is done at this moment. A lesson with two
     * places waits for the end of the run, see [reached].
     */
    private fun goalsChanged(session: SessionState) {
        if (session.goals == goalsSeen) return
        goalsSeen = session.goals
        if (goalsSeen.isEmpty() || goalsSeen.any { it.status != GoalStatus.MET }) return
        val step = tutorial.loadedStep()
        if (step != null) {
            // Watching the solution does not complete the step.
            if (!isSolutionRun && !places.areTwo(step)) stepDone(step)
        } else if (!isSolutionRun) {
            worldTask.loadedWorld()?.let(::worldDone)
            changeWorldTask(worldTask::withoutHints)
        }
        refresh()
    }

    private fun stepDone(step: Lesson) {
        tutorial.saveProgram()
        store.update { it.copy(stepsDone = it.stepsDone + step.name) }
        changeHelp { _, help -> hints.none(help) }
    }

    /** Once a try is over and has failed, shows the hint that fits, also for a task that was done before. */
    private fun tryChanged(session: SessionState, outcome: RunOutcome, program: Program, ended: EndedAttempt?) {
        val wasOver = isTryOver
        isTryOver = outcome.finished != null
        if (wasOver || !isTryOver || outcome.isSolved) return
        if (outcome.goals.any { it.status == GoalStatus.PENDING }) return
        changeWorldTask { worldTask.afterTry(it, program, session) }
        tutorial.attemptAt(session, places.hasPassedElsewhere(ended?.program))?.let { attempt ->
            changeHelp { step, help -> hints.after(attempt, step, help) }
        }
        refresh()
    }

    /** Puts the program that has reached the goals here into the lesson's other place, and runs it. */
    private fun tryElsewhere() {
        tutorial.tryAt(state.elsewhere ?: return)
        runControls.run()
    }

    /** Called before another project is loaded. Stores the pupil's version of a step's program. */
    private fun leaveProject() {
        if (hasStarted) tutorial.saveProgram()
    }

    /** Called after another project was loaded. Shows its tutorial step, or folds the tutorial if it is not a step. */
    private fun projectChanged() {
        if (!hasStarted) return
        val shown = state.tutorial
        val step = tutorial.loadedStep()
        if (step == null) {
            if (shown?.isLoaded == true) {
                isFoldedAutomatically = !shown.isFolded
                state = state.copy(tutorial = shown.withSolution(false).copy(isFolded = true))
            }
        } else {
            if (shown?.current !== step || !shown.isLoaded) {
                val isFolded = shown?.isFolded == true && !isFoldedAutomatically
                state = state.copy(tutorial = tutorial.show(step).copy(isFolded = isFolded))
            }
            isFoldedAutomatically = false
        }
        refresh()
    }

    /** Called after the programs have changed, or another one is shown. */
    private fun programsChanged() {
        if (state.worldTask != null) refresh()
    }

    /** Updates the state after a possible change of the project or the language. */
    private fun refresh() {
        if (preferences.language != state.language || preferences.words != state.words) {
            changeHelp { _, help -> hints.none(help) }
            changeWorldTask(worldTask::withoutHints)
        }
        val brick = tutorial.brick
        val shown = state.tutorial?.copy(brick = brick)?.let {
            it.copy(isLoaded = tutorial.loadedStep() === it.current, place = tutorial.loadedPlace())
        }
        val now = state.copy(
            language = preferences.language,
            words = preferences.words,
            tutorial = shown,
            worldTask = worldTask.update(state.worldTask),
            stepsDone = progress.stepsDone,
            worldsDone = progress.worldsDone,
            drawings = drawings.drawings,
        )
        if (now != state) state = now
    }

    private fun openPage(page: LearningPage) {
        if (page == LearningPage.TUTORIAL) {
            showTutorial()
        } else {
            if (page == LearningPage.HELP || page == LearningPage.EXAMPLES) {
                state = state.copy(help = help.on(help.shownCode, null))
            }
            state = state.copy(page = page, query = "")
        }
    }

    private fun leavePage() {
        state = state.copy(page = null)
        if (!progress.welcomed) store.update { it.copy(welcomed = true) }
    }

    private fun trySquare() {
        leavePage()
        putSquare()
        runControls.run()
        notices.show(Notice.FirstProgramRuns)
    }

    /** Adds the square program as a tab, unless it is already open unchanged. */
    private fun putSquare() {
        val square = firstProgram(preferences.language, preferences.words)
        val index = current.project.pupilPrograms.indexOfFirst { it.isFirst }
        if (index >= 0) tabs.chooseProgram(index) else tabs.addProgram(square, replacing = true)
    }

    private fun beginTutorial() {
        leavePage()
        showTutorial()
        if (tutorial.loadedStep() == null) changeTutorial { tutorial.loadStep(it) }
    }

    private fun showTutorial() {
        state = state.copy(page = null, tutorial = (state.tutorial ?: tutorial.first()).copy(isFolded = false))
        store.update { it.copy(welcomed = true, tutorialShown = true, folded = false) }
    }

    /** Opens the lesson with the index [index], in its own world. */
    private fun openLesson(index: Int) {
        leavePage()
        showTutorial()
        changeTutorial { tutorial.choose(it, index) }
        if (tutorial.loadedStep() == null) changeTutorial { tutorial.loadStep(it) }
    }

    /** Shows the solution and runs it, or puts the pupil's program back. */
    private fun showSolution(shown: Boolean) {
        changeTutorial { tutorial.showSolution(it, shown) }
        if (shown && tutorial.loadedStep() != null) runControls.run()
    }

    /** What a try with another program has left, its hint and what is on the sheet, is not about the one to begin with. */
    private fun putWorldProgram() {
        if (state.worldTask?.let(worldTask::putProgram) == true) runControls.startOver()
        changeWorldTask(worldTask::withoutHints)
    }

    private fun showWorldSolution(shown: Boolean) {
        state.worldTask?.let { worldTask.showSolution(it, shown) }
    }

    private fun nextHint(shown: Boolean) = changeHelp { step, help -> hints.next(step, help, shown) }

    private fun changeTutorial(change: (TutorialState) -> TutorialState) {
        val now = state.tutorial ?: return
        state = state.copy(tutorial = change(now))
    }

    private fun changeHelp(change: (step: Lesson, help: TaskHelp) -> TaskHelp) =
        changeTutorial { it.copy(help = change(it.current, it.help)) }

    private fun changeWorldTask(change: (WorldTaskState) -> WorldTaskState) {
        state = state.copy(worldTask = state.worldTask?.let(change))
    }

    private fun fold(folded: Boolean) {
        isFoldedAutomatically = false
        changeTutorial { it.copy(isFolded = folded) }
        store.update { it.copy(folded = folded) }
    }

    /** Closes the tutorial and restores the previous project. */
    private fun leaveTutorial() {
        scope.launch { tutorial.leaveProject() }
        hideTutorial()
    }

    private fun hideTutorial() {
        state = state.copy(tutorial = null)
        store.update { it.copy(tutorialShown = false) }
    }

    private fun chooseWorld(name: String) {
        val found = WorldGallery.named(name) ?: return
        val isInTutorial = tutorial.loadedStep() != null
        leavePage()
        scope.launch {
            if (isInTutorial) tutorial.leaveProject()
            switcher.openWorld(found.world(preferences.language))
            navigator.show(Pane.WORLD)
        }
        if (isInTutorial) hideTutorial()
    }

    private fun worldDone(world: GalleryWorld) {
        if (world.name in progress.worldsDone) return
        store.update { it.copy(worldsDone = it.worldsDone + world.name) }
        notices.show(Notice.WorldSolved(world.world(preferences.language).title))
    }

    private fun showHelp(found: HelpState) {
        state = state.copy(page = LearningPage.HELP, help = found)
    }

    /** Waits until the learning progress is stored. */
    suspend fun saveNow() {
        store.saveNow()
        drawings.saveNow()
    }

    private companion object {
        /** The virtual time in which a run counts as just begun. */
        const val START_MILLISECONDS = 100L
    }
}

/** Before [LearningStateHolder.start] knows better. */
private val BEFORE_START =
    LearningState(Language.ENGLISH, HelpState(ProgramLanguage.default, word = null, found = null, BrickKind.default))
