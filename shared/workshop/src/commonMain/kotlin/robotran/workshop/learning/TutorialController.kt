package robotran.workshop.learning

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.launch
import robotran.brick.kind.BrickKind
import robotran.documents.tutorialProjectName
import robotran.languagesupport.SourceFile
import robotran.learning.Lesson
import robotran.learning.LessonPlace
import robotran.learning.Lessons
import robotran.learning.hint.Attempt
import robotran.programs.support
import robotran.projects.Project
import robotran.simulation.state.SessionState
import robotran.workshop.service.CurrentProject
import robotran.workshop.service.Preferences
import robotran.workshop.service.ProjectEditor
import robotran.workshop.service.ProjectSwitcher
import robotran.workshop.service.ScreenNavigator
import robotran.workshop.service.SwitchResult
import robotran.workshop.service.pupilPrograms
import robotran.workshop.state.Pane
import robotran.workshop.state.TaskHelp
import robotran.workshop.state.TutorialState

/**
 * Loads the tutorial's steps into a project of their own, and restores the previous project afterwards. The pupil's
 * version of each step's program is stored and restored.
 */
internal class TutorialController(
    private val scope: CoroutineScope,
    private val preferences: Preferences,
    private val current: CurrentProject,
    private val editor: ProjectEditor,
    private val switcher: ProjectSwitcher,
    private val navigator: ScreenNavigator,
    private val store: LearningProgressStore,
) {
    private var isSolutionLoaded = false
    private val progress: LearningProgress get() = store.progress

    /** The initial state of the tutorial, at the last step shown. */
    fun first() = TutorialState(Lessons.all.indexOfFirst { it.name == progress.step }.coerceAtLeast(0), brick = brick)

    /**
     * The brick that the pupil works with: that of the open project. While a step is loaded, it is that of the step, unless
     * the pupil has got this step for a robot with another brick, on which it is not there.
     */
    val brick: BrickKind
        get() {
            val step = loadedStep() ?: return current.shownRobot.description.brick
            val before = BrickKind.entries.firstOrNull { it.name == progress.brick }
            return before?.takeIf { Lessons.all[Lessons.indexOf(step)].on(it) === step } ?: step.brick
        }

    /** The step whose world is loaded, for the brick of its robot; null for any other world. */
    fun loadedStep(): Lesson? = Lessons.lessonIn(current.project.world)

    /** The place of the loaded step; the first one of any other world. */
    fun loadedPlace(): LessonPlace = loadedStep()?.placeOf(current.project.world) ?: LessonPlace.FIRST

    /** Puts the loaded step's robot with its program into the world of [place]. */
    fun tryAt(place: LessonPlace) {
        val step = loadedStep()?.takeIf { place in it.places } ?: return
        editor.changeWorld(step.world(preferences.language, place, preferences.words))
    }

    /** The tutorial at [step], which is loaded. */
    fun show(step: Lesson): TutorialState {
        store.update { it.copy(step = step.name, tutorialShown = true) }
        val text = loadedProgram(step)?.let { usual(step, it) }
        isSolutionLoaded = text == step.solution.text && usual(step, pupilProgram(step).text) != text
        return TutorialState(
            Lessons.indexOf(step),
            help = TaskHelp(solutionShown = isSolutionLoaded),
            brick = brick,
        )
    }

    /** Shows the step with the index [index]. If a step is loaded, also loads the new step's program and world. */
    fun choose(tutorial: TutorialState, index: Int): TutorialState {
        if (index !in Lessons.all.indices) return tutorial
        val chosen = TutorialState(index, isFolded = tutorial.isFolded, brick = brick)
        if (loadedStep() != null) {
            saveProgram()
            keepBrick()
            open(chosen.current, pupilProgram(chosen.current))
        }
        store.update { it.copy(step = chosen.current.name) }
        return chosen
    }

    /** Loads the pupil's version of the current step's program, and its world. */
    fun loadStep(tutorial: TutorialState): TutorialState {
        val now = tutorial.copy(brick = brick)
        switchTo(now.current, pupilProgram(now.current))
        navigator.show(Pane.PROGRAM)
        return now.withSolution(false)
    }

    /** Loads the original program of the current step. */
    fun beginAgain(tutorial: TutorialState): TutorialState {
        val now = tutorial.copy(brick = brick)
        switchTo(now.current, now.current.program)
        store.update { it.copy(programs = it.programs - now.current.savedName) }
        return now.withSolution(false)
    }

    /** Loads the current step's solution, or the pupil's program again, in the place that is loaded. */
    fun showSolution(tutorial: TutorialState, shown: Boolean): TutorialState {
        if (shown == tutorial.help.solutionShown) return tutorial
        if (shown) saveProgram()
        val now = tutorial.copy(brick = brick)
        val place = loadedPlace()
        switchTo(now.current, if (shown) now.current.solution else pupilProgram(now.current), place)
        return now.withSolution(shown)
    }

    /** Restores the project from before the tutorial if a step is loaded. */
    suspend fun leaveProject() {
        if (loadedStep() == null) return
        saveProgram()
        switcher.resumeProject(progress.previousProject, brick)
    }

    /** Loads [file] and the world of [step]; first stores the pupil's project. */
    private fun switchTo(step: Lesson, file: SourceFile, place: LessonPlace = LessonPlace.FIRST) {
        keepBrick()
        if (loadedStep() != null) return open(step, file, place)
        scope.launch {
            val project = projectOf(step, file)
            val result = switcher.beginProject(
                tutorialProjectName(preferences.language),
                project,
                progress.tutorialProject,
            )
            if (result is SwitchResult.Switched) {
                isSolutionLoaded = file === step.solution
                store.update { it.copy(previousProject = result.previousId, tutorialProject = result.currentId) }
            }
        }
    }

    /** Keeps the pupil's [brick] for the time in which a step may have another one. */
    private fun keepBrick() {
        val now = brick.name
        if (progress.brick != now) store.update { it.copy(brick = now) }
    }

    private fun open(step: Lesson, file: SourceFile, place: LessonPlace = LessonPlace.FIRST) {
        // Another step may be loaded, which has places of its own.
        val there = place.takeIf { it in step.places } ?: LessonPlace.FIRST
        editor.openProject(projectOf(step, file, there))
        isSolutionLoaded = file === step.solution
    }

    /** The project of [step] with [file], which has the words of the app's programs unless it is the pupil's own. */
    private fun projectOf(step: Lesson, file: SourceFile, place: LessonPlace = LessonPlace.FIRST): Project {
        val words = preferences.words
        val isOwn = file !== step.program && file !== step.solution
        val written = if (isOwn) file else file.copy(text = step.programLanguage.support.inWords(file.text, words))
        return step.project(preferences.language, listOf(written), place, words)
    }

    private fun usual(step: Lesson, program: String): String = step.programLanguage.support.inUsualWords(program)

    /** Stores the pupil's version of the loaded step's program, unless it is the solution. */
    fun saveProgram() {
        val step = loadedStep()
        if (step == null || isSolutionLoaded) return
        val text = loadedProgram(step) ?: return
        store.update {
            val others = it.programs - step.savedName
            val isAsGiven = usual(step, text) == step.program.text
            it.copy(programs = if (isAsGiven) others else others + (step.savedName to text))
        }
    }

    /**
     * The try at the loaded step that ended in [session]; null if no step or its solution is loaded.
     *
     * @param hasPassed whether the same program has reached the goals in the step's other place.
     */
    fun attemptAt(session: SessionState, hasPassed: Boolean): Attempt? {
        val step = loadedStep()
        if (step == null || isSolutionLoaded) return null
        return loadedProgram(step)?.let { step.attempt(it, session, loadedPlace(), hasPassed) }
    }

    private fun loadedProgram(step: Lesson): String? =
        current.project.pupilPrograms.firstOrNull { it.name == step.program.name }?.files?.first()?.text

    private fun pupilProgram(step: Lesson) =
        progress.programs[step.savedName]?.let { SourceFile(step.program.name, it) } ?: step.program

    /** The name under which the pupil's version of the program is saved: ports differ between bricks. */
    private val Lesson.savedName: String get() = if (brick ==
        BrickKind.default
    ) {
        name
    } else {
        "${brick.name.lowercase()}/$name"
    }
}

/** The same with the solution in the editor if [shown]. */
internal fun TutorialState.withSolution(shown: Boolean): TutorialState = copy(help = help.copy(solutionShown = shown))
