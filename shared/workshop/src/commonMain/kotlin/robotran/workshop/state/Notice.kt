package robotran.workshop.state

import androidx.compose.runtime.Immutable
import robotran.language.Language
import robotran.world.RobotDescription
import robotran.world.robot.DraftError

/** A message at the bottom of the screen that stays until it is dismissed or replaced. */
@Immutable
sealed interface Notice {
    /** Whether it is an error. */
    val isError: Boolean get() = false

    /** The action it offers; null for none. */
    val action: NoticeAction? get() = null

    /** Whether it is about the open project only, so that it is over when another one is opened. */
    val isOfProject: Boolean get() = false

    /** A localised message from another source, such as the operating system. */
    data class ExternalError(val sentence: String) :
        Notice,
        Error

    /** An unexpected error occurred, but nothing was lost. */
    data object Unexpected : Notice, Error

    /** A text was rejected. The limits are in thousands of characters and of lines. */
    data class ProgramTooLong(val maxThousandCharacters: Int, val maxThousandLines: Int) :
        Notice,
        Error

    /** The program has changed at the position of a fix. */
    data object FixOutdated : Notice

    /** The program has [names] that are words of Robolang in [language]. */
    data class NamesInTheWay(val language: Language, val names: List<String>) : Notice

    /** The brick has no slot left for an example. */
    data object NoSlotForExample : Notice

    /** All slots have programs of the pupil's, so that there is none for what comes with a task. */
    data object NoSlotForTask : Notice

    /** [program] is the first opened program that did not fit into the [maxPrograms] slots. */
    data class NoSlotForProgram(val program: String, val maxPrograms: Int) :
        Notice,
        Error

    data object LogCopied : Notice

    data object LogNotCopied : Notice, Error

    data object LinkNotCopied : Notice, Error

    data class FileSaved(val name: String) : Notice

    /** A file could not be written; [reason] is the platform's error message. */
    data class FileNotSaved(val reason: String, val isFull: Boolean) :
        Notice,
        Error

    /** The device's store does not answer, so nothing was written. */
    data object StoreSilent : Notice, Error

    /** The project exceeds the max size of a project file. */
    data object ProjectTooLong : Notice, Error

    /** Another window has the file [name] open. */
    data class FileOpenElsewhere(val name: String) :
        Notice,
        Error

    /** This number of [others] was opened together with the current project; they are in My work. */
    data class MoreProjectsOpened(val others: Int) : Notice

    /** The run has no inputs that a replay could show. */
    data object ReplayEmpty : Notice

    /** A kit needs a program without errors; the first error is at [line]. */
    data class KitNeedsCorrectProgram(val line: Int) :
        Notice,
        Error

    data object CompilerMissing : Notice, Error

    /** The saved project [name] is open in another window; empty if it has no name. */
    data class ProjectOpenElsewhere(val name: String) : Notice

    /** The project [name] is open in another window, so this one begins a new project; empty if it has no name. */
    data class LastProjectOpenElsewhere(val name: String) : Notice {
        override val action: NoticeAction get() = NoticeAction.ShowProjects
    }

    /** This window's project is open in another window, so this one starts a new project. */
    data object OwnProjectOpenElsewhere : Notice

    data class ProjectUnusable(val reason: String) :
        Notice,
        Error

    data class ProjectNotDeleted(val reason: String) :
        Notice,
        Error

    /** The project [name] was restored after a crash; empty if it has no name. */
    data class ProjectRestored(val name: String) : Notice {
        override val isOfProject: Boolean get() = true
    }

    /** More projects were open when the app ended. [isRestored] is whether one was restored after a crash. */
    data class OtherProjectsOpen(val isRestored: Boolean) : Notice {
        override val action: NoticeAction get() = NoticeAction.ShowProjects
    }

    /** The previous project, with the ID [project], is saved. */
    data class EarlierProjectSaved(val project: String) : Notice {
        override val action: NoticeAction get() = NoticeAction.GoBack(project)
        override val isOfProject: Boolean get() = true
    }

    /** My work has the same assignment already, as the project with the ID [project]. */
    data class AssignmentBegunBefore(val project: String) : Notice {
        override val action: NoticeAction get() = NoticeAction.GoOn(project)
        override val isOfProject: Boolean get() = true
    }

