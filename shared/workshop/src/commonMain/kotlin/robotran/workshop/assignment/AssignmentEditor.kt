package robotran.workshop.assignment

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import kotlinx.coroutines.Job
import kotlinx.coroutines.launch
import kotlinx.coroutines.withContext
import robotran.assignments.doing.firstPrograms
import robotran.assignments.doing.isOfSolution
import robotran.assignments.doing.ordinaryText
import robotran.assignments.packaging.ScormVersion
import robotran.projects.Assignment
import robotran.projects.AssignmentChecks
import robotran.projects.AssignmentLimits
import robotran.projects.WorldVariation
import robotran.workshop.event.AssignmentEvent
import robotran.workshop.platform.FileKind
import robotran.workshop.service.RoomEvent
import robotran.workshop.service.Services
import robotran.workshop.service.asPupil
import robotran.workshop.state.AssignmentEditorState
import robotran.workshop.state.EndedAttempt
import robotran.workshop.state.PictureError
import robotran.workshop.state.SolutionCheck
import robotran.workshop.state.SolutionProgram
import robotran.world.WorldLimits

/** The page with which an author makes an assignment of the open project. */
internal class AssignmentEditor(
    private val services: Services,
    private val runs: AssignmentRuns,
    private val lastTry: () -> EndedAttempt?,
) {
    private val platform = services.platform
    private val scope = services.scope
    private val current = services.current
    private val assignments = services.assignments
    private val tabs = services.tabs

    /** Null while the page is closed. */
    var state: AssignmentEditorState? by mutableStateOf(null)
        private set

    /** Whether the world editor leads back to the page. */
    private var isAway = false

    /** Whether the world that robots drive in has another title or task. */
    private var isTaskChanged = false
    private val history = AssignmentHistory(platform.clock)
    private val sharing = AssignmentSharing(platform, current, services.preferences)
    private var checking: Job? = null
    private var deciding: Job? = null
    private val beginning = PupilsBeginning(runs)
    private val giving = AskedGiving(runs)

    fun handle(event: AssignmentEvent.OfAuthor) {
        if (event == AssignmentEvent.MakingRequested) return open()
        val now = state ?: return
        when (event) {
            AssignmentEvent.MakingRequested -> Unit
            AssignmentEvent.MakingClosed -> close()
            is AssignmentEvent.Changed -> change(event.assignment)
            is AssignmentEvent.TaskChanged -> changeTask(event.title, event.task)
            AssignmentEvent.UndoRequested -> undo()
            AssignmentEvent.Removed -> remove()
            AssignmentEvent.PictureRequested -> scope.launch { addPicture() }
            is AssignmentEvent.StartSwitched -> switchStart(now.assignment, event.index, event.on)
            AssignmentEvent.SolutionTaken -> change(now.assignment.copy(solution = solutionNow(now.assignment)))
            is AssignmentEvent.SolutionSwitched -> switchSolution(now, event.index, event.on)
            AssignmentEvent.SolutionShown -> showSolution(now.assignment)
            AssignmentEvent.WorldRequested -> leaveFor(variation = null)
            is AssignmentEvent.VariationAdded -> addVariation(now.assignment, event.name)
            is AssignmentEvent.VariationOpened -> leaveFor(event.index)
            is AssignmentEvent.CheckRequested -> check(event.on)
            AssignmentEvent.TeacherFileSaved -> share { sharing.saveForTeacher(it) }
            AssignmentEvent.PupilFileSaved -> give { sharing.saveForPupils(it) }
            AssignmentEvent.PupilLinkRequested -> give { sharing.makeLink(it) }
            AssignmentEvent.PupilLinkCopied -> share { sharing.copyLink(it) }
            AssignmentEvent.PupilLinkShared -> share { sharing.shareLink(it) }
            AssignmentEvent.PupilLinkClosed -> state = now.copy(link = null)
            AssignmentEvent.EmbedCodeCopied -> give { sharing.copyEmbedCode(it) }
            is AssignmentEvent.PackageSaved -> pack(now, event.version)
            AssignmentEvent.GivingConfirmed -> giveAllTheSame()
            AssignmentEvent.GivingCancelled -> state = now.copy(asksBeforeGiving = false, isPacking = false)
        }
    }

    /** Called when the world editor was closed; [leadsBack] is false if its world is tried out now. */
    fun worldEditorClosed(leadsBack: Boolean) {
        if (!isAway) return
        isAway = false
        if (leadsBack) state = stateNow()
    }

    /** Called after another project was opened. */
    fun leave() {
        checking?.cancel()
        deciding?.cancel()
        isAway = false
        isTaskChanged = false
        state = null
        history.clear()
    }

    private fun open() {
        if (state != null) return
        val before = current.project.assignment
        val made = before?.let(::completed) ?: begun()
        if (made != before) assignments.changeAssignment(made)
        state = stateNow()
        if (before == null) deciding = scope.launch { decideBeginning(made) }
    }

    private fun begun(): Assignment {
        val solution = solvingProgram(current.project, lastTry())
        val unsure = beginning.unsure(plainPrograms())
        return newAssignment(current.project, platform.clock.now, solution, unsure)
    }

    /** Pupils begin with the author's programs, except with those that solve the task, if the author has not chosen. */
    private suspend fun decideBeginning(begun: Assignment) {
        val decided = beginning.decide(current.project, begun, plainPrograms())
        val now = current.project.assignment?.takeIf { it.id == begun.id && it.start == begun.start } ?: return
        val solution = if (now.solution == begun.solution) decided.solution else now.solution
        val made = withBeginning(now.copy(start = decided.start, solution = solution), plainPrograms())
        assignments.changeAssignment(made)
        if (state != null) refresh()
    }

    /** [before] with what the author has written meanwhile, beside what pupils begin with, as the solution. */
    private fun completed(before: Assignment): Assignment {
        val start = before.start.ifEmpty { plainPrograms() }
        val checks = before.checks ?: AssignmentChecks(FIRST_SEEDS)
        val made = withBeginning(before.copy(start = start, checks = checks), plainPrograms())
        if (made.solution.isNotEmpty()) return made
        val given = made.start.map(::textsOf)
        return made.copy(solution = solutionNow(made).filter { textsOf(it) !in given })
    }

    private fun close() {
        checking?.cancel()
        state = null
        useTask()
    }

    /** Puts the robots into the world with the new title and task. */
    private fun useTask() {
        if (isTaskChanged) services.editor.changeWorld(current.project.world)
        isTaskChanged = false
    }

    private fun stateNow(): AssignmentEditorState? {
        val project = current.project
        val assignment = project.assignment ?: return null
        val before = state
        return AssignmentEditorState(
            assignment,
            before?.title?.takeIf { it.isBlank() } ?: project.world.title,
            project.world.task,
            startPrograms(project.firstPrograms, assignment),
            solutionPrograms(project.firstPrograms, assignment) + listOfNotNull(
                offered(assignment)?.let {
                    SolutionProgram(it.name, isTaken = false, isChanged = false, isOpen = false, isOfWorld = true)
                },
            ),
            solutionNow(assignment) != assignment.solution,
            project.world.goals.size,
            history.canUndo,
            missingParts(project, assignment),
            // It is about what has just been changed.
            check = before?.check?.takeIf { before.assignment == assignment },
            hasShareSheet = platform.sharing.hasShareSheet,
            canPack = platform.webSite != null,
            isPacking = before?.isPacking == true,
            isAboutPackage = before?.isAboutPackage == true,
        )
    }

    private fun refresh() {
        state = stateNow()
    }

    private fun change(typed: Assignment) {
        val assignment = withBeginning(ordinary(typed), plainPrograms())
        val before = current.project
        if (assignment != before.assignment) {
            checking?.cancel()
            history.add(before, assignment)
            assignments.changeAssignment(assignment)
            refresh()
        }
        val kept = typed.start.filter { isOfSolution(it, typed.solution) }.map { it.name }
        state = state?.copy(notGiven = kept)
    }

    private fun changeTask(title: String, task: String) {
        val before = current.project
        val world = before.world.copy(
            title = ordinaryText(title, WorldLimits.MAXIMUM_TITLE_CHARACTERS, severalLines = false)
                .ifBlank { before.world.title },
            task = ordinaryText(task, WorldLimits.MAXIMUM_TASK_CHARACTERS, severalLines = true),
        )
        state = state?.copy(title = title)
        if (world == before.world) return
        history.add(before, before.assignment)
        services.editor.saveWorld(world)
        isTaskChanged = true
        refresh()
    }

    private fun undo() {
        val before = history.takeLast() ?: return
        checking?.cancel()
        assignments.changeAssignment(before.assignment)
        if (before.title != current.project.world.title || before.task != current.project.world.task) {
            services.editor.saveWorld(current.project.world.copy(title = before.title, task = before.task))
            isTaskChanged = true
        }
        refresh()
    }

    private fun remove() {
        assignments.changeAssignment(null)
        history.clear()
        close()
    }

    private fun plainPrograms() = current.project.firstPrograms.map { it.copy(view = null) }

    private fun switchStart(assignment: Assignment, index: Int, on: Boolean) {
        val program = plainPrograms().getOrNull(index) ?: return
        val others = assignment.start.filter { it.name != program.name && !isBlank(it) }
        change(assignment.copy(start = if (on) others + program else others))
    }

    private fun offered(assignment: Assignment) = solutionOfWorld(current.project, plainPrograms(), assignment)

    private fun solutionNow(assignment: Assignment) = solutionNow(current.project, plainPrograms(), assignment)

    private fun switchSolution(now: AssignmentEditorState, index: Int, on: Boolean) {
        val name = now.solution.getOrNull(index)?.name ?: return
        val open = plainPrograms()
        val others = now.assignment.solution.filter { it.name != name }
        val program = open.firstOrNull { it.name == name } ?: offered(now.assignment)?.takeIf { it.name == name }
        val all = others + listOfNotNull(program.takeIf { on })
        // Grading starts the first one, so they stay in the order of the editor; those that are not open come last.
        val order = open.map { it.name }
        val sorted = all.sortedBy { program -> if (program.name in order) order.indexOf(program.name) else order.size }
        change(now.assignment.copy(solution = sorted))
    }

    private fun showSolution(assignment: Assignment) {
        assignment.solution.forEach { tabs.addProgram(it.asPupil(), replacing = true) }
        close()
    }

    private fun addVariation(assignment: Assignment, name: String) {
        val checks = assignment.checks ?: return
        if (checks.variations.size >= AssignmentLimits.MAXIMUM_VARIATIONS) return
        val variation = WorldVariation(name.take(WorldLimits.MAXIMUM_TITLE_CHARACTERS), current.project.world)
        change(assignment.copy(checks = checks.copy(variations = checks.variations + variation)))
        leaveFor(checks.variations.size)
    }

    private fun leaveFor(variation: Int?) {
        checking?.cancel()
        state = null
        useTask()
        isAway = true
        services.publish(RoomEvent.WorldEditorRequested(variation))
    }

    private suspend fun addPicture() {
        val file = platform.files.open(listOf(FileKind.PNG, FileKind.JPEG, FileKind.LONG_JPEG)).firstOrNull() ?: return
        if (hasAllPictures()) return tell(PictureError.TOO_MANY)
        val fitted = withContext(platform.background) { fitPicture(file.bytes, platform.photoReader) }
        // Meanwhile the teacher may have left, or gone on writing.
        val assignment = state?.assignment ?: return
        when {
            fitted is FittedPicture.Failure -> tell(fitted.error)
            hasAllPictures() -> tell(PictureError.TOO_MANY)

            fitted is FittedPicture.Success -> {
                change(withPicture(assignment, file.name, fitted.bytes))
                state = state?.copy(pictureMadeSmaller = fitted.madeSmaller)
            }
        }
    }

    private fun hasAllPictures(): Boolean =
        state?.let { it.assignment.pictures.size >= AssignmentLimits.MAXIMUM_PICTURES } == true

    private fun tell(error: PictureError) {
        state = state?.copy(pictureError = error, pictureMadeSmaller = null)
    }

    private fun check(on: Boolean) {
        checking?.cancel()
        state = state?.copy(check = null)
        if (!on) return
        checking = scope.launch {
            val project = current.project
            val solution = project.assignment?.solution.orEmpty()
            val checked = runs.check(project, solution) { done, all -> tell(SolutionCheck.Running(done, all)) }
            tell(resultOf(checked))
        }
    }

    private fun tell(check: SolutionCheck) {
        state = state?.copy(check = check)
    }

    private fun resultOf(checked: CheckedSolution): SolutionCheck = when (checked) {
        is CheckedSolution.HasErrors -> SolutionCheck.HasErrors(checked.reasons)

        is CheckedSolution.Checked -> if (checked.failed == 0) {
            SolutionCheck.Passed(checked.runs, checked.startPassed)
        } else {
            val world = checked.world.orEmpty()
            SolutionCheck.Failed(checked.failed, checked.runs, world, checked.seed ?: 0, checked.startPassed)
        }
    }

    private fun share(what: suspend (AssignmentEditorState) -> AssignmentEditorState) {
        scope.launch {
            val now = state ?: return@launch
            val then = what(now.copy(savedAs = null, saveError = null, embedCodeCopied = false, embedError = null))
            // The author may have gone on meanwhile.
            state = state?.copy(
                link = then.link,
                savedAs = then.savedAs,
                saveError = then.saveError,
                embedCode = then.embedCode,
                embedCodeCopied = then.embedCodeCopied,
                embedError = then.embedError,
                isPacking = false,
                isAboutPackage = now.isPacking,
            )
        }
    }

    /** Shares by [what], or asks first if pupils would begin with a solution. */
    private fun give(what: suspend (AssignmentEditorState) -> AssignmentEditorState) {
        scope.launch {
            if (giving.mustAsk(current.project, what)) {
                state = state?.copy(asksBeforeGiving = true)
            } else {
                share(what)
            }
        }
    }

    private fun giveAllTheSame() {
        state = state?.copy(asksBeforeGiving = false)
        giving.confirmed(current.project)?.let(::share)
    }

    private fun pack(page: AssignmentEditorState, version: ScormVersion) {
        if (page.isPacking) return
        state = page.copy(isPacking = true)
        give { sharing.savePackage(it, version) }
    }
}
