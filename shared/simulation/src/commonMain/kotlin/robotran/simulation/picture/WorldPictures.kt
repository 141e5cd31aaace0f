package robotran.simulation.picture

import robotran.simulation.state.SessionState
import robotran.world.World

/** Draws pictures of a world that can be saved as files. */
interface WorldPictures {
    /** The bytes of a PNG file with [world] as it stands in [state]. */
    fun png(world: World, state: SessionState): ByteArray

    /** The same as the text of an SVG file, which is the same on every platform. */
    fun svg(world: World, state: SessionState): String
}

/** Empty pictures: for tests that save none. */
object NoWorldPictures : WorldPictures {
    override fun png(world: World, state: SessionState): ByteArray = ByteArray(0)

    override fun svg(world: World, state: SessionState): String = ""
}