    /** The device keeps [max] courses already. */
    data class TooManyCourses(val max: Int) :
        Notice,
        Error

    /** A course exceeds the max size of a file. */
    data object CourseTooLong : Notice, Error

    /** The world belongs to an assignment that does not allow to change it. */
    data object WorldOfAssignment : Notice

    /** The programs that the assignment began with are back. */
    data object BegunAgain : Notice {
        override val action: NoticeAction get() = NoticeAction.BeginningUndone
    }

    /** All goals of the world [title] are met. */
    data class WorldSolved(val title: String) : Notice

    /** The sensors that a program lacked are plugged in now, into [ports], as they are called on the brick, in their order. */
    data class SensorsPluggedIn(val ports: List<String>) : Notice {
        override val action: NoticeAction get() = NoticeAction.UnplugSensors
    }

    /** The robot [robot] is built as [description] says now. */
    data class RobotReplaced(val robot: String, val description: RobotDescription) : Notice {
        override val action: NoticeAction get() = NoticeAction.BringRobotBack
    }

    /** The first program runs; its numbers are there to be changed. */
    data object FirstProgramRuns : Notice {
        override val action: NoticeAction get() = NoticeAction.ChangeNumber
    }

    /** What the pupil [name] has handed in is open in the workshop, to repeat [run]; null for the pupil's own run. */
    data class HandInOpened(val name: String, val run: HandInRun?) : Notice {
        override val action: NoticeAction get() = NoticeAction.BackToHandIns
    }

    /** There is nothing to say, but what a pupil has handed in is open: the way back stays in sight. */
    data object HandInOpen : Notice {
        override val action: NoticeAction get() = NoticeAction.BackToHandIns
    }

    /** No program runs, because a robot of the world cannot be built like this. */
    data class RobotImpossible(val draft: DraftError) :
        Notice,
        Error {
        override val action: NoticeAction get() = NoticeAction.BuildOn(draft.number)
        override val isOfProject: Boolean get() = true
    }

    /** A robot that cannot be built like this is kept as a draft; no program runs until it is mended. */
    data class RobotKeptAsDraft(val draft: DraftError) : Notice {
        override val action: NoticeAction get() = NoticeAction.BuildOn(draft.number)
        override val isOfProject: Boolean get() = true
    }

    /** ESCAPE alone does not end the program of an NXT. */
    data object EscapeAlone : Notice

    /** Runs can be heard now, or [on] is false; [isMuted] is whether nothing sounds because the sound is off. */
    data class RunHeard(val on: Boolean, val isMuted: Boolean) : Notice

    /** A manual input has replaced the later part of the run. */
    data object NewBranch : Notice

    /**
     * A file was read although it is unusual, or has fields that are probably misspelt.
     *
     * @property notice what else is to be said; null for nothing.
     * @property warnings localised sentences.
     */
    data class WithWarnings(val notice: Notice?, val warnings: List<String>) : Notice {
        override val isError: Boolean get() = notice?.isError == true
        override val action: NoticeAction? get() = notice?.action
    }

    /** An error message. */
    sealed interface Error : Notice {
        override val isError: Boolean get() = true
    }
}

/** An action offered by a [Notice]. */
sealed interface NoticeAction {
    /** Shows the list of saved projects. */
    data object ShowProjects : NoticeAction

    /** Opens the saved project with the ID [project]. */
    data class GoBack(val project: String) : NoticeAction

    /** Opens the saved project with the ID [project], to go on with it. */
    data class GoOn(val project: String) : NoticeAction

    /** Shows the program, in blocks with the first length open. */
    data object ChangeNumber : NoticeAction

    /** Opens the assignment again and the hand-ins for it. */
    data object BackToHandIns : NoticeAction

    /** Brings back the programs that beginning again has replaced. */
    data object BeginningUndone : NoticeAction

    /** Takes the sensors out again that were plugged in last. */
    data object UnplugSensors : NoticeAction

    /** Opens the workbench with the robot that has the index [robot] in the world. */
    data class BuildOn(val robot: Int) : NoticeAction

    /** Brings back the robot that was replaced last. */
    data object BringRobotBack : NoticeAction
}
