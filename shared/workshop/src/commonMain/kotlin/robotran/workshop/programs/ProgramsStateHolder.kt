package robotran.workshop.programs

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import robotran.brick.kind.BrickKind
import robotran.brick.kind.JavaPlatform
import robotran.documents.SavedBreakpoint
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.language.source.Diagnostic
import robotran.language.source.Severity
import robotran.language.source.SourceRange
import robotran.nxt.storage.NxtFile
import robotran.programs.CompilerLoading
import robotran.programs.JavaSettings
import robotran.programs.Program
import robotran.programs.ProgramCompiler
import robotran.programs.support
import robotran.projects.PENBOT_TARGET
import robotran.projects.ProgramView
import robotran.projects.Project
import robotran.projects.ProjectRobot
import robotran.projects.charactersInFile
import robotran.projects.target
import robotran.simulation.Breakpoint
import robotran.simulation.RobotProgramSet
import robotran.workshop.blocks.BlockDialog
import robotran.workshop.blocks.DragPayload
import robotran.workshop.blocks.firstLength
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.examples.firstProgram
import robotran.workshop.service.ProgramsToRun
import robotran.workshop.service.Services
import robotran.workshop.service.WrittenPrograms
import robotran.workshop.service.asProject
import robotran.workshop.service.asPupil
import robotran.workshop.state.CompileStatus
import robotran.workshop.state.Pane
import robotran.workshop.state.ProgramsState
import robotran.workshop.state.Snippet
import robotran.workshop.state.asSnippet
import robotran.world.RobotPlacement
import robotran.world.World

/**
 * Holds the programs of all robots in a world, as written by the pupil, and their compile results.
 *
 * @param project the initial project; its first robot gets the square program if it has none.
 * @param roomInFile how many characters all programs may take in the project's file, see [charactersInFile].
 */
