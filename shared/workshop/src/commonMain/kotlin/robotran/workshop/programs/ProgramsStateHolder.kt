package robotran.workshop.programs

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import robotran.brick.kind.BrickKind
import robotran.documents.SavedBreakpoint
import robotran.language.Language
import robotran.language.ShownLanguage
import robotran.language.source.Diagnostic
import robotran.language.source.Severity
import robotran.language.source.SourceRange
import robotran.programs.JavaSettings
import robotran.programs.Program
import robotran.programs.ProgramCompiler
import robotran.programs.support
import robotran.projects.ProgramView
import robotran.projects.Project
import robotran.workshop.blocks.BlockDialog
import robotran.workshop.blocks.DragPayload
import robotran.workshop.blocks.firstLength
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.service.ProgramRoomEvent
import robotran.workshop.service.ProgramsOfRobots
import robotran.workshop.service.ProgramsToRun
import robotran.workshop.service.Services
import robotran.workshop.state.CompileStatus
import robotran.workshop.state.Pane
import robotran.workshop.state.ProgramsState
import robotran.workshop.state.Snippet
import robotran.world.World

/**
 * Holds the programs of all robots in a world, as written by the pupil, and their compile results.
 *
 * The first robot of the initial project gets the square program if it has none.
 */
class ProgramsStateHolder private constructor(
    // What does not depend on what is on the screen.
    private val all: AllPrograms,
    private val services: Services,
) : ProgramsToRun,
    ProgramsOfRobots by all {
    constructor(project: Project, services: Services, roomInFile: () -> Int = { Int.MAX_VALUE }) :
        this(AllPrograms(project, services, roomInFile), services)

    private val preferences = services.preferences
    private var translationShown = false
    private var lastTranslation: ShownLanguage? = null
    private var searchRequested = false
    private val shown: RobotPrograms get() = all.shown
    private val compileScheduler = CompileScheduler()
    private val editing = ProgramEditing(preferences, services.navigator, services.notices, all::hasRoom)
    private val otherBrick = OtherBrickFinder()
    private val quotes = QuotesInBlocks()
    private var lastStatus = CompileStatus.DONE

    var state: ProgramsState by mutableStateOf(stateNow())
        private set

    init {
        changed()
    }

    fun handle(event: ProgramEvent) {
        if (event is ProgramEvent.RobotChosen) all.chosenRobot = event.name
        if (event is ProgramEvent.TranslationShown) {
            translationShown = event.shown
            lastTranslation = event.kind ?: lastTranslation
        }
        if (event == ProgramEvent.SearchRequested) openSearch()
        if (event == ProgramEvent.SearchOpened) searchRequested = false
        editing.handle(event, shown)
        changed()
    }

    override val shownProgram: Program get() = state.program
    override val shownRobot: String get() = state.shownRobot
    override val compileStatus: CompileStatus get() = state.compileStatus

    override fun showRobot(name: String) = handle(ProgramEvent.RobotChosen(name))

    /** Sets the breakpoints of all programs. */
    internal fun restoreBreakpoints(breakpoints: List<SavedBreakpoint>) {
        all.restoreBreakpoints(breakpoints)
        refresh()
    }

    override fun canStart(slot: Int): Boolean {
        if (!isCompiled(slot)) {
            requestCompileNow()
            refresh()
            return false
        }
        val (robot, itsSlot) = all.withErrors(slot) ?: return true
        all.chosenRobot = robot.placement.name
        editing.pointOutErrors(robot, itsSlot)
        refresh()
        return false
    }

    /** The program that does [load] alone; null if there can be none, and then the blocks say why. */
    internal fun snippet(load: DragPayload): Snippet? = all.compileSnippet(load).also { if (it == null) refresh() }

    /** Moves the caret of the shown program to [diagnostic]. */
    fun showDiagnostic(diagnostic: Diagnostic) {
        editing.pointOut(shown, diagnostic)
        refresh()
    }

    /** Shows the line [line], from 1, of the first robot's program at [index]. */
    internal fun showLine(index: Int, line: Int) {
        handle(ProgramEvent.RobotChosen(all.first.placement.name))
        handle(ProgramEvent.ProgramChosen(index))
        showDiagnostic(Diagnostic(Severity.ERROR, "", SourceRange(line, 1, 0), ""))
    }

    /** Opens the first length of the shown program if it is shown in blocks, so that a finger changes it at once. */
    fun editFirstLength() {
        val length = state.blocks?.takeIf { state.view.hasBlocks }?.program?.firstLength() ?: return
        handle(BlockEvent.CursorPut(length.cursor, length.span))
        handle(BlockEvent.DialogShown(BlockDialog.Part(length.span)))
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
        all.open(project)
        lastStatus = CompileStatus.DONE
        changed()
    }

    /** Gives the first robot exactly [programs] and shows the first. Files of the same name can be undone. */
    internal fun replacePrograms(programs: List<Program>) {
        all.chosenRobot = all.first.placement.name
        editing.replaceAll(all.first, programs)
        changed()
    }

    /** See [AllPrograms.remove]. */
    internal fun removePrograms(isMeant: (Program) -> Boolean, beginning: Program? = null) {
        all.remove(isMeant, beginning?.inWords(preferences.words))
        changed()
    }

    /** Updates the robots to those of [world], see [AllPrograms.moveTo]; one with other wheels drives for other times. */
    fun worldChanged(world: World) {
        all.moveTo(world)
        changed()
    }

    /**
     * Compiles all programs again, with diagnostics in [language], in which also the first program's note is. Blocks show
     * the words that the pupil prefers now.
     */
    fun setLanguage(language: Language) {
        all.translateFirst(language)
        useCompiler(all.compiler.withLanguage(language))
        refresh()
    }

    /** Compiles all programs again with the Java settings [java]. */
    fun runJava(java: JavaSettings) = useCompiler(all.compiler.withJava(java))

    private fun useCompiler(next: ProgramCompiler) {
        if (next === all.compiler) return
        all.useCompiler(next)
        lastStatus = CompileStatus.DONE
        changed()
    }

    /** Suspends until there is something to compile and typing pauses. */
    suspend fun awaitCompile() = compileScheduler.awaitCompile()

    override suspend fun compile() {
        services.publish(ProgramRoomEvent.CompileBegun)
        val result = resultOf { all.compileChanged() }
        lastStatus = result
        editing.programsCompiled(shown)
        // That may have changed a program.
        if (result == CompileStatus.DONE) requestCompile()
        refresh()
        services.publish(ProgramRoomEvent.Compiled(result))
    }

    /** Loads what completion and help say about Java for an NXT, if a robot needs that. Without it they offer less. */
    internal suspend fun loadHelp() {
        if (all.needsNxjHelp) nxjSources()
    }

    /** The programs may have changed. */
    private fun changed() {
        requestCompile()
        if (editing.waitsForCompiler) requestCompileNow()
        refresh()
    }

    private fun requestCompile() {
        if (all.robots.none { it.list.hasPending }) return
        lastStatus = CompileStatus.WAITING
        compileScheduler.requestCompile(all.robots.sumOf { it.list.pendingCharacters })
    }

    private fun requestCompileNow() {
        lastStatus = CompileStatus.COMPILING
        compileScheduler.requestCompileNow()
    }

    private fun openSearch() {
        searchRequested = true
        services.navigator.show(Pane.PROGRAM)
    }

    /** The brick that the shown program of [robot] is for, if its compiler has refused it for that. */
    private fun otherBrickOf(robot: RobotPrograms): BrickKind? =
        if (robot.entry.diagnostics.isEmpty()) null else otherBrick.find(robot.entry.program, robot.brick)

    private fun refresh() {
        shown.change(shown.editorState, preferences)
        state = stateNow()
    }

    private fun stateNow(): ProgramsState {
        val robot = shown
        val entry = robot.entry
        val support = entry.program.language.support
        val kinds = support.translations(robot.brick)
        val kind = lastTranslation.takeIf { it in kinds } ?: kinds.firstOrNull()
        val view = if (support.hasBlocks) robot.editorState.view else ProgramView.TEXT
        val notes = if (view.hasBlocks) quotes.notes(robot, preferences.words) else entry.notes
        return ProgramsState(
            robots = all.robots.map { it.placement },
            shownRobot = robot.placement.name,
            isWorldsOwn = robot.isUntouched && !robot.isBlank,
            programs = robot.list.programs,
            shownProgram = robot.shownProgram,
            shownFile = robot.shownFile,
            draft = robot.editorState.draft,
            canUndo = robot.editorState.history.canUndo,
            canRedo = robot.editorState.history.canRedo,
            breakpoints = robot.editorState.breakpoints,
            view = view,
            blocks = robot.editorState.blocks,
            closed = robot.closed?.name,
            closedMessageShown = robot.closedMessageShown,
            canReopen = robot.canReopen,
            diagnostics = if (view.hasBlocks) entry.diagnostics.map(quotes::told) else entry.diagnostics,
            notes = notes,
            compileStatus = lastStatus,
            errorPointedOut = editing.errorPointedOut,
            translationShown = translationShown,
            translationKind = kind,
            translation = kind?.takeIf { translationShown }?.let { entry.translation(it, preferences.language) },
            isTranslated = entry.isTranslated,
            searchRequested = searchRequested,
            otherBrick = otherBrickOf(robot),
            words = preferences.words,
        )
    }
}
