package robotran.workshop.state

import androidx.compose.runtime.Immutable
import robotran.documents.FileKind

/**
 * The sheet with which pupils show what they made.
 *
 * @property canRecord whether this machine can record videos.
 * @property canPrint whether it can print.
 * @property canShare whether it can hand a file to other apps.
 * @property hasRun whether there is a run to show; otherwise only the sheet as it is.
 */
@Immutable
data class ExportState(
    val step: ShowStep,
    val canRecord: Boolean,
    val canPrint: Boolean,
    val canShare: Boolean,
    val hasRun: Boolean,
)

/** A step of showing. */
sealed interface ShowStep {
    /** Choosing what to make. */
    data object Choosing : ShowStep

    /**
     * Choosing how fast a moving picture plays.
     *
     * @property speeds the choices, the slowest first; never empty.
     */
    data class ChoosingSpeed(val kind: MovingKind, val speeds: List<ShowSpeed>, val chosen: ShowSpeed) : ShowStep

    /** Making a moving picture; [progress] is 0..1. */
    data class Making(val kind: MovingKind, val progress: Float) : ShowStep

    /**
     * Choosing what is on the [poster].
     *
     * @property isDated whether it has its date.
     * @property kind the kind of its file, PNG or SVG.
     */
    data class ChoosingPoster(val poster: Poster, val isDated: Boolean, val kind: FileKind = FileKind.PNG) : ShowStep

    /**
     * Looking at what was made.
     *
     * @property savedAs the name of the file that it was saved as last; null if it was not.
     * @property error why it could not be saved, shared or printed; null if nothing went wrong.
     */
    data class Made(val work: MadeWork, val savedAs: String? = null, val error: ShowError? = null) : ShowStep

    data class Failed(val error: ShowError) : ShowStep
}

/** The kinds of moving pictures. */
enum class MovingKind {
    /** An animated GIF. */
    PICTURE,

    /** A WebM video. */
    VIDEO,
}

/**
 * The speed of a moving picture.
 *
 * @property factor how much faster than the run it is, at least 1.
 * @property seconds how long it lasts, rounded up.
 */
data class ShowSpeed(val factor: Int, val seconds: Int)

/** Why nothing was made. */
sealed interface ShowError {
    /** The animated picture would be too large to send. */
    data object TooLarge : ShowError

    /** The browser's recorder failed. */
    data object NoVideo : ShowError

    /** @property reason the platform's error message; may be empty. */
    data class NotSaved(val reason: String, val isFull: Boolean) : ShowError

    /** @property reason the platform's error message; may be empty. */
    data class NotPrinted(val reason: String) : ShowError

    data object NotShared : ShowError
}
