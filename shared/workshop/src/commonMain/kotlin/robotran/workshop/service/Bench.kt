package robotran.workshop.service

import kotlinx.coroutines.CoroutineScope
import robotran.language.Language
import robotran.projects.Project
import robotran.projects.ProjectSettings
import robotran.simulation.state.SessionState
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.platform.Platform
import robotran.workshop.state.Notice
import robotran.workshop.state.Pane
import robotran.workshop.state.PupilProgram
import robotran.workshop.state.Settings
import robotran.world.World

/** What one pane may ask of the others. */
interface Bench {
    val platform: Platform

    /** Lives as long as the workshop; runs on the thread of the screen. */
    val scope: CoroutineScope

    /** What would be saved now: programs, world and settings; without inputs, see [replay]. */
    val project: Project

    /** The program that is shown. */
    val shownProgram: PupilProgram

    /** What makes the session that is on the desk again: [project] with what was done to the session so far and with the programs that Run has started. */
    val replay: Project

    /** What is to be seen on the desk now. */
    val session: SessionState

    /** What the app shows and does on this machine. */
    val settings: Settings

    /** What the app speaks: as the settings say, or as the machine does. */
    val language: Language

    /** Puts [project] on the desk in place of all that is there; programs and run begin afresh. */
    fun openProject(project: Project)

    /**
     * Puts [project] on the desk as a work of its own, if nothing is lost by it; what was open is kept.
     *
     * @param into the id of the kept work whose place it takes; if there is none, a new one called [name] begins.
     * @param onBegun is told the ids of the work that was left, null if nothing was changed in it, and of the one begun.
     */
    fun beginWork(name: String, project: Project, into: String?, onBegun: (left: String?, begun: String?) -> Unit)

    /** Puts the kept work [id] on the desk, if nothing is lost by it, or a new empty one if that is gone or null; then does [next]. */
    fun takeUpWork(id: String?, next: () -> Unit = {})

    /**
     * Puts the programs that are there into [world], one that comes with the app, as a work of its own, if nothing is lost by it; what was open is
     * kept, and the way back to it is offered.
     */
    fun openWorld(world: World)

    /** Puts the same robots and programs into [world]; the run begins afresh. [isAnother] says that it is not the world before as somebody has changed it. */
    fun changeWorld(world: World, isAnother: Boolean = false)

    /** From now on [world] is what would be saved, while robots still drive in the one before; [changeWorld] puts them into it. */
    fun keepWorld(world: World)

    /** Changes how the programs run; the run begins afresh. */
    fun changeProjectSettings(settings: ProjectSettings)

    /** Puts [program] behind the others, or in place of the one of the same name if [replacing], and shows it. */
    fun addProgram(program: PupilProgram, replacing: Boolean = false)

    /** Does [event] as if a person had done it. */
    fun perform(event: WorkshopEvent)

    /** Shows [notice] until it is read. */
    fun say(notice: Notice)

    /** Where there is room for one pane only, shows [pane]. */
    fun show(pane: Pane)
}
