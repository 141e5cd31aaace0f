package robotran.workshop.state

import androidx.compose.runtime.Immutable
import robotran.documents.FileKind
import robotran.simulation.state.SessionState
import robotran.world.World

/**
 * What a pupil made to show: a file, and what is in it.
 *
 * @property name the suggested name of the file.
 */
@Immutable
class MadeWork(val name: String, val kind: FileKind, val bytes: ByteArray, val shown: MadePicture)

/** What is seen in a [MadeWork]. */
sealed interface MadePicture {
    /** The sheet at one moment. */
    class Still(val world: World, val session: SessionState) : MadePicture

    /** The sheet at each of [states], every [frameMilliseconds]; there is at least one. */
    class Moving(val world: World, val states: List<SessionState>, val frameMilliseconds: Int) : MadePicture

    class Page(val poster: Poster) : MadePicture
}
