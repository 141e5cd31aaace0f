package robotran.workshop.state

import androidx.compose.runtime.Immutable
import robotran.blockediting.BlockProgram
import robotran.language.Language
import robotran.programs.Program
import robotran.simulation.state.SessionState
import robotran.world.World

/**
 * A page that shows a drawing and the program that drew it.
 *
 * @property maker who made it, as the pupil wants; empty for nobody.
 * @property date the date in words; empty for none.
 * @property session the moment of the run that is drawn.
 * @property blocks the same program in blocks, if the pupil sees it so; otherwise null.
 * @property language the language of the few words that the page adds.
 */
@Immutable
data class Poster(
    val title: String,
    val maker: String,
    val date: String,
    val world: World,
    val session: SessionState,
    val program: Program,
    val language: Language,
    val blocks: BlockProgram? = null,
) {
    companion object {
        /** Characters of [title] and of [maker]. */
        const val MAX_TITLE = 80
        const val MAX_MAKER = 60
    }
}