class ProgramsStateHolder(
    project: Project,
    services: Services,
    private val roomInFile: () -> Int = { Int.MAX_VALUE },
) : ProgramsToRun {
    private val platform = services.platform
    private val preferences = services.preferences
    private val navigator = services.navigator
    private var compiler = ProgramCompiler(
        PENBOT_TARGET,
        project.settings.java,
        preferences.language,
        compilesBeside = platform.compilesBeside,
    )
    private var robots = robotsOf(project)
    private var chosenRobot = robots.first().placement.name
    private var translationShown = false
    private var lastTranslation: ProgramLanguage? = null
    private var searchRequested = false
    private val shown: RobotPrograms get() = robots.firstOrNull { it.placement.name == chosenRobot } ?: robots.first()
    private val compileScheduler = CompileScheduler()
    private val editing = ProgramEditing(preferences, navigator, services.notices, ::hasRoom)
    private val otherBrick = OtherBrickFinder()
    private var lastStatus = CompileStatus.DONE

    var state: ProgramsState by mutableStateOf(stateNow())
        private set

    init {
        requestCompile()
        refresh()
    }

    fun handle(event: ProgramEvent) {
        if (event is ProgramEvent.RobotChosen) chosenRobot = event.name
        if (event is ProgramEvent.TranslationShown) {
            translationShown = event.shown
            lastTranslation = event.kind ?: lastTranslation
        }
        if (event == ProgramEvent.SearchRequested) openSearch()
        if (event == ProgramEvent.SearchOpened) searchRequested = false
        editing.handle(event, shown)
        requestCompile()
        if (editing.waitsForCompiler) requestCompileNow()
        refresh()
    }

    override val written: WrittenPrograms
        get() = WrittenPrograms(
            robots.map { it.list.programs },
            robots.map { robot -> robot.list.slots.map { it != null } },
        )

    override val count: Int get() = robots.first().list.entries.size

    override val slotToRun: Int get() = robots.first().shownProgram

    override val shownProgram: Program get() = state.program
    override val shownRobot: String get() = state.shownRobot
    override val compileStatus: CompileStatus get() = state.compileStatus

    override fun showRobot(name: String) = handle(ProgramEvent.RobotChosen(name))

    /** The programs of all robots in [world] as stored in a project. */
    fun projectRobots(world: World): List<ProjectRobot> =
        robots.filter { robot -> world.robots.any { it.name == robot.placement.name } }.mapNotNull {
            it.asProject(preferences.settings.programView)
        }

    override fun slotsBeginning(first: Int): List<Int> = starting(first).map { it.second }

    override fun loads(world: World, firstSlots: List<Int>): List<RobotProgramSet> =
        world.robots.mapIndexed { index, placement ->
            robots.firstOrNull { it.placement.name == placement.name }?.load(firstSlots.getOrElse(index) { 0 })
                ?: RobotProgramSet(emptyList())
        }

    override fun keepFiles(robot: String, files: List<NxtFile>): Boolean =
        robots.firstOrNull { it.placement.name == robot }?.keep(files) == true

    override fun breakpoints(robot: String, slot: Int): Set<Breakpoint> =
        robots.firstOrNull { it.placement.name == robot }?.breakpoints(slot).orEmpty()

    /** The breakpoints of all programs, in order. */
    internal val savedBreakpoints: List<SavedBreakpoint>
        get() = robots.flatMap { robot -> robot.list.entries.flatMap { it.savedBreakpoints(robot.placement.name) } }

    /** Sets the breakpoints of all programs. */
    internal fun restoreBreakpoints(breakpoints: List<SavedBreakpoint>) {
        for (robot in robots) {
            val own = breakpoints.filter { it.robot == robot.placement.name }.groupBy { it.program }
            for ((program, lines) in own) {
                val slot = robot.list.entries.indexOfFirst { it.program.name == program }
                if (slot >= 0) robot.list.change(slot, robot.list.entries[slot].withBreakpoints(lines))
            }
        }
        refresh()
    }

    override fun breakpointsOf(program: Snippet): Set<Breakpoint> {
        val robot = robots.firstOrNull { it.placement.name == program.robot } ?: return emptySet()
        val source = robot.list.programs.getOrNull(program.slot)?.files?.first()?.text
        return if (source == program.source) robot.breakpoints(program.slot) else emptySet()
    }

    override fun canStart(slot: Int): Boolean {
        if (!isCompiled(slot)) requestCompileNow()
        if (!isCompiled(slot)) return false
        val withErrors =
            starting(slot).firstOrNull { (robot, itsSlot) -> robot.isNeeded() && !robot.list.canRun(itsSlot) }
                ?: return true
        chosenRobot = withErrors.first.placement.name
        editing.pointOutErrors(withErrors.first, withErrors.second)
        refresh()
        return false
    }

    /** The program that does [load] alone; null if there can be none, and then the blocks say why. */
    internal fun snippet(load: DragPayload): Snippet? {
        val robot = shown
        val blocks = robot.editorState.blocks?.takeIf { state.view.hasBlocks } ?: return null
        val itsCompiler = compiler.forTarget(robot.placement.description.target)
        return when (val result = itsCompiler.compileSnippet(load, blocks, robot.entry.program.name)) {
            is SnippetResult.Success -> {
                asSnippet(result.program, robot.placement.name, robot.shownProgram, robot.editorState.draft.text)
            }

            is SnippetResult.Failure -> {
                val editorState = robot.editorState.copy(blocks = blocks.copy(error = result.reason))
                robot.list.change(robot.shownProgram, robot.entry.with(robot.shownFile, editorState))
                refresh()
                null
            }
        }
    }

    /** Moves the caret of the shown program to [diagnostic]. */
    fun showDiagnostic(diagnostic: Diagnostic) {
        editing.pointOut(shown, diagnostic)
        refresh()
    }

    /** Shows the line [line], from 1, of the first robot's program at [index]. */
    internal fun showLine(index: Int, line: Int) {
        handle(ProgramEvent.RobotChosen(robots.first().placement.name))
        handle(ProgramEvent.ProgramChosen(index))
        showDiagnostic(Diagnostic(Severity.ERROR, "", SourceRange(line, 1, 0), ""))
    }

    /** Opens the first length of the shown program if it is shown in blocks, so that a finger changes it at once. */
    fun editFirstLength() {
        val length = state.blocks?.takeIf { state.view.hasBlocks }?.program?.firstLength() ?: return
        handle(BlockEvent.CursorPut(length.cursor, length.span))
        handle(BlockEvent.DialogShown(BlockDialog.Part(length.span)))
    }

    override fun isCompiled(slot: Int): Boolean = starting(slot).all { (robot, itsSlot) ->
        robot.list.isCompiled(itsSlot)
    }

    override fun showFile(robot: String, slot: Int, name: String) {
        if (shown.placement.name != robot || shown.shownProgram != slot) return
        val index = shown.entry.program.files.indexOfFirst { it.name == name }
        if (index < 0 || index == shown.shownFile) return
        shown.shownFile = index
        refresh()
    }

    /** Replaces all programs by those of [project]. */
    fun open(project: Project) {
        compiler = compiler.withJava(project.settings.java)
        robots = robotsOf(project)
        chosenRobot = robots.first().placement.name
        lastStatus = CompileStatus.DONE
        requestCompile()
        refresh()
    }

    /** Gives the first robot exactly [programs] and shows the first. Files of the same name can be undone. */
    internal fun replacePrograms(programs: List<Program>) {
        chosenRobot = robots.first().placement.name
        editing.replaceAll(robots.first(), programs)
        requestCompile()
        refresh()
    }

    /**
     * Removes the first robot's programs that [isMeant]. If no other would be left, it gets those of a robot to which
     * nobody has given any.
     */
    internal fun removePrograms(isMeant: (Program) -> Boolean) {
        val first = robots.first()
        if (first.list.programs.none(isMeant)) return
        if (!first.removeAll(isMeant)) {
            val placement = first.placement
            val programs = if (placement.program == null) listOf(firstProgram()) else emptyList()
            robots = listOf(robotOf(placement, ProjectRobot(placement.name), programs)) + robots.drop(1)
        }
        requestCompile()
        refresh()
    }

    /**
     * Updates the robots to those of [world]. Robots keep their programs by name; the first robot gets those of the
     * first.
     */
    fun worldChanged(world: World) {
        val before = robots
        robots = world.robots.mapIndexed { index, placement ->
            val known =
                before.firstOrNull { it.placement.name == placement.name } ?: before.first().takeIf { index == 0 }
            known?.movedTo(placement) ?: robotOf(placement, ProjectRobot(placement.name), emptyList())
        }
        if (robots.none { it.placement.name == chosenRobot }) chosenRobot = robots.first().placement.name
        // A robot with other wheels drives for other times.
        requestCompile()
        refresh()
    }

    /** Compiles all programs again, with diagnostics in [language]. */
    fun setLanguage(language: Language) = useCompiler(compiler.withLanguage(language))

    /** Compiles all programs again with the Java settings [java]. */
    fun runJava(java: JavaSettings) = useCompiler(compiler.withJava(java))

    private fun useCompiler(next: ProgramCompiler) {
        if (next === compiler) return
        compiler = next
        robots = robots.map { it.compiledBy(compiler) }
        lastStatus = CompileStatus.DONE
        requestCompile()
        refresh()
    }

    /** Suspends until there is something to compile and typing pauses. */
    suspend fun awaitCompile() = compileScheduler.awaitCompile()

    override suspend fun compile(): CompileStatus {
        val result = resultOf { compileChanged() }
        lastStatus = result
        editing.programsCompiled(shown)
        // That may have changed a program.
        if (result == CompileStatus.DONE) requestCompile()
        refresh()
        return result
    }

    /** Loads what completion and help say about Java for an NXT, if a robot needs that. Without it they offer less. */
    internal suspend fun loadHelp() {
        val needsIt = robots.any { robot ->
            robot.brick.java == JavaPlatform.NXJ && robot.list.programs.any { it.language.support.hasSlowCompiler }
        }
        if (needsIt) nxjSources()
    }

    private suspend fun compileChanged(): CompilerLoading {
        for (robot in robots) {
            val loading = robot.list.compilePending(platform.background)
            if (loading is CompilerLoading.Failure) return loading
        }
        return CompilerLoading.Success
    }

    private fun requestCompile() {
        if (robots.none { it.list.hasPending }) return
        lastStatus = CompileStatus.WAITING
        compileScheduler.requestCompile(robots.sumOf { it.list.pendingCharacters })
    }

    private fun requestCompileNow() {
        lastStatus = CompileStatus.COMPILING
        compileScheduler.requestCompileNow()
        refresh()
    }

    /** Whether the project can still be saved if [new] takes the place of [old] in one of its programs. */
    private fun hasRoom(old: String, new: String): Boolean {
        if (new.length <= old.length) return true
        val programs = robots.flatMap { it.list.programs }
        if (programs.sumOf { it.characters } + new.length <= SURELY_SAVED) return true
        val now = programs.sumOf { program -> program.files.sumOf { charactersInFile(it.text) } }
        return now + charactersInFile(new) - charactersInFile(old) <= roomInFile()
    }

    private fun starting(slot: Int): List<Pair<RobotPrograms, Int>> =
        robots.mapIndexed { index, robot -> robot to if (index == 0) slot else robot.shownProgram }

    /** The first robot, and all robots with a program that is not blank, need their programs. */
    private fun RobotPrograms.isNeeded() = this === robots.first() || !isBlank

    private fun robotsOf(project: Project): List<RobotPrograms> = project.world.robots.mapIndexed { index, placement ->
        val saved = project.robots.firstOrNull { it.name == placement.name } ?: ProjectRobot(placement.name)
        val programs = saved.programs.map { it.asPupil() }
        val isAlone = index == 0 && programs.isEmpty() && placement.program == null
        robotOf(placement, saved, if (isAlone) listOf(firstProgram()) else programs)
    }

    private fun robotOf(placement: RobotPlacement, saved: ProjectRobot, programs: List<Program>) =
        RobotPrograms(placement, saved, compiler, programs, preferences.settings.programView)

    private fun openSearch() {
        searchRequested = true
        navigator.show(Pane.PROGRAM)
    }

    /** The brick that the shown program of [robot] is for, if its compiler has refused it for that. */
    private fun otherBrickOf(robot: RobotPrograms): BrickKind? =
        if (robot.entry.diagnostics.isEmpty()) null else otherBrick.find(robot.entry.program, robot.brick)

    private fun refresh() {
        shown.readBlocks(preferences.language)
        state = stateNow()
    }

    private fun stateNow(): ProgramsState {
        val robot = shown
        val entry = robot.entry
        val support = entry.program.language.support
        val kinds = support.translations(robot.brick)
        val kind = lastTranslation.takeIf { it in kinds } ?: kinds.firstOrNull()
        return ProgramsState(
            robots = robots.map { it.placement },
            shownRobot = robot.placement.name,
            isWorldsOwn = robot.isUntouched && !robot.isBlank,
            programs = robot.list.programs,
            shownProgram = robot.shownProgram,
            shownFile = robot.shownFile,
            draft = robot.editorState.draft,
            canUndo = robot.editorState.history.canUndo,
            canRedo = robot.editorState.history.canRedo,
            breakpoints = robot.editorState.breakpoints,
            view = if (support.hasBlocks) robot.editorState.view else ProgramView.TEXT,
            blocks = robot.editorState.blocks,
            closed = robot.closed?.name,
            closedMessageShown = robot.closedMessageShown,
            canReopen = robot.canReopen,
            diagnostics = entry.diagnostics,
            notes = entry.notes,
            compileStatus = lastStatus,
            errorPointedOut = editing.errorPointedOut,
            translationShown = translationShown,
            translationKind = kind,
            translation = kind?.takeIf { translationShown }?.let { entry.translation(it, preferences.language) },
            isTranslated = entry.isTranslated,
            searchRequested = searchRequested,
            otherBrick = otherBrickOf(robot),
        )
    }

    private companion object {
        /** In characters. Together they are short beside what a project's file may have. */
        const val SURELY_SAVED = 20_000
    }
}
