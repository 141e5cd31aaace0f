package robotran.workshop.state

import androidx.compose.runtime.Immutable

/** One sentence at the lower edge of the screen that stays until it is read, or until another comes. */
@Immutable
sealed interface Notice {
    /** Whether something went wrong. */
    val isError: Boolean get() = false

    /** What can be done about it, null for nothing. */
    val action: NoticeAction? get() = null

    /** A sentence in the pupil's language that comes from elsewhere, such as the operating system's. */
    data class ForeignError(val sentence: String) :
        Notice,
        Error

    /** Something unexpected happened, but nothing was lost. */
    data object Unexpected : Notice, Error

    /** A text was refused; limits in thousands of characters and of lines. */
    data class ProgramTooLong(val maxThousandCharacters: Int, val maxThousandLines: Int) :
        Notice,
        Error

    /** The program has changed where a fix was to be applied. */
    data object FixOutdated : Notice

    /** The brick has no slot left for an example. */
    data object NoSlotForExample : Notice

    /** Of the programs that were opened, [program] is the first that did not fit into the [maxPrograms] slots. */
    data class NoSlotForProgram(val program: String, val maxPrograms: Int) :
        Notice,
        Error

    data object LogCopied : Notice

    data object LogNotCopied : Notice, Error

    data object LinkNotCopied : Notice, Error

    data class FileSaved(val name: String) : Notice

    /** A file could not be written; [reason] comes from the platform. */
    data class FileNotSaved(val reason: String, val isFull: Boolean) :
        Notice,
        Error

    /** The project is larger than a project file may be. */
    data object ProjectTooLong : Notice, Error

    /** Another window has the file [name] open. */
    data class FileOpenElsewhere(val name: String) :
        Notice,
        Error

    /** So many [others] were opened together with the project that is shown; they are in My work. */
    data class MoreProjectsOpened(val others: Int) : Notice

    /** Nothing was done to the run yet that a replay could show. */
    data object ReplayEmpty : Notice

    /** A kit takes a program without mistakes; the first is in [line]. */
    data class KitNeedsCorrectProgram(val line: Int) :
        Notice,
        Error

    data object CompilerMissing : Notice, Error

    /** Another window shows the saved project. */
    data object ProjectOpenElsewhere : Notice

    /** The project of this window is shown by another one, so it begins with a new one. */
    data object OwnProjectOpenElsewhere : Notice

    data class ProjectUnusable(val reason: String) :
        Notice,
        Error

    data class ProjectNotDeleted(val reason: String) :
        Notice,
        Error

    /** The project [name] came back after a crash; empty if it has no name. */
    data class ProjectRestored(val name: String) : Notice

    /** More projects were open when the app ended; [isRestored] says that one came back after a crash. */
    data class OtherProjectsOpen(val isRestored: Boolean) : Notice {
        override val action: NoticeAction get() = NoticeAction.ShowProjects
    }

    /** The project before, with the id [project], is saved. */
    data class EarlierProjectSaved(val project: String) : Notice {
        override val action: NoticeAction get() = NoticeAction.GoBack(project)
    }

    /** All goals of the world called [title] are met. */
    data class WorldSolved(val title: String) : Notice

    /** What was done by hand took the place of what came later in the run. */
    data object NewBranch : Notice

    /** What went wrong. */
    sealed interface Error : Notice {
        override val isError: Boolean get() = true
    }
}

/** What can be done about a [Notice]. */
sealed interface NoticeAction {
    /** All saved projects are shown. */
    data object ShowProjects : NoticeAction

    /** The saved project with the id [project] is opened again. */
    data class GoBack(val project: String) : NoticeAction
}
